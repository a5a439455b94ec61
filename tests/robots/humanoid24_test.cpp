// Would catch: a number that is changed on one side only. The two halves mirror each other in the
// sagittal plane y = 0 to the last digit, and the middle is its own mirror image.
#include <gtest/gtest.h>

#include <string>

#include "load_robot.hpp"

namespace treeline {
namespace {

std::string mirrored(const std::string& name) {
  if (name.rfind("left_", 0) == 0) return "right_" + name.substr(5);
  if (name.rfind("right_", 0) == 0) return "left_" + name.substr(6);
  return name;
}

TEST(Humanoid24, MirrorsItsLinks) {
  const Robot robot = load_robot("humanoid24");
  for (const Link& link : robot.links) {
    const Inertial& a = *link.inertial;
    const Inertial& b = *find_link(robot, mirrored(link.name)).inertial;
    EXPECT_EQ(a.mass, b.mass) << link.name;
    EXPECT_EQ(a.origin.xyz[0], b.origin.xyz[0]) << link.name;
    EXPECT_EQ(a.origin.xyz[1], -b.origin.xyz[1]) << link.name;
    EXPECT_EQ(a.origin.xyz[2], b.origin.xyz[2]) << link.name;
    EXPECT_EQ(a.ixx, b.ixx) << link.name;
    EXPECT_EQ(a.iyy, b.iyy) << link.name;
    EXPECT_EQ(a.izz, b.izz) << link.name;
    EXPECT_EQ(a.ixz, b.ixz) << link.name;
    EXPECT_EQ(a.ixy, -b.ixy) << link.name;
    EXPECT_EQ(a.iyz, -b.iyz) << link.name;
  }
}

/// Mirroring keeps rotations about y and reverses those about x and z.
TEST(Humanoid24, MirrorsItsJoints) {
  const Robot robot = load_robot("humanoid24");
  for (const Link& link : robot.links) {
    if (link.name == "foot") continue;
    const Joint& a = find_joint_of(robot, link.name);
    const Joint& b = find_joint_of(robot, mirrored(link.name));
    EXPECT_EQ(b.name, mirrored(a.name));
    EXPECT_EQ(a.axis, b.axis) << a.name;
    EXPECT_EQ(a.origin.xyz[0], b.origin.xyz[0]) << a.name;
    EXPECT_EQ(a.origin.xyz[1], -b.origin.xyz[1]) << a.name;
    EXPECT_EQ(a.origin.xyz[2], b.origin.xyz[2]) << a.name;
    const bool same = a.axis[1] == 1;
    EXPECT_EQ(a.limits->lower, same ? b.limits->lower.value() : -b.limits->upper) << a.name;
    EXPECT_EQ(a.limits->upper, same ? b.limits->upper.value() : -b.limits->lower) << a.name;
    EXPECT_EQ(a.limits->effort, b.limits->effort) << a.name;
    EXPECT_EQ(a.limits->velocity, b.limits->velocity) << a.name;
  }
}

/// calf 1, thigh 1, hip 1, chest 3, arms 3 + 1 + 3 each, neck, head and two eyes, in this order.
TEST(Humanoid24, HasItsJointsInOrder) {
  const Robot robot = load_robot("humanoid24");
  std::string order;
  for (const auto& body : model_from_robot<double>(robot, Scene{}).bodies) order += body.name + " ";
  EXPECT_EQ(order,
            "foot calf thigh hip chest1 chest2 chest3 "
            "left_shoulder1 left_shoulder2 left_upperarm left_lowerarm left_wrist1 left_wrist2 "
            "left_hand right_shoulder1 right_shoulder2 right_upperarm right_lowerarm right_wrist1 "
            "right_wrist2 right_hand neck head left_eye right_eye ");
}

}  // namespace
}  // namespace treeline
