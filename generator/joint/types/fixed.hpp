#pragma once

#include "joint/joint_type_info.hpp"

namespace treeline {

/// Does not move.
inline constexpr JointTypeInfo kFixedJoint{.type = JointType::fixed,
                                           .name = "fixed",
                                           .has_axis = false,
                                           .coordinates = {},
                                           .velocities = {},
                                           .steps = {}};

}  // namespace treeline
