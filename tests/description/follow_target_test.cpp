// Would catch: a target that is read and then ignored, lanes of the author that it overrides, and
// emulated numbers that nobody is told of.
#include "description/follow_target.hpp"

#include <gtest/gtest.h>

#include "description/read_scene.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

Scene read_with_target(const std::string& text) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(text, "s.yaml", make_robot(), diagnostics);
  EXPECT_TRUE(scene) << to_string(diagnostics);
  return scene.value_or(Scene{});
}

Diagnostics warnings_of(const std::string& text) {
  Diagnostics diagnostics;
  warn_of_target(read_with_target(text), diagnostics);
  return diagnostics;
}

TEST(FollowTarget, SetsLanesUnlessChosen) {
  EXPECT_EQ(read_with_target("").target, "generic");
  EXPECT_EQ(read_with_target("").lanes, 8);
  EXPECT_EQ(read_with_target("target: cortex-m7").target, "cortex-m7");
  EXPECT_EQ(read_with_target("target: cortex-m7").lanes, 1);
  EXPECT_EQ(read_with_target("target: aarch64").lanes, 2);
  EXPECT_EQ(read_with_target("{target: aarch64, real: float}").lanes, 4);
  EXPECT_EQ(read_with_target("{target: aarch64, lanes: 1}").lanes, 1);
}

TEST(FollowTarget, FollowsAnotherReal) {
  Scene scene = read_with_target("target: x86-64-v3");
  EXPECT_EQ(scene.lanes, 4);
  scene.real = Real::float32;
  follow_target(scene);
  EXPECT_EQ(scene.lanes, 8);
}

TEST(FollowTarget, RefusesUnknownNames) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_scene("target: cortex-m77", "s.yaml", make_robot(), diagnostics));
  EXPECT_NE(to_string(diagnostics).find("cortex-m7"), std::string::npos) << to_string(diagnostics);
}

TEST(FollowTarget, MisraIsScalar) {
  EXPECT_EQ(read_with_target("language: c").lanes, 8);
  EXPECT_EQ(read_with_target("profile: misra").lanes, 1);
  EXPECT_EQ(read_with_target("{profile: misra, target: x86-64-v4}").lanes, 1);
  EXPECT_EQ(read_with_target("profile: plain").lanes, 8);
}

// A work item computes one number at a time. Lanes that are asked for are left to be refused.
TEST(FollowTarget, OpenClIsScalar) {
  EXPECT_EQ(read_with_target("language: opencl").lanes, 1);
  EXPECT_EQ(read_with_target("{language: opencl, lanes: 4}").lanes, 4);
}

TEST(FollowTarget, WarnsOfEmulationAndOfLanes) {
  EXPECT_TRUE(warnings_of("real: double").list().empty());
  EXPECT_TRUE(warnings_of("{target: cortex-m4f, real: float}").list().empty());
  EXPECT_TRUE(warnings_of("{target: cortex-m7, real: double}").list().empty());
  const std::string emulated = to_string(warnings_of("{target: cortex-m4f, real: double}"));
  EXPECT_NE(emulated.find("no instructions for double"), std::string::npos) << emulated;
  EXPECT_NE(emulated.find("write real: float"), std::string::npos) << emulated;
  const std::string soft = to_string(warnings_of("{target: cortex-m0, real: float}"));
  EXPECT_NE(soft.find("no instructions for float"), std::string::npos) << soft;
  EXPECT_EQ(soft.find("write real: float"), std::string::npos) << soft;
  const std::string lanes = to_string(warnings_of("{target: cortex-m7, lanes: 4}"));
  EXPECT_NE(lanes.find("4 lanes"), std::string::npos) << lanes;
}

}  // namespace
}  // namespace treeline
