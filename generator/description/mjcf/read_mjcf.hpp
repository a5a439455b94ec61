#pragma once

#include <optional>
#include <string>

#include "description/mjcf/read_bodies.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The mechanism of an MJCF model. `text` is the file's content, `path` where it is: includes and
/// meshes are looked for beside it. Faults are in `diagnostics`, with file, line and element; what
/// has a meaning for the motion and no place in a URDF is a warning, or an error where it makes
/// other bodies.
std::optional<MjcfTree> read_mjcf(const std::string& text, const std::string& path,
                                  Diagnostics& diagnostics);

}  // namespace treeline
