// Would catch: limits of torque that are of other joints than the scene or the URDF says, cones
// without the rows that they are about, functions that limited control lacks, and faults in any of
// these that are reported without place or remedy.
#include <gtest/gtest.h>

#include <algorithm>

#include "description/read_scene.hpp"
#include "scene_fault.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

const std::string kHand = "operational_points: [{name: hand, link: tool, rows: [x]}]\n";

std::string hold(const std::string& more) {
  return "constraints: [{name: rail, between: [rail, world], " + more + "}]\n";
}

std::optional<Scene> read(const std::string& text, Diagnostics& diagnostics) {
  static const Robot robot = make_robot();
  return parse_scene(text, "s.yaml", robot, diagnostics);
}

TEST(ReadLimits, ReadsEverySetting) {
  Diagnostics diagnostics;
  const auto scene =
      read("base: floating\n" + kHand +
               hold("friction: 0.5, sides: 8, torsional: 0.02, half_extents: [0.1, 0.04], "
                    "least_force: 3") +
               "torque_limits: {elbow: 7, slide: 20}\n",
           diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  ASSERT_EQ(scene->cones.size(), 1U);
  const SceneCone& cone = scene->cones[0];
  EXPECT_EQ(cone.constraint, "rail");
  EXPECT_EQ(cone.friction, 0.5);
  EXPECT_EQ(cone.sides, 8);
  EXPECT_EQ(cone.torsional, 0.02);
  EXPECT_EQ(cone.half_extents, (std::array{0.1, 0.04}));
  EXPECT_EQ(cone.least_force, 3);
  EXPECT_EQ(scene->torque_limits, (std::map<std::string, double>{{"elbow", 7}, {"slide", 20}}));
  for (const Function function :
       {Function::mass_matrix, Function::jacobian, Function::constraint_jacobian,
        Function::supported_control_torque}) {
    EXPECT_EQ(std::count(scene->functions.begin(), scene->functions.end(), function), 1);
  }
}

/// A URDF need not state limits of continuous joints; those that mimic and passive ones have none.
TEST(ReadLimits, TakesTheEffortsOfTheFile) {
  Diagnostics diagnostics;
  const auto scene = read("base: floating\n" + kHand + hold("friction: 0.5") +
                              "passive: [slide]\ntorque_limits: urdf\n",
                          diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_EQ(scene->torque_limits, (std::map<std::string, double>{{"elbow", 1}}));
}

TEST(ReadLimits, WithoutThemThereAreNone) {
  Diagnostics diagnostics;
  const auto scene = read("base: floating\n" + kHand + hold("rows: [x]"), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_FALSE(scene->has_limits());
  EXPECT_EQ(
      std::count(scene->functions.begin(), scene->functions.end(), Function::constraint_jacobian),
      0);
}

class LimitFaults : public testing::TestWithParam<SceneFault> {};

TEST_P(LimitFaults, NameTheFaultAndTheRemedy) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read(GetParam().text, diagnostics));
  const std::string told = to_string(diagnostics);
  EXPECT_NE(told.find(GetParam().fault), std::string::npos) << told;
  EXPECT_NE(told.find(GetParam().remedy), std::string::npos) << told;
}

INSTANTIATE_TEST_SUITE_P(
    All, LimitFaults,
    testing::Values(
        SceneFault{hold("friction: 0"), "not positive", "tangential to normal"},
        SceneFault{hold("friction: 0.5, rows: [x, y]"), "does not hold all", "add x y z"},
        SceneFault{hold("friction: 0.5, rows: [x, y, z], torsional: 0.1"), "does not hold",
                   "add rz"},
        SceneFault{hold("friction: 0.5, rows: [x, y, z], half_extents: [1, 1]"), "does not hold",
                   "add rx ry"},
        SceneFault{hold("friction: 0.5, half_extents: [1]"), "1 numbers", "[x, y]"},
        SceneFault{hold("friction: 0.5, half_extents: [1, -1]"), "not positive", "half a length"},
        SceneFault{hold("friction: 0.5, sides: 5"), "sides", "8"},
        SceneFault{hold("friction: 0.5, least_force: -1"), "negative", "cannot pull"},
        SceneFault{hold("torsional: 0.5"), "without friction", "add friction"},
        SceneFault{hold("fricton: 0.5"), "fricton", "friction"},
        SceneFault{"constraints: [{name: a, between: [tool, rail], rows: [x, y], friction: 1}]",
                   "does not hold all", "remove the key"},
        SceneFault{"torque_limits: 5\n", "neither `urdf` nor a map", "joint: N m"},
        SceneFault{"torque_limits: {}\n", "no joint is listed", "urdf"},
        SceneFault{"torque_limits: {elbw: 1}\n", "no joint \"elbw\"", "elbow"},
        SceneFault{"torque_limits: {elbow: 0}\n", "not positive", "largest torque"},
        SceneFault{"torque_limits: {follow: 1}\n", "no motor of its own", "follows"},
        SceneFault{"torque_limits: {flange: 1}\n", "one degree of freedom", "remove"},
        SceneFault{"passive: [elbow]\ntorque_limits: {elbow: 1}\n", "without a motor", "remove"},
        SceneFault{"torque_limits: {elbow: 1}\n" + kHand, "cannot have", "add constraints"},
        SceneFault{"torque_limits: {elbow: 1}\nfunctions: [supported_control_torque]\n" + kHand +
                       hold("rows: [x]"),
                   "needs mass_matrix", "add it to functions"}));

}  // namespace
}  // namespace treeline
