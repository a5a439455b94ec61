#pragma once

#include <array>
#include <optional>
#include <string>

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// A joint as the file has it: links and the mimicked joint are still names.
struct NamedJoint {
  Joint joint;
  std::string parent, child;
  std::optional<std::string> mimicked;  ///< set together with `joint.mimic`
  UrdfElement element;                  ///< for complaints about it
};

/// Reads `<joint>`. Axes are normalised; bounds that the file does not set are infinite, except
/// that a lone `lower` or `upper` has the other at 0, as the URDF specification says. A mimic on a
/// fixed or floating joint is dropped with a warning.
NamedJoint read_joint(const UrdfElement& element);

/// Reads `<axis xyz>` of a joint, or a child of another name, as a unit vector in the joint's
/// frame; x where there is none.
std::array<double, 3> read_axis(const UrdfElement& joint, const char* name = "axis");

}  // namespace treeline
