#include <gtest/gtest.h>

#include <algorithm>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/sample_robots.hpp"

// Which joints may use sines of q + offset. Would catch: a joint without limits whose offset stays
// in the angle, where it costs digits, and a joint with limits that pays without need.
// invariance_test checks that the equations stay the same.

namespace treeline::tests {
namespace {

/// Three skew axes, so that frames are rotated by irregular angles. The first joint rotates without
/// limits, the second within limits, the third up to two turns.
Robot skew_arm() {
  Robot robot = sample_robot(
      {{"free", "base", JointType::continuous, {0, 0, 1}, {{0, 0, 0.3}, {0.2, 0.3, 0.4}}},
       {"elbow", "free_link", JointType::revolute, {0, 0, 1}, {{0.3, 0.1, 0}, {0.9, 0.2, 0.7}}},
       {"wrist", "elbow_link", JointType::revolute, {0, 0, 1}, {{0, 0.2, 0.1}, {0.4, 1, 0.6}}},
       {"hand", "wrist_link", JointType::revolute, {0, 0, 1}, {{0.1, 0.2, 0.1}, {1.4, 1, 0.6}}}});
  const auto limit = [&](const char* joint, double upper) {
    joint_named(robot, joint).limits = Limits{.lower = -upper, .upper = upper};
  };
  limit("elbow", 3);
  limit("wrist", 12);
  limit("hand", 2);
  return robot;
}

Mechanism reduced(Accuracy accuracy) {
  Scene scene;
  scene.accuracy = accuracy;
  return reduced_mechanism(skew_arm(), scene);
}

bool has_offset(const Mechanism& mechanism, const std::string& joint) {
  return std::any_of(mechanism.links.begin(), mechanism.links.end(), [&](const MovingLink& link) {
    return link.joint == joint && link.offset != 0;
  });
}

TEST(KeepAngles, FastestTurnsFramesForNothing) {
  const Mechanism mechanism = reduced(Accuracy::fastest);
  for (const char* joint : {"elbow", "wrist", "hand"}) {
    EXPECT_TRUE(has_offset(mechanism, joint)) << joint;
  }
}

TEST(KeepAngles, BalancedLooksAtLimits) {
  const Mechanism mechanism = reduced(Accuracy::balanced);
  EXPECT_FALSE(has_offset(mechanism, "free"));
  EXPECT_TRUE(has_offset(mechanism, "elbow"));
  EXPECT_FALSE(has_offset(mechanism, "wrist"));
  EXPECT_TRUE(has_offset(mechanism, "hand"));
}

TEST(KeepAngles, BestKeepsAll) {
  const Mechanism mechanism = reduced(Accuracy::best);
  for (const MovingLink& link : mechanism.links) EXPECT_EQ(link.offset, 0) << link.name;
}

TEST(KeepAngles, SaysWhatItDid) {
  for (const auto& [accuracy, expected] :
       {std::pair{Accuracy::fastest, 0}, std::pair{Accuracy::best, 3}}) {
    const Mechanism mechanism = reduced(accuracy);
    const auto turned =
        std::count_if(mechanism.notes.begin(), mechanism.notes.end(), [](const ReductionNote& n) {
          return n.text.find("theorem of addition") != std::string::npos;
        });
    EXPECT_EQ(turned, expected);
  }
}

}  // namespace
}  // namespace treeline::tests
