// Would catch: a report that disagrees with the robot, its masses or its numbering. The figures are
// computed by hand from the sample's.
#include "inspect/inspect_robot.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "description/inertias.hpp"
#include "sample.hpp"

namespace treeline {
namespace {

TEST(InspectRobot, CountsMassesAndCoordinates) {
  const Report report = inspect_sample();
  EXPECT_EQ(report.nq, 2);
  EXPECT_EQ(report.nv, 2);
  EXPECT_EQ(report.mass, 14);
  EXPECT_EQ(report.moving_mass, 12);
  // upper at 0.5, tool at 1, right at its offset of 0.1
  EXPECT_NEAR(report.com[0], (3 * 0.5 + 1 * 1.0 + 4 * 0.1) / 14, 1e-15);
  EXPECT_EQ(report.com[1], 0);
}

TEST(InspectRobot, ListsLinksDepthFirst) {
  const Report report = inspect_sample();
  ASSERT_EQ(report.links.size(), 5U);
  EXPECT_EQ(report.links[1].name, "upper");
  EXPECT_EQ(report.links[2].name, "tool");
  EXPECT_EQ(report.links[2].depth, 2);
  EXPECT_EQ(report.links[2].parent, 1);
  EXPECT_EQ(report.links[2].lumped_with, "upper");
  EXPECT_EQ(report.links[3].name, "left");
  EXPECT_FALSE(report.links[0].moves);
  EXPECT_TRUE(report.links[1].moves);
  EXPECT_TRUE(report.links[1].unphysical);
  EXPECT_FALSE(report.links[2].unphysical);
  EXPECT_EQ(report.links[1].moments, (std::array{0.1, 0.1, 0.4}));
}

TEST(InspectRobot, NumbersJointsWithTheirLimits) {
  const Report report = inspect_sample();
  ASSERT_EQ(report.joints.size(), 3U);
  const JointReport& arm = report.joints[0];
  EXPECT_EQ(arm.lower, -1);
  EXPECT_EQ(arm.upper, 2);
  EXPECT_EQ(arm.effort, 3);
  EXPECT_EQ(arm.velocity, 4);
  EXPECT_EQ(arm.unit, "rad");
  EXPECT_EQ(report.joints[1].q, 1);
  EXPECT_TRUE(std::isinf(report.joints[1].upper));
  EXPECT_EQ(report.joints[2].q, 1);
  EXPECT_EQ(report.joints[2].follows, "-0.5 * slide + 0.1");
}

TEST(InspectRobot, ConditionsTheMassMatrix) {
  const auto M = inspect_sample().mass_matrix.value();
  // arm: 0.4 + 3 0.5^2 + 0.1 + 1 1^2; slide: 4 + 0.5^2 4
  const double arm = 2.25, slide = 5;
  EXPECT_NEAR(M.diagonal[0], arm, 1e-14);
  EXPECT_NEAR(M.diagonal[1], slide, 1e-14);
  EXPECT_NEAR(M.least, arm, 1e-14);
  EXPECT_NEAR(M.largest, slide, 1e-14);
  EXPECT_NEAR(M.condition, slide / arm, 1e-14);
  EXPECT_NEAR(M.scaled_condition, 1, 1e-14);
}

TEST(InspectRobot, SaysWhatWasReduced) {
  const Report report = inspect_sample();
  ASSERT_EQ(report.reductions.size(), 3U);
  EXPECT_EQ(report.reductions[0].link, "upper");
  EXPECT_EQ(report.reductions[0].mass_before, 4);
  EXPECT_LT(report.reductions[0].numbers_after, report.reductions[0].numbers_before);
  const auto lumped = [](const NoteReport& n) { return n.step == "lump" && n.link == "tool"; };
  EXPECT_TRUE(std::any_of(report.notes.begin(), report.notes.end(), lumped));
}

TEST(InspectRobot, FollowsTheScene) {
  const Report report = inspect_sample(
      "base: floating\nlocked: {slide: 0.2}\n"
      "operational_points: [{name: tip, link: tool, rows: [x, rz]}]");
  EXPECT_EQ(report.base, "floating");
  EXPECT_EQ(report.scene, "sample.yaml");
  EXPECT_EQ(report.nq, 8);
  EXPECT_EQ(report.nv, 7);
  EXPECT_EQ(report.moving_mass, 14);
  ASSERT_EQ(report.joints.size(), 2U);
  EXPECT_EQ(report.joints[1].q, 7);
  EXPECT_EQ(report.joints[1].v, 6);
  EXPECT_EQ(report.links[3].motion, "locked at 0.2 m");
  EXPECT_EQ(report.links[4].motion, "locked at 0 m");
  EXPECT_EQ(report.links[4].lumped_with, "base");
  ASSERT_EQ(report.operational_points.size(), 1U);
  EXPECT_EQ(report.operational_points[0].rows, "x rz");
  // The floating base carries everything, so its translational entries are the whole mass.
  EXPECT_NEAR(report.mass_matrix->diagonal[0], 14, 1e-13);
}

TEST(InspectRobot, KnowsASingularMassMatrix) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='continuous'>"
      "<parent link='a'/><child link='b'/></joint></robot>",
      "r.urdf", diagnostics);
  const Report report = inspect_robot(robot.value(), std::nullopt);
  EXPECT_TRUE(std::isinf(report.mass_matrix->condition));
  EXPECT_TRUE(std::isinf(report.mass_matrix->scaled_condition));
  EXPECT_NE(print_text(report).find("singular"), std::string::npos);
}

TEST(InspectRobot, TakesARobotThatDoesNotMove) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf("<robot name='r'><link name='a'/></robot>", "r.urdf", diagnostics);
  const Report report = inspect_robot(robot.value(), std::nullopt);
  EXPECT_FALSE(report.mass_matrix);
  EXPECT_NE(print_text(report).find("nothing moves"), std::string::npos);
  EXPECT_NE(print_json(report).find("\"mass_matrix\": null"), std::string::npos);
}

// Would catch: rounding errors of the report's own computation that are told as facts of the robot.
TEST(InspectRobot, TellsNoRoundingErrors) {
  Inertial tilted;  // a rod at 45 degrees; one that all three axes see alike
  tilted.mass = 1;
  tilted.ixx = tilted.iyy = 0.15;
  tilted.ixy = -0.15;
  tilted.izz = 0.3;
  EXPECT_EQ(principal_moments(tilted)[0], 0);
  tilted.ixx = tilted.iyy = tilted.izz = tilted.ixy = tilted.ixz = tilted.iyz = 0.001;
  EXPECT_EQ(principal_moments(tilted)[0], 0);
  EXPECT_EQ(principal_moments(tilted)[1], 0);
  tilted.ixx = -5.421e-20;  // as exporters leave them of a body without extent
  tilted.iyy = tilted.izz = tilted.ixy = tilted.ixz = tilted.iyz = 4e-18;
  EXPECT_EQ(principal_moments(tilted), (std::array<double, 3>{}));
  for (const char* name : {"humanoid24", "tumbler"}) {
    Diagnostics diagnostics;
    const auto robot = read_urdf(
        std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/" + name + ".urdf", diagnostics);
    EXPECT_EQ(inspect_robot(robot.value(), std::nullopt).com[1], 0) << name;
  }
}

}  // namespace
}  // namespace treeline
