#include "data/list_data.hpp"
#include "fixture.hpp"

// limited_control_torque of constraints and tasks that come and go, in `check`: at shares of 0, 1
// and between the program is solved again in 50 digits. Would catch: shares of other rows than the
// scene names, a variant (C, loops for safety, batches, float) that does not hand them on, cones of
// feet that are not held which bind, and a cost other than the page's.

namespace treeline::tests {
namespace {

void expect_certified(const Subjects& subjects, int states, int least) {
  const auto report = check_or_throw(subjects, quick_options(states));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_TRUE(report.limits);
  EXPECT_GE(report.limits->certified, least) << print_text(report);
  std::cout << report.limits->certified << " of " << report.limits->limited << " certified, "
            << report.limits->irregular << " irregular, worst " << report.limits->worst << " ulp, "
            << 100 * report.limits->of_bound << " % of what is allowed" << '\n';
}

/// An arm whose hand slides along a wall, touches it or does not, and may have something to do.
Subjects arm(const std::string& more) {
  return in_scene(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf",
                  "operational_points:\n  - {name: tool, link: wrist_1, rows: [x, y]}\n"
                  "  - {name: elbow, link: forearm, rows: [z], priority: 2}\n"
                  "constraints: [{name: wall, between: [tool, world], rows: [x, y, z], "
                  "friction: 0.5, least_force: 2}]\n"
                  "torque_limits: urdf\ninputs: {active: [wall, elbow]}\n" +
                      more);
}

Subjects quadruped(const std::string& active) {
  std::string scene =
      "base: floating\noperational_points:\n  - {name: trunk, link: base, rows: [z, rx, ry, rz]}\n"
      "  - {name: left, link: LF_FOOT, rows: [x, y, z]}\ntorque_limits: urdf\n"
      "inputs: {active: " +
      active + "}\nconstraints:\n";
  for (const char* foot : {"LF", "RF", "LH", "RH"}) {
    scene += "  - {name: " + std::string(foot) + ", between: [" + foot +
             "_FOOT, world], rows: [x, y, z], friction: 0.7, least_force: 5, sides: 8}\n";
  }
  return in_scene(data_file("published/anymal_c.urdf"), scene);
}

TEST(LimitedActivity, ArmAtAWallThatComesAndGoes) {
  expect_certified(arm(""), 40, 15);
}
TEST(LimitedActivity, ArmAtAWallInFloat) {
  expect_certified(arm("real: float\n"), 40, 10);
}
TEST(LimitedActivity, ArmAtAWallInC) {
  expect_certified(arm("language: c\n"), 40, 15);
}
TEST(LimitedActivity, ArmAtAWallInCodeForSafety) {
  expect_certified(arm("profile: misra\n"), 40, 15);
}

TEST(LimitedActivity, ArmAtAWallInBatches) {
  for (const char* more : {"batch: 4\n", "batch: 4\nlanguage: c\n"}) {
    const auto report = check_or_throw(arm(more), quick_options(40));
    EXPECT_TRUE(report.passed()) << print_text(report);
    ASSERT_TRUE(report.batch_limits);
    EXPECT_EQ(report.batch_limits->limited, report.limits->limited);
    EXPECT_GE(report.batch_limits->certified, 15) << print_text(report);
  }
}

// Without constraints, a task alone.
TEST(LimitedActivity, TaskThatComesAndGoesBesideAPassiveElbow) {
  expect_certified(in_scene(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf",
                            "operational_points: [{name: tool, link: tool, rows: [x, z]}]\n"
                            "passive: [elbow]\ntorque_limits: urdf\ninputs: {active: tool}\n"),
                   40, 10);
}

TEST(LimitedActivity, QuadrupedWhoseFeetComeAndGo) {
  expect_certified(quadruped("[LF, RF, LH, RH, left]"), 40, 15);
}

// Others are held all the time.
TEST(LimitedActivity, QuadrupedThatLiftsAFoot) {
  expect_certified(quadruped("[LF]"), 20, 8);
}

TEST(LimitedActivity, RefusesRowsThatDependOnEachOther) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file("published/anymal_c.urdf"), diagnostics);
  ASSERT_TRUE(robot);
  const auto scene = parse_scene(
      "base: floating\ntorque_limits: urdf\ninputs: {active: b}\nconstraints:\n"
      "  - {name: a, between: [LF_FOOT, world]}\n"
      "  - {name: b, between: [LF_FOOT, world], origin: {xyz: [0.1, 0, 0]}, rows: [z]}\n",
      "scene.yaml", *robot, diagnostics);
  ASSERT_TRUE(scene);
  EXPECT_FALSE(generate_code(*robot, *scene, {"r.urdf", "", "s.yaml", ""}, diagnostics));
  EXPECT_NE(to_string(diagnostics.list().back()).find("depend on each other"), std::string::npos);
}

}  // namespace
}  // namespace treeline::tests
