#include "data/list_data.hpp"
#include "fixture.hpp"
#include "program/ending.hpp"

// Compiled tasks of the centre of mass in `check`. Would catch: a function that has another point
// in its place, rounding or scales that are not those of a mean over all links, loops over links
// that take it for a frame, limits and a controller that know frames alone.

namespace treeline::tests {
namespace {

ScenePoint whole_center() {
  ScenePoint point;
  point.name = "center";
  point.center_of_mass = true;
  point.rows = {true, true, true, false, false, false};
  return point;
}

/// Every function of points but derivatives of frames.
const char* const kAllOfPoints =
    "functions: [forward_kinematics, jacobian, bias_acceleration, lambda_inverse, lambda, "
    "control_torque, point_velocity, point_acceleration, dynamically_consistent_inverse, "
    "null_space_projector, operational_bias_force, operational_gravity]\n";

/// The wrist and the centre of mass of an arm, some of whose mass is at rest.
Subjects arm(const std::string& center, const std::string& more) {
  return in_scene(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf",
                  "operational_points:\n  - {name: wrist, link: wrist_1, rows: [x, y]}\n"
                  "  - {name: center, center_of_mass: true, " +
                      center + "}\n" + more);
}

void expect_passed(const Subjects& subjects, int functions) {
  const CheckReport report = check_or_throw(subjects, quick_options(60));
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(report.functions.size(), static_cast<std::size_t>(functions));
  for (const FunctionReport& each : report.functions) EXPECT_EQ(each.bits_differ, 0) << each.name;
}

TEST(CheckCenterOfMass, OfAnArmInBothPrecisionsAndLanguages) {
  expect_passed(arm("rows: [z]", kAllOfPoints), 12);
  expect_passed(
      arm("rows: [x, z], priority: 2", std::string("real: float\nlanguage: c\n") + kAllOfPoints),
      12);
}

TEST(CheckCenterOfMass, WithMatterAsArguments) {
  expect_passed(
      arm("rows: [z]", std::string("inputs: {payload: tool, parameters: forearm, gravity: true, "
                                   "tool: wrist}\n") +
                           kAllOfPoints),
      12);
}

TEST(CheckCenterOfMass, OfAQuadrupedThatFloatsAndStands) {
  expect_passed(in_scene(data_file("published/anymal_c.urdf"),
                         "base: floating\noperational_points: [{name: center, center_of_mass: "
                         "true}]\nconstraints: [{name: foot, between: [LF_FOOT, world], rows: [x, "
                         "y, z]}]\ninputs: {active: [center]}\nfunctions: [forward_kinematics, "
                         "jacobian, control_torque, supported_control_torque]\n"),
                4);
}

// Loops know points on links alone: what needs the centre of mass stays straight lines.
TEST(CheckCenterOfMass, IsNoPointOfALoopOverLinks) {
  Subjects subjects = load_unmade("humanoid24", "scene_floating.yaml");
  subjects.scene.optimize = Optimize::size;
  subjects.scene.functions = {Function::mass_matrix, Function::lambda_inverse};
  for (const bool center : {false, true}) {
    if (center) subjects.scene.operational_points.back() = whole_center();
    for (const auto& each : generate(subjects.robot, subjects.scene).functions) {
      EXPECT_EQ(each.program.loops != nullptr, !center || each.function == Function::mass_matrix);
    }
  }
}

TEST(CheckCenterOfMass, WithinLimitsOfTorques) {
  const Subjects subjects =
      arm("rows: [z]",
          "constraints: [{name: wall, between: [tool, world], rows: [x, y, z], "
          "friction: 0.5}]\n"
          "torque_limits: urdf\nfunctions: [supported_control_torque, mass_matrix, "
          "constraint_jacobian, jacobian]\n");
  expect_passed(subjects, 4);
}

TEST(CheckCenterOfMass, LedByAController) {
  const Subjects subjects =
      arm("rows: [z], priority: 2",
          "controller: {laws: [joint_impedance, task_impedance]}\nfunctions: [jacobian]\n");
  const CheckReport report = check_or_throw(subjects, quick_options(20));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_TRUE(report.step);
  EXPECT_GT(report.step->compared, 50);
}

}  // namespace
}  // namespace treeline::tests
