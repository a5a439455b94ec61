#include "data/list_data.hpp"
#include "fixture.hpp"
#include "recursion/closed_robots.hpp"

// Robots that stand, or have joints without a motor, from the file to the compiled code. Would
// catch: rows of constraints in another order than the scene's, a law that the interpreter does not
// share, and variants (batches, float, given sines, exact tasks) that these functions do not have.

namespace treeline::tests {
namespace {

void expect_right(const Subjects& subjects, std::size_t functions, int states = 24) {
  const auto report = check_or_throw(subjects, quick_options(states));
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(report.functions.size(), functions);
}

const std::string kBoth = "functions: [constrained_forward_dynamics, supported_control_torque]\n";

/// A quadruped on these feet.
Subjects quadruped_on(const std::vector<std::string>& feet) {
  std::string scene =
      "base: floating\noperational_points:\n  - {name: trunk, link: base}\nconstraints:\n";
  for (const std::string& foot : feet) {
    scene += "  - {name: " + foot + ", between: [" + foot + "_FOOT, world], rows: [x, y, z]}\n";
  }
  return in_scene(data_file("published/anymal_c.urdf"), scene + kBoth);
}

TEST(ConstraintsCheck, QuadrupedOnFourPointFeet) {
  expect_right(quadruped_on({"LF", "RF", "LH", "RH"}), 2);
}

// Two point feet leave the trunk a freedom that no motor commands.
TEST(ConstraintsCheck, QuadrupedOnADiagonal) {
  expect_right(quadruped_on({"LF", "RH"}), 2);
}

// No task and no joint that is named passive: the base alone has no motor.
TEST(ConstraintsCheck, HopperOnItsSole) {
  expect_right(
      in_scene(data_file("written/hopper.urdf"),
               "base: floating\nconstraints:\n  - {name: sole, between: [foot, world], origin: "
               "{xyz: [0, 0, -0.4]}, axes: local}\nfunctions: [supported_control_torque]\n"),
      1);
}

// Nothing is held: motors alone, while the base drifts.
TEST(ConstraintsCheck, HopperThatFloats) {
  expect_right(
      in_scene(data_file("written/hopper.urdf"),
               "base: floating\noperational_points: [{name: foot, link: foot, rows: [x]}]\n"
               "functions: [supported_control_torque]\n"),
      1);
}

// Both feet of this humanoid are on one link: twelve rows, of which six are independent.
TEST(ConstraintsCheck, HumanoidOnFeetThatDependOnEachOther) {
  expect_right(load("humanoid24", "scene_stand.yaml"), 5);
}

TEST(ConstraintsCheck, HumanoidWithTasksByPriorityThatIsPushed) {
  expect_right(in_scene(data_file("written/ball_humanoid.urdf"), R"(
base: floating
operational_points:
  - {name: left_hand, link: left_forearm, origin: {xyz: [0, 0, -0.24]}, rows: [x, y, z], priority: 2}
  - {name: trunk, link: right_forearm, rows: [x, z], axes: local}
constraints:
  - {name: left_foot, between: [left_foot, world], axes: local}
  - {name: right_foot, between: [right_foot, world], rows: [x, z, rx, ry]}
external_forces:
  - {name: push, link: right_forearm}
)" + kBoth),
               2);
}

Subjects arm(const std::string& scene_text) {
  return in_scene(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf",
                  "operational_points: [{name: tool, link: tool, rows: [x, y]}]\n" + scene_text);
}

TEST(ConstraintsCheck, ArmWithAPassiveElbowInBatchesOfFloat) {
  expect_right(
      arm("passive: [elbow]\nreal: float\nbatch: 8\nfunctions: [supported_control_torque]"), 2);
}

TEST(ConstraintsCheck, ArmAtAWallWithExactTasks) {
  expect_right(arm("constraints: [{name: wall, between: [wrist_1, world], rows: [z]}]\n"
                   "singular: exact\nsin_cos: given\n" +
                   kBoth),
               2);
}

TEST(ConstraintsCheck, FloatingArmThatHoldsNothing) {
  expect_right(arm("base: floating\npassive: [wrist_3]\nfunctions: [supported_control_torque]"), 1);
}

const std::string kLoops =
    "functions: [constrained_forward_dynamics, supported_control_torque, constraint_jacobian, "
    "constraint_errors]\n";

// With a motor at the crank alone, and no task: torque for the motion nearest to a wanted one. All
// five rows of a planar loop's hinge, of which two are independent.
TEST(LoopsCheck, FourBar) {
  expect_right(
      in_scene(data_file("written/four_bar.urdf"),
               "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: "
               "[0, 0, 0.25]}, other_origin: {xyz: [0.3, 0, 0]}, rows: [x, y, z, rx, rz]}]\n"
               "passive: [coupler_joint, rocker_joint]\n" +
                   kLoops),
      4);
}

TEST(LoopsCheck, CoupledJaw) {
  expect_right(in_scene(data_file("written/parallel_jaw.urdf"),
                        "couplings: [{name: belt, joints: {left: 1, right: -1}, offset: 0.01}]\n"
                        "operational_points: [{name: pad, link: left_finger, rows: [x, z]}]\n"
                        "passive: [right]\nlanguage: c\n" +
                            kLoops),
               4);
}

// The file closes five loops of ball joints; six slides have motors.
TEST(LoopsCheck, StewartPlatform) {
  std::string passive;
  for (const char* k : {"0", "1", "2", "3", "4", "5"}) {
    passive += std::string(passive.empty() ? "" : ", ") + "yaw_" + k + ", pitch_" + k;
  }
  expect_right(in_scene(data_file("written/stewart.urdf"),
                        "operational_points: [{name: plate, link: plate}]\npassive: [" + passive +
                            ", rim]\n" + kLoops),
               4, 6);
}

/// The robot of a closed loop in this scene, its functions by elimination if they are `named`.
std::optional<Generation> generate_closed(const Robot& robot, const Scene& scene, bool named,
                                          Diagnostics& diagnostics) {
  Choices choices;
  for (const Function function : scene.functions) {
    if (named) choices.plain[function] = {"eliminated", 0};
  }
  return generate_code(robot, scene, {"robot.urdf", "no text", "scene.yaml", "no text"},
                       diagnostics, choices);
}

void expect_right_by_elimination(const ClosedRobot& closed) {
  auto [robot, scene] = read_closed(closed);
  scene.functions.push_back(Function::supported_control_torque);
  Diagnostics diagnostics;
  auto generation = generate_closed(robot, scene, true, diagnostics);
  ASSERT_TRUE(generation);
  for (const GeneratedFunction& each : generation->functions) {
    EXPECT_EQ(each.chosen.route.algorithm, "eliminated");
  }
  expect_right({robot, scene, std::move(*generation)}, 2, 60);
}

// Drawn states come near poses where passive joints do not follow.
TEST(EliminatedLoopsCheck, FourBarInFloat) {
  ClosedRobot closed = closed_robots()[0];
  closed.scene += "real: float\n";
  expect_right_by_elimination(closed);
}

TEST(EliminatedLoopsCheck, DeltaWithABeltAndATask) {
  ClosedRobot closed = closed_robots()[4];
  closed.scene += "operational_points: [{name: hand, link: platform, rows: [y, z]}]\n";
  expect_right_by_elimination(closed);
}

/// The algorithm that is taken for the motion of a four-bar with these passive joints, on an arm
/// of so many.
std::string algorithm_with(const std::string& passive, int arm) {
  const auto [robot, scene] =
      read_closed({"four_bar", "four_bar", four_bar_scene("[x, z]", passive)}, arm);
  Diagnostics diagnostics;
  const auto generation = generate_closed(robot, scene, false, diagnostics);
  return generation ? generation->functions.front().chosen.route.algorithm : "";
}

// What carries the loop makes forces dear. A driven rocker leads to poses where the crank does not
// follow.
TEST(EliminatedLoops, AreTakenUnaskedWhereTheySaveAndPassiveJointsFollow) {
  EXPECT_EQ(algorithm_with("[coupler_joint, rocker_joint]", 3), "eliminated");
  EXPECT_EQ(algorithm_with("[crank_joint, coupler_joint]", 3), "constrained/ltdl-inward");
  EXPECT_EQ(algorithm_with("[]", 3), "constrained/ltdl-inward");
  EXPECT_EQ(algorithm_with("[coupler_joint, rocker_joint]", 0), "constrained/ltdl-inward");
}

TEST(EliminatedLoops, AreRefusedInWordsWithoutPassiveJoints) {
  const auto [robot, scene] = read_closed({"four_bar", "four_bar", four_bar_scene("[x, z]", "[]")});
  Diagnostics diagnostics;
  EXPECT_FALSE(generate_closed(robot, scene, true, diagnostics));
  ASSERT_TRUE(diagnostics.has_errors());
  const std::string text = to_string(diagnostics.list().back());
  EXPECT_NE(text.find("Name under `passive` the joints that the loops determine"),
            std::string::npos)
      << text;
}

/// A floating body of 1.5 kg with the moments of a disc about y, whose contact with the world
/// rolls.
Subjects roller(const std::string& rolling, const std::string& more) {
  Diagnostics diagnostics;
  return in_scene(
      parse_urdf("<robot name='roller'><link name='body'><inertial><mass value='1.5'/><inertia "
                 "ixx='0.015' iyy='0.03' izz='0.015' ixy='0' ixz='0' iyz='0'/></inertial></link>"
                 "</robot>",
                 "roller.urdf", diagnostics),
      "base: floating\nconstraints: [{name: ground, between: [body, world], rolling: " + rolling +
          "}]\nfunctions: [constrained_forward_dynamics, constraint_jacobian, "
          "constraint_errors]\n" +
          more);
}

// Drawn states lift it, sink it and lean it any way: would catch results that are finite only
// where the contact is held.
TEST(RollingCheck, DiscOnTheGround) {
  expect_right(roller("{radius: 0.2, axis: [0, 1, 0]}", ""), 3, 60);
}

// It lies flat where all coordinates are 0, where it has no contact point.
TEST(RollingCheck, DiscThatStartsFlat) {
  expect_right(roller("{radius: 0.2, axis: [0, 0, 1]}", ""), 3, 60);
}

TEST(RollingCheck, BallOnTheGroundInC) {
  expect_right(roller("{radius: 0.2}", "language: c\n"), 3, 40);
}

TEST(RollingCheck, BallInABowlInFloat) {
  expect_right(roller("{radius: 0.2, on_radius: -1.1}", "real: float\n"), 3, 40);
}

}  // namespace
}  // namespace treeline::tests
