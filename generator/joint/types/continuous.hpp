#pragma once

#include "joint/joint_type_info.hpp"

namespace treeline {

/// Turns about its axis without end.
inline constexpr JointCoordinate kContinuousCoordinates[] = {{"angle, rad", CoordinateKind::angle}};
inline constexpr const char* kContinuousVelocities[] = {", rad/s"};
inline constexpr JointTypeStep kContinuousSteps[] = {{{JointKind::revolute}, StepAxis::z, ""}};
inline constexpr JointTypeInfo kContinuousJoint{.type = JointType::continuous,
                                                .name = "continuous",
                                                .coordinates = kContinuousCoordinates,
                                                .velocities = kContinuousVelocities,
                                                .steps = kContinuousSteps};

}  // namespace treeline
