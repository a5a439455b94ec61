#pragma once

#include <vector>

#include "description/read_joint.hpp"

namespace treeline {

/// Narrows the limits of position and speed of each joint that others follow, so that these stay
/// within theirs: q = multiplier q_leader + offset. Warns where a follower permits less than its
/// leader's own limits, and leaves out a range that has no position in common with them. A
/// follower's effort limits no motor, for it has none.
void fold_follower_limits(const std::vector<NamedJoint>& joints, Robot& robot);

}  // namespace treeline
