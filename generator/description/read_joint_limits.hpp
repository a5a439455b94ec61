#pragma once

#include <optional>

#include "description/limit.hpp"
#include "description/urdf_element.hpp"
#include "joint/joint_type.hpp"

namespace treeline {

/// The limits of a joint, from its `<limit>`; nothing where there is none. What exporters write for
/// a limit that nobody has filled in is implausible: an effort or a speed of 0, below 0 or beyond
/// what anything reaches, a range whose ends are the same, exchanged or out of reach.
/// `warn_of_limits` names these once. A limit that the file lacks is told here.
std::optional<Limits> read_joint_limits(const UrdfElement& joint, JointType type);

}  // namespace treeline
