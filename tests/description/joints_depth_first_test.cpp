#include <gtest/gtest.h>

#include "description/robot_queries.hpp"

// Would catch: an order that differs from that of the coordinates, a joint before the one that
// carries it, and a stack overflow in deep trees.

namespace treeline {
namespace {

/// A robot with joints given as pairs of parent and child, in the file's order.
Robot robot_of(std::size_t links, int root, const std::vector<std::pair<int, int>>& joints) {
  Robot robot;
  robot.links.resize(links);
  robot.root = root;
  for (const auto& [parent, child] : joints) {
    Joint joint;
    joint.parent = parent;
    joint.child = child;
    robot.joints.push_back(joint);
  }
  return robot;
}

TEST(JointsDepthFirst, ChildrenInTheOrderOfTheFile) {
  //      2
  //    0   3
  //  4  1    5
  const Robot robot = robot_of(6, 2, {{3, 5}, {2, 0}, {0, 4}, {2, 3}, {0, 1}});
  EXPECT_EQ(joints_depth_first(robot), (std::vector<int>{1, 2, 4, 3, 0}));
}

TEST(JointsDepthFirst, OfALinkAlone) {
  EXPECT_EQ(joints_depth_first(robot_of(1, 0, {})), std::vector<int>{});
}

TEST(JointsDepthFirst, OfAMillionLinksInARow) {
  constexpr int kLinks = 1'000'000;
  std::vector<std::pair<int, int>> joints;
  for (int i = kLinks - 1; i > 0; --i) joints.emplace_back(i - 1, i);
  const std::vector<int> order = joints_depth_first(robot_of(kLinks, 0, joints));
  ASSERT_EQ(order.size(), joints.size());
  EXPECT_EQ(order.front(), kLinks - 2);
  EXPECT_EQ(order.back(), 0);
}

}  // namespace
}  // namespace treeline
