#pragma once

#include "joint/joint_type_info.hpp"

namespace treeline {

/// Turns about its axis within a range.
inline constexpr JointCoordinate kRevoluteCoordinates[] = {{"angle, rad", CoordinateKind::angle}};
inline constexpr const char* kRevoluteVelocities[] = {", rad/s"};
inline constexpr JointTypeStep kRevoluteSteps[] = {{{JointKind::revolute}, StepAxis::z, ""}};
inline constexpr JointTypeInfo kRevoluteJoint{.type = JointType::revolute,
                                              .name = "revolute",
                                              .has_range = true,
                                              .coordinates = kRevoluteCoordinates,
                                              .velocities = kRevoluteVelocities,
                                              .steps = kRevoluteSteps};

}  // namespace treeline
