#pragma once

#include <vector>

#include "description/read_joint.hpp"

namespace treeline {

/// Gives each mimic joint of the robot the joint that it follows in the end, with the multipliers
/// and offsets of a chain of mimics put together. False, with errors, when a name is unknown, the
/// chain closes on itself, or the joint followed has not one degree of freedom.
bool resolve_mimics(const std::vector<NamedJoint>& joints, Robot& robot);

}  // namespace treeline
