#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "description/robot.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Straight-line code for more links than this would serve nobody; the bound also keeps recursive
/// destructors in the libraries off the end of the stack. Several robots in a scene share it, with
/// the world among them.
inline constexpr std::size_t kMostLinks = 4096;

/// Reads the URDF at `path`. Every fault is added to `diagnostics` with file, line, element and
/// remedy; nothing is returned when one of them is an error. Warnings tell what counts otherwise
/// than the file's author may think: a mass without inertia, an inertia that no body has, a joint
/// that moves nothing, an attribute that is ignored.
///
/// The file is read twice. tinyxml2 with the strict rules of this folder decides and gives the line
/// numbers. urdfdom, the reference reader, then reads the same elements and must hand over the same
/// links, joints, poses, axes and inertias. It cannot be the only reader: it drops an inertial it
/// dislikes and reports success, sees no cycle, no second parent and no zero axis, loses the file's
/// order, and refuses a limit without effort, which does not concern the dynamics.
std::optional<Robot> read_urdf(const std::string& path, Diagnostics& diagnostics);

/// Reads a URDF from text, as `read_urdf` does; `file_name` is for diagnostics only.
std::optional<Robot> parse_urdf(const std::string& text, const std::string& file_name,
                                Diagnostics& diagnostics);

}  // namespace treeline
