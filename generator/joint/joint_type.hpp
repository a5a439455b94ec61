#pragma once

#include <array>
#include <span>
#include <string_view>

#include "joint/joint_type_info.hpp"
#include "joint/types/ball.hpp"
#include "joint/types/continuous.hpp"
#include "joint/types/fixed.hpp"
#include "joint/types/floating.hpp"
#include "joint/types/planar.hpp"
#include "joint/types/prismatic.hpp"
#include "joint/types/revolute.hpp"

namespace treeline {

/// All joint types, in the order of `JointType`. A type is a file of `joint/types` and a row here.
inline constexpr std::array kJointTypes{kRevoluteJoint, kContinuousJoint, kPrismaticJoint,
                                        kFixedJoint,    kFloatingJoint,   kPlanarJoint,
                                        kBallJoint};

constexpr const JointTypeInfo& info_of(JointType type) {
  return kJointTypes[static_cast<std::size_t>(type)];
}

namespace detail {

constexpr bool joint_types_are_consistent() {
  for (std::size_t i = 0; i < kJointTypes.size(); ++i) {
    const JointTypeInfo& row = kJointTypes[i];
    int coordinates = 0, velocities = 0;
    for (const JointTypeStep& step : row.steps) {
      coordinates += step.motion.coordinates();
      velocities += step.motion.velocities();
    }
    if (row.type != static_cast<JointType>(i)) return false;
    if (coordinates != row.positions() || velocities != row.freedoms()) return false;
    if (row.has_range && !row.has_one_freedom()) return false;
  }
  return kJointTypes.size() == kJointTypeCount;
}
static_assert(joint_types_are_consistent());

}  // namespace detail

/// The type that a file calls by this name, by either of its names; nothing if there is none.
constexpr const JointTypeInfo* find_joint_type(std::string_view name) {
  for (const JointTypeInfo& row : kJointTypes) {
    if (name == row.name || (row.other_name != nullptr && name == row.other_name)) return &row;
  }
  return nullptr;
}

/// Name of a joint type in files.
constexpr const char* joint_type_name(JointType type) {
  return info_of(type).name;
}

}  // namespace treeline
