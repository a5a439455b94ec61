// Would catch: a controller that guards a joint by no limit although nobody said that it should,
// one that is refused though file and scene together state all, and a refusal that does not name
// the joint, the limit and both ways out.
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>

#include "description/read_keys.hpp"
#include "description/read_scene.hpp"
#include "diagnosed.hpp"
#include "limited_arm.hpp"

namespace treeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::string kRange = "lower='-1' upper='1' ";

struct Asked {
  std::optional<Robot> robot;
  std::optional<Scene> scene;
  Diagnostics diagnostics;
};

/// The controller of an arm of one joint, with these limits in the file and in the scene.
Asked ask(const std::string& in_file, const std::string& in_scene,
          const std::string& type = "revolute") {
  Asked asked;
  Diagnostics of_robot;
  asked.robot = parse_urdf(limited_arm(in_file, type), "arm.urdf", of_robot);
  EXPECT_TRUE(asked.robot) << to_string(of_robot);
  asked.scene = parse_scene("controller: {laws: joint_impedance, limits: {" + in_scene + "}}",
                            "s.yaml", asked.robot.value(), asked.diagnostics);
  return asked;
}

void expect_refused(const std::string& in_file, const std::string& fault,
                    const std::string& remedy) {
  SCOPED_TRACE(in_file);
  const Asked asked = ask(in_file, "");
  EXPECT_FALSE(asked.scene);
  expect_diagnosed(asked.diagnostics, "s.yaml", {Severity::error, 1, "controller", fault, remedy});
}

TEST(ControllerLimits, AreNeededOfEveryJoint) {
  expect_refused(kRange + "effort='0' velocity='2'",
                 "no limit of torque of \"turn\" (effort=0 is a placeholder)", "{torque: none}");
  expect_refused(kRange + "effort='-1' velocity='2'", "effort=-1", "{turn: {torque: 10}}");
  expect_refused(kRange + "effort='1e10' velocity='2'", "effort=1e+10", "{torque: none}");
  expect_refused(kRange + "velocity='2'", "no limit of torque of \"turn\"", "{torque: none}");
  expect_refused(kRange + "effort='2' velocity='0'",
                 "no limit of speed of \"turn\" (velocity=0 is a placeholder)", "{speed: none}");
  expect_refused(kRange + "effort='2' velocity='1e8'", "velocity=1e+08", "{turn: {speed: 1}}");
  expect_refused(kRange + "effort='2' velocity='inf'", "no limit of speed", "{speed: none}");
  expect_refused("effort='2' velocity='2'", "no range of positions of \"turn\"",
                 "{lower: none, upper: none}");
  expect_refused("lower='1' upper='-1' effort='2' velocity='2'",
                 "no range of positions of \"turn\" (lower=1 upper=-1 is a placeholder)",
                 "{turn: {lower: -1, upper: 1}}");
  expect_refused("lower='0' upper='0' effort='2' velocity='2'", "lower=0 upper=0", "none");
  expect_refused("lower='-1e9' upper='1' effort='2' velocity='2'", "(lower=-1e+09 is", "none");
  expect_refused("", "no limit of torque", "{torque: none}");
  expect_refused("", "no limit of speed", "{speed: none}");
  expect_refused("", "no range of positions", "{lower: none, upper: none}");
}

TEST(ControllerLimits, AreThoseOfTheFileWhereTheSceneSaysNothing) {
  const Asked asked = ask(kRange + "effort='3' velocity='2'", "");
  ASSERT_TRUE(asked.scene) << to_string(asked.diagnostics);
  const Limits limits = limits_in_controller(asked.robot->joints.front(), *asked.scene->controller);
  EXPECT_EQ(limits.lower.value(), -1);
  EXPECT_EQ(limits.upper.value(), 1);
  EXPECT_EQ(limits.velocity.value(), 2);
  EXPECT_EQ(limits.effort.value(), 3);
}

TEST(ControllerLimits, AreStatedOrWaivedByName) {
  const Asked asked = ask("lower='0' upper='0' effort='0' velocity='0'",
                          "turn: {lower: -2, upper: none, speed: 7, torque: none}");
  ASSERT_TRUE(asked.scene) << to_string(asked.diagnostics);
  const Limits limits = limits_in_controller(asked.robot->joints.front(), *asked.scene->controller);
  EXPECT_EQ(limits.lower.value(), -2);
  EXPECT_EQ(limits.upper.value(), kInfinity);
  EXPECT_EQ(limits.velocity.value(), 7);
  EXPECT_EQ(limits.effort.value(), kInfinity);
}

TEST(ControllerLimits, AreNotHalfARange) {
  EXPECT_FALSE(ask("effort='1' velocity='1'", "turn: {lower: -1}").scene);
  EXPECT_TRUE(ask("effort='1' velocity='1'", "turn: {lower: -1, upper: none}").scene);
}

TEST(ControllerLimits, LeaveAPositionBetweenThem) {
  const Asked asked = ask(kRange + "effort='1' velocity='1'", "turn: {lower: 2}");
  EXPECT_FALSE(asked.scene);
  expect_diagnosed(asked.diagnostics, "s.yaml",
                   {Severity::error, 1, "controller",
                    "empty range of \"turn\": lower, 2, is not below upper, 1", "state both"});
}

TEST(ControllerLimits, OfJointsWithoutEndsAreSpeedAndTorque) {
  EXPECT_TRUE(ask("effort='5' velocity='10'", "", "continuous").scene);
  EXPECT_FALSE(ask("", "", "continuous").scene);
  EXPECT_TRUE(ask("", "turn: {speed: 1, torque: none}", "continuous").scene);
}

TEST(ControllerLimits, AreWaivedByOneWord) {
  for (const char* wrong :
       {"turn: {torque: nothing}", "turn: {torque: .inf}", "turn: none", "tern: {torque: none}"}) {
    EXPECT_FALSE(ask(kRange + "effort='0' velocity='1'", wrong).scene) << wrong;
  }
}

TEST(ControllerLimits, OfFollowersAreTheirLeaders) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(led_arm(kRange + "effort='1' velocity='1'",
                                        "lower='0' upper='0' effort='0' velocity='0'", "1", "0"),
                                "arm.urdf", diagnostics);
  ASSERT_TRUE(robot);
  EXPECT_TRUE(parse_scene("controller: {laws: joint_impedance}", "s.yaml", *robot, diagnostics))
      << to_string(diagnostics);
}

}  // namespace
}  // namespace treeline
