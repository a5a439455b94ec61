#include <fmt/format.h>
#include <gtest/gtest.h>

#include "description/read_urdf.hpp"
#include "inspect/inspect_robot.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"

// The deepest tree that is accepted, all of it in one row. Would catch: a recursion from link to
// link. Some thousand stack frames with numbers of 50 digits overflow the stack.

namespace treeline {
namespace {

constexpr int kMostLinks = 4096;  // that are read

/// Links in a row, the last of them on a revolute joint.
Robot deep_robot(int links) {
  std::string text = "<robot name='deep'><link name='l0'/>";
  for (int i = 1; i < links; ++i) {
    const bool last = i + 1 == links;
    text += fmt::format(
        "<link name='l{0}'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' "
        "iyz='0' izz='1'/></inertial></link><joint name='j{0}' type='{1}'><parent link='l{2}'/>"
        "<child link='l{0}'/><origin xyz='0 0 0.001' rpy='0 0.1 0'/></joint>",
        i, last ? "continuous" : "fixed", i - 1);
  }
  Diagnostics diagnostics;
  return parse_urdf(text + "</robot>", "deep.urdf", diagnostics).value();
}

TEST(DeepTree, IsBuiltAndInspected) {
  const Robot robot = deep_robot(kMostLinks);
  const Mechanism mechanism = build_mechanism(robot, Scene{});
  ASSERT_EQ(mechanism.links.size(), 1U);
  EXPECT_EQ(mechanism.links.front().name, fmt::format("l{}", kMostLinks - 1));
  const auto model = model_from_robot<double>(robot, Scene{});
  EXPECT_EQ(model.size(), kMostLinks);
  EXPECT_EQ(model.nv, 1);
  const Report report = inspect_robot(robot, std::nullopt);
  EXPECT_EQ(report.links.back().depth, kMostLinks - 1);
  EXPECT_NEAR(report.mass, kMostLinks - 1, 1e-9);
}

}  // namespace
}  // namespace treeline
