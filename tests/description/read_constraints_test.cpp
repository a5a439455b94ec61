// Would catch: constraints that hold another link or other rows than the scene says, joints that
// are taken to have a motor, and faults in either that are reported without place or remedy.
#include <gtest/gtest.h>

#include <algorithm>

#include "description/read_scene.hpp"
#include "mechanism/build_mechanism.hpp"
#include "scene_fault.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

const std::string kHand = "operational_points: [{name: hand, link: tool, rows: [x]}]\n";
const std::string kHold =
    "constraints: [{name: rail, between: [rail, world], origin: {xyz: [0, 0, 0.1]}, rows: [x, rz], "
    "axes: local}]\n";

std::optional<Scene> read(const std::string& text, Diagnostics& diagnostics) {
  static const Robot robot = make_robot();
  return parse_scene(text, "s.yaml", robot, diagnostics);
}

bool has(const Scene& scene, Function function) {
  return std::count(scene.functions.begin(), scene.functions.end(), function) > 0;
}

TEST(ReadConstraints, ReadsEverySetting) {
  Diagnostics diagnostics;
  const auto scene = read(kHand + kHold + "passive: [elbow]\n", diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  ASSERT_EQ(scene->constraints.size(), 1U);
  const ScenePoint& held = scene->constraints[0];
  EXPECT_EQ(held.name, "rail");
  EXPECT_EQ(held.link, "rail");
  EXPECT_EQ(held.origin.xyz, (std::array{0.0, 0.0, 0.1}));
  EXPECT_EQ(held.rows, (std::array{true, false, false, false, false, true}));
  EXPECT_EQ(held.axes, Axes::local);
  EXPECT_EQ(scene->passive, std::vector<std::string>{"elbow"});
  EXPECT_TRUE(has(*scene, Function::constrained_forward_dynamics));
  EXPECT_TRUE(has(*scene, Function::supported_control_torque));
}

TEST(ReadConstraints, ReadsLoopsAndCouplings) {
  Diagnostics diagnostics;
  const auto scene = read(
      "constraints: [{name: gap, between: [tool, rail], origin: {xyz: [0, 0, 0.1]}, "
      "other_origin: {xyz: [0.2, 0, 0], rpy: [0, 0, 1]}, rows: [x, y]}]\n"
      "couplings: [{name: belt, joints: {elbow: 1, slide: -2}, offset: 0.3}]\n",
      diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_TRUE(scene->constraints.empty());
  ASSERT_EQ(scene->loops.size(), 1U);
  const ScenePoint &first = scene->loops[0].first, &second = scene->loops[0].second;
  EXPECT_EQ(first.link, "tool");
  EXPECT_EQ(first.origin.xyz, (std::array{0.0, 0.0, 0.1}));
  EXPECT_EQ(second.link, "rail");
  EXPECT_EQ(second.origin.xyz, (std::array{0.2, 0.0, 0.0}));
  EXPECT_EQ(second.origin.rpy, (std::array{0.0, 0.0, 1.0}));
  EXPECT_EQ(second.rows, (std::array{true, true, false, false, false, false}));
  ASSERT_EQ(scene->couplings.size(), 1U);
  const SceneCoupling& belt = scene->couplings[0];
  EXPECT_EQ(belt.offset, 0.3);
  ASSERT_EQ(belt.parts.size(), 2U);
  EXPECT_EQ(belt.parts[1].joint, "slide");
  EXPECT_EQ(belt.parts[1].factor, -2);
  EXPECT_TRUE(has(*scene, Function::constrained_forward_dynamics));
}

TEST(ReadConstraints, ReadsContactsByName) {
  const std::vector<std::pair<std::string, std::array<bool, 6>>> kinds{
      {"point", {true, true, true, false, false, false}},
      {"soft_finger", {true, true, true, false, false, true}},
      {"line", {true, true, true, false, true, true}},
      {"plane", {true, true, true, true, true, true}},
      {"rigid", {true, true, true, true, true, true}},
      {"frictionless_point", {false, false, true, false, false, false}},
      {"frictionless_line", {false, false, true, false, true, false}},
      {"frictionless_plane", {false, false, true, true, true, false}}};
  for (const auto& [kind, rows] : kinds) {
    Diagnostics diagnostics;
    const auto scene = read("constraints: [{name: a, between: [rail, world], contact: " + kind +
                                "}, {name: b, between: [tool, rail], contact: " + kind + "}]\n",
                            diagnostics);
    ASSERT_TRUE(scene) << to_string(diagnostics);
    EXPECT_EQ(scene->constraints[0].rows, rows) << kind;
    EXPECT_EQ(scene->loops[0].second.rows, rows) << kind;
  }
}

TEST(ReadConstraints, ReadsWhatRolls) {
  Diagnostics diagnostics;
  const auto scene = read(
      "constraints: [{name: wheel, between: [rail, world], origin: {xyz: [0, 0, 0.1]}, "
      "rolling: {radius: 0.2, axis: [0, 2, 0]}}, {name: tip, between: [tool, rail], "
      "other_origin: {xyz: [1, 0, 0]}, rolling: {radius: 0.1, on_radius: -0.5}}, "
      "{name: skid, between: [tool, world], rows: [z], rolling: {radius: 0.3}}]\n",
      diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_TRUE(scene->constraints.empty());
  ASSERT_EQ(scene->loops.size(), 3U);
  const SceneLoop& wheel = scene->loops[0];
  ASSERT_TRUE(wheel.rolling);
  EXPECT_EQ(wheel.rolling->radius, 0.2);
  EXPECT_EQ(wheel.rolling->axis, (std::array{0.0, 2.0, 0.0}));
  EXPECT_FALSE(wheel.rolling->on_radius);
  EXPECT_EQ(wheel.second.link, "world");
  EXPECT_EQ(wheel.second.rows, (std::array{true, true, true, false, false, false}));
  EXPECT_EQ(scene->loops[1].rolling->on_radius, -0.5);
  EXPECT_EQ(scene->loops[1].second.origin.xyz, (std::array{1.0, 0.0, 0.0}));
  EXPECT_EQ(scene->loops[2].second.rows, (std::array{false, false, true, false, false, false}));
}

TEST(ReadConstraints, RefusesWhatCannotRoll) {
  const auto fault_of = [](const std::string& keys) {
    Diagnostics diagnostics;
    EXPECT_FALSE(
        read("constraints: [{name: w, between: [tool, rail], " + keys + "}]\n", diagnostics))
        << keys;
    return to_string(diagnostics);
  };
  const auto expect = [&](const std::string& keys, const std::string& fault) {
    EXPECT_NE(fault_of(keys).find(fault), std::string::npos) << keys << "\n" << fault_of(keys);
  };
  expect("rolling: {}", "\"radius\" is missing");
  expect("rolling: {radius: -1}", "radius is positive");
  expect("rolling: {radius: 1, axis: [0, 0, 0]}", "no direction");
  expect("rolling: {radius: 1, axis: [0, 1, 0], on_radius: 2}", "planes alone");
  expect("rolling: {radius: 1, on_radius: 0}", "no size");
  expect("rolling: {radius: 1, on_radius: -0.9}", "not smaller than the bowl");
  expect("rolling: {radius: 1}, rows: [x, rx]", "turns about x and y");
  expect("rolling: {radius: 1, on_radius: 1}, rows: [x, y]", "normal of two balls");
  expect("rolling: {radius: 1}, contact: point", "holds other rows");
  expect("rolling: {radius: 1}, axes: local", "along the axes of the second frame");
  expect("rolling: {radius: 1}, friction: 0.5, half_extents: [1, 1]", "no extent");
  expect("rolling: {radius: 1}, friction: 0.5, rows: [x, y]", "does not hold all");
  expect("rolling: {radius: 1, on_radius: 1}, friction: 0.5", "normal of two balls");
  expect("contact: point, rows: [x]", "rows are given too");
  expect("contact: pointed", "pointed");
}

TEST(ReadConstraints, FunctionsFollowWhatIsListed) {
  Diagnostics diagnostics;
  const auto neither = read(kHand, diagnostics);
  ASSERT_TRUE(neither);
  EXPECT_FALSE(has(*neither, Function::constrained_forward_dynamics));
  EXPECT_FALSE(has(*neither, Function::supported_control_torque));
  const auto held = read(kHold, diagnostics);
  ASSERT_TRUE(held);
  EXPECT_TRUE(has(*held, Function::constrained_forward_dynamics));
  EXPECT_TRUE(has(*held, Function::supported_control_torque));
  const auto passive = read(kHand + "passive: [elbow]\n", diagnostics);
  ASSERT_TRUE(passive);
  EXPECT_FALSE(has(*passive, Function::constrained_forward_dynamics));
  EXPECT_TRUE(has(*passive, Function::supported_control_torque));
  const auto floating = read("base: floating\n" + kHand, diagnostics);
  ASSERT_TRUE(floating);
  EXPECT_FALSE(has(*floating, Function::supported_control_torque));
}

// The freedoms of a floating base have no motor, without being named.
TEST(ReadConstraints, MotorsMoveWhatStandsOrFloats) {
  const std::string wanted = "functions: [supported_control_torque]\n";
  for (const std::string& scene : {kHold, "base: floating\n" + kHold, "base: floating\n" + kHand}) {
    Diagnostics diagnostics;
    EXPECT_TRUE(read(scene + wanted, diagnostics)) << scene << to_string(diagnostics);
  }
}

TEST(ReadConstraints, PassiveVelocitiesAreThoseOfTheBaseAndOfNamedJoints) {
  Diagnostics diagnostics;
  const Robot robot = make_robot();
  const auto scene = parse_scene("base: floating\npassive: [slide, shoulder]\n" + kHold, "s.yaml",
                                 robot, diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  // Base, shoulder, elbow, slide; the joint that follows slide has no velocity of its own.
  EXPECT_EQ(build_mechanism(robot, *scene).passive, (std::vector{0, 1, 2, 3, 4, 5, 6, 8}));
}

class ConstraintFaults : public testing::TestWithParam<SceneFault> {};

TEST_P(ConstraintFaults, NameTheFaultAndTheRemedy) {
  Diagnostics diagnostics;
  read(GetParam().text, diagnostics);
  const std::string told = to_string(diagnostics);
  EXPECT_NE(told.find(GetParam().fault), std::string::npos) << told;
  EXPECT_NE(told.find(GetParam().remedy), std::string::npos) << told;
}

INSTANTIATE_TEST_SUITE_P(
    All, ConstraintFaults,
    testing::Values(
        SceneFault{"constraints: [{name: a}]", "\"between\" is missing", "between: [link, world]"},
        SceneFault{"constraints: [{name: a, between: [tool]}]", "two things are held",
                   "other link]"},
        SceneFault{"constraints: [{name: a, between: [world, tool]}]", "world comes second",
                   "the link first"},
        SceneFault{"constraints: [{name: a, between: [tool, ral]}]", "no link \"ral\"", "rail"},
        SceneFault{"constraints: [{name: a, between: [tool, tool]}]",
                   "no joint moves against each other", "joints that move between"},
        SceneFault{"constraints: [{name: a, between: [tool, rail], axes: world}]",
                   "axes of the second", "turn other_origin"},
        SceneFault{
            "constraints: [{name: a, between: [tool, world], other_origin: {xyz: [0, 0, 1]}}]",
            "the world's frame", "leave out other_origin"},
        SceneFault{"couplings: [{name: a}]", "\"joints\" is missing", "factor"},
        SceneFault{"couplings: [{name: a, joints: {}}]", "has no joint", "joint: factor"},
        SceneFault{"couplings: [{name: a, joints: {elbw: 1}}]", "no joint \"elbw\"", "elbow"},
        SceneFault{"couplings: [{name: a, joints: {follow: 1}}]", "no velocity of its own",
                   "slide"},
        SceneFault{"couplings: [{name: a, joints: {flange: 1}}]", "one degree of freedom",
                   "remove"},
        SceneFault{"couplings: [{name: a, joints: {elbow: 0}}]", "factor is 0", "remove"},
        SceneFault{"constraints: [{name: a, between: [tool, world]}]\n"
                   "couplings: [{name: a, joints: {elbow: 1}}]",
                   "already taken", "name of its own"},
        SceneFault{"constraints: [{name: a, between: [tol, world]}]", "no link \"tol\"", "tool"},
        SceneFault{"constraints: [{name: a, between: [tool, world], link: tool}]", "link", "keys"},
        SceneFault{"constraints: [{name: a, between: [base, world]}]", "cannot move", "floating"},
        SceneFault{"functions: [constrained_forward_dynamics]", "nothing is held", "constraints"},
        SceneFault{"functions: [supported_control_torque]",
                   "nothing is held, and there is no operational point", "add constraints"},
        SceneFault{kHand + "functions: [supported_control_torque]",
                   "nothing is held, and every joint has a motor", "passive joints"},
        SceneFault{"torque_limits: {elbow: 1}",
                   "nothing is held, and there is no operational point", "add constraints"},
        SceneFault{
            "constraints: [{name: a, between: [rail, world]}]\nfunctions: [constraint_errors]",
            "between two links", "remove"},
        SceneFault{"constraints: [{name: a, between: [tool, world]}]\nfunctions: [gravity]",
                   "no function takes them", "supported_control_torque"},
        SceneFault{"passive: [elbw]", "no joint \"elbw\"", "elbow"},
        SceneFault{"passive: [follow]", "no motor of its own", "slide"},
        SceneFault{"passive: [flange]", "does not move", "remove"},
        SceneFault{"locked: {elbow: 0}\npassive: [elbow]", "does not move", "remove"},
        SceneFault{"passive: [elbow, elbow]", "twice", "once"}));

}  // namespace
}  // namespace treeline
