#pragma once

#include "joint/joint_type_info.hpp"

namespace treeline {

/// Slides along its axis within a range.
inline constexpr JointCoordinate kPrismaticCoordinates[] = {
    {"displacement, m", CoordinateKind::displacement}};
inline constexpr const char* kPrismaticVelocities[] = {", m/s"};
inline constexpr JointTypeStep kPrismaticSteps[] = {{{JointKind::prismatic}, StepAxis::z, ""}};
inline constexpr JointTypeInfo kPrismaticJoint{.type = JointType::prismatic,
                                               .name = "prismatic",
                                               .has_range = true,
                                               .coordinates = kPrismaticCoordinates,
                                               .velocities = kPrismaticVelocities,
                                               .steps = kPrismaticSteps};

}  // namespace treeline
