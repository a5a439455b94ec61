// Would catch: a difference between two robots that is not found, has another size than the change
// that caused it, or is found where there is none.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "comparison/difference.hpp"
#include "description/read_urdf.hpp"

namespace treeline {
namespace {

/// base -j1 (z)-> upper -j2 (y, 0.5 along x)-> lower -mount-> tool (0.4 along x).
const std::string kArm = R"(<robot name="arm">
  <link name="base"/>
  <joint name="j1" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="10" velocity="3"/></joint>
  <link name="upper"><inertial><origin xyz="0.2 0 0"/><mass value="2"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
  <joint name="j2" type="revolute"><parent link="upper"/><child link="lower"/><axis xyz="0 1 0"/>
    <origin xyz="0.5 0 0"/><limit lower="-1" upper="1" effort="10" velocity="3"/></joint>
  <link name="lower"><inertial><origin xyz="0.3 0 0"/><mass value="1"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.2"/></inertial></link>
  <joint name="mount" type="fixed"><parent link="lower"/><child link="tool"/>
    <origin xyz="0.4 0 0"/></joint>
  <link name="tool"/>
</robot>
)";

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = text.find(old); at != std::string::npos;
       at = text.find(old, at + by.size()))
    text.replace(at, old.size(), by);
  return text;
}

Robot read(const std::string& text, const char* file) {
  Diagnostics diagnostics;
  auto robot = parse_urdf(text, file, diagnostics);
  EXPECT_TRUE(robot) << (diagnostics.list().empty() ? "" : to_string(diagnostics.list().front()));
  return robot.value();
}

RobotDifference compare(const std::string& first, const std::string& second,
                        Base base = Base::fixed, double tolerance = 1e-6) {
  return compare_robots(read(first, "first.urdf"), read(second, "second.urdf"), base, tolerance);
}

const LinkDifference& link(const RobotDifference& difference, const std::string& name) {
  for (const LinkDifference& link : difference.links) {
    if (link.first == name) return link;
  }
  ADD_FAILURE() << "no link " << name;
  return difference.links.front();
}

TEST(CompareRobots, TheSame) {
  const RobotDifference difference = compare(kArm, kArm);
  EXPECT_FALSE(difference.differs()) << print_text(difference);
  EXPECT_EQ(difference.links.size(), 4U);
  EXPECT_EQ(difference.joints.size(), 3U);
  EXPECT_EQ(difference.dynamics.coordinates, 2);
  EXPECT_EQ(difference.dynamics.inverse_dynamics.relative, 0);
}

TEST(CompareRobots, ShiftedAndTurnedFrame) {
  const RobotDifference difference =
      compare(kArm, replaced(kArm, "xyz=\"0.5 0 0\"", "xyz=\"0.5 0.03 0.04\" rpy=\"0 0 0.02\""));
  EXPECT_TRUE(difference.differs());
  EXPECT_EQ(difference.reference, "base");
  EXPECT_NEAR(link(difference, "upper").position, 0, 1e-15);
  EXPECT_NEAR(link(difference, "lower").position, 0.05, 1e-12);
  EXPECT_NEAR(link(difference, "lower").rotation, 0.02, 1e-12);
  EXPECT_NEAR(link(difference, "tool").rotation, 0.02, 1e-12);
  EXPECT_GT(difference.dynamics.inverse_dynamics.relative, 1e-3);
}

TEST(CompareRobots, MassCentreAndInertia) {
  const RobotDifference heavier = compare(kArm, replaced(kArm, "value=\"1\"", "value=\"1.25\""));
  EXPECT_NEAR(link(heavier, "lower").mass, 0.2, 1e-15);
  EXPECT_EQ(link(heavier, "lower").centre, 0);
  EXPECT_EQ(link(heavier, "lower").position, 0);
  // Gravity acts on j2 alone, with m 0.3 g cos(q), in proportion to the mass.
  EXPECT_NEAR(heavier.dynamics.gravity.relative, 0.2, 1e-12);
  EXPECT_EQ(heavier.dynamics.gravity.joint, "j2");
  EXPECT_EQ(heavier.dynamics.gravity.unit, "N m");
  EXPECT_LE(heavier.dynamics.gravity.absolute, 0.25 * 0.3 * 9.81 + 1e-12);
  EXPECT_GT(heavier.dynamics.gravity.absolute, 0.2 * 0.3 * 9.81);

  const RobotDifference moved =
      compare(kArm, replaced(kArm, "xyz=\"0.3 0 0\"", "xyz=\"0.3 0 0.1\""));
  EXPECT_NEAR(link(moved, "lower").centre, 0.1, 1e-15);
  EXPECT_EQ(link(moved, "lower").mass, 0);

  // M_22 = iyy + m 0.3^2 = 0.29 and 0.31: the entry at j2, j2.
  const RobotDifference inertia = compare(kArm, replaced(kArm, "iyy=\"0.2\"", "iyy=\"0.22\""));
  EXPECT_NEAR(inertia.dynamics.mass_matrix, 0.02 / 0.31, 1e-9);
  EXPECT_EQ(inertia.dynamics.row, "j2");
  EXPECT_EQ(inertia.dynamics.column, "j2");
  EXPECT_LT(inertia.dynamics.gravity.relative, 1e-15);
}

TEST(CompareRobots, InertiaInOtherAxesIsTheSame) {
  // A quarter turn of the inertial frame about z exchanges x and y.
  const std::string turned = replaced(
      kArm,
      "<origin xyz=\"0.3 0 0\"/><mass value=\"1\"/>\n    <inertia ixx=\"0.1\" ixy=\"0\" "
      "ixz=\"0\" iyy=\"0.2\"",
      "<origin xyz=\"0.3 0 0\" rpy=\"0 0 1.5707963267948966\"/><mass value=\"1\"/>\n    <inertia "
      "ixx=\"0.2\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\"");
  ASSERT_NE(turned, kArm);
  EXPECT_FALSE(compare(kArm, turned).differs()) << print_text(compare(kArm, turned));
}

TEST(CompareRobots, Limits) {
  const RobotDifference difference =
      compare(kArm, replaced(kArm, "lower=\"-1\" upper=\"1\" effort=\"10\"",
                             "lower=\"-1.5\" upper=\"1\" effort=\"inf\""));
  EXPECT_TRUE(difference.differs());
  const JointDifference& joint = difference.joints[1];
  EXPECT_EQ(joint.first, "j2");
  EXPECT_EQ(joint.faults, (std::vector<std::string>{"lower: -1 and -1.5", "effort: 10 and inf"}));
  EXPECT_TRUE(difference.joints[0].faults.empty());
}

TEST(CompareRobots, RenamedLinksAndJoints) {
  std::string other = kArm;
  for (const char* name : {"base", "upper", "lower", "tool", "j1", "j2", "mount"}) {
    other = replaced(other, std::string("\"") + name + "\"", std::string("\"left_") + name + "\"");
  }
  const RobotDifference difference = compare(kArm, other);
  EXPECT_TRUE(difference.differs());
  ASSERT_EQ(difference.links.size(), 4U);
  for (const LinkDifference& l : difference.links) EXPECT_EQ(l.second, "left_" + l.first);
  for (const JointDifference& j : difference.joints) EXPECT_EQ(j.second, "left_" + j.first);
  EXPECT_EQ(difference.dynamics.coordinates, 2);
  EXPECT_LT(difference.dynamics.inverse_dynamics.relative, 1e-15);
}

// A world link before the base, and a tool that is lumped: the links differ, the motion does not.
TEST(CompareRobots, LinksInOneOnly) {
  const std::string more = replaced(
      kArm, "<robot name=\"arm\">",
      "<robot name=\"arm\"><link name=\"world\"/><joint name=\"fix\" type=\"fixed\"><parent "
      "link=\"world\"/><child link=\"base\"/><origin xyz=\"1 2 3\" rpy=\"0 0 0.5\"/></joint>");
  const RobotDifference difference = compare(kArm, more);
  EXPECT_TRUE(difference.differs());
  EXPECT_EQ(difference.links_only_in_second, std::vector<std::string>{"world"});
  EXPECT_EQ(difference.joints_only_in_second, std::vector<std::string>{"fix"});
  EXPECT_TRUE(difference.links_only_in_first.empty());
  EXPECT_LT(link(difference, "tool").position, 1e-12);
  EXPECT_LT(difference.dynamics.inverse_dynamics.relative, 1e-12);
  EXPECT_EQ(compare(more, kArm).links_only_in_first, std::vector<std::string>{"world"});
}

TEST(CompareRobots, ToleranceDecides) {
  const std::string rounded = replaced(kArm, "xyz=\"0.5 0 0\"", "xyz=\"0.50001 0 0\"");
  EXPECT_TRUE(compare(kArm, rounded).differs());
  EXPECT_FALSE(compare(kArm, rounded, Base::fixed, 1e-3).differs());
}

TEST(CompareRobots, FloatingBaseFeelsItsOwnInertia) {
  const std::string heavy = replaced(
      kArm, "<link name=\"base\"/>",
      "<link name=\"base\"><inertial><mass value=\"5\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" "
      "iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>");
  EXPECT_EQ(compare(kArm, heavy).dynamics.mass_matrix, 0);
  const RobotDifference floating = compare(kArm, heavy, Base::floating);
  EXPECT_EQ(floating.dynamics.coordinates, 8);
  EXPECT_GT(floating.dynamics.mass_matrix, 0.1);
  EXPECT_EQ(floating.dynamics.row, "base");
}

TEST(CompareRobots, MimicsFollowTheirOwn) {
  const std::string two =
      replaced(kArm, "<origin xyz=\"0.5 0 0\"/>",
               "<origin xyz=\"0.5 0 0\"/><mimic joint=\"j1\" multiplier=\"0.5\"/>");
  const RobotDifference difference = compare(two, kArm);
  EXPECT_EQ(difference.joints[1].faults, std::vector<std::string>{"mimics: 0.5 * j1 + 0 and none"});
  EXPECT_LT(link(difference, "tool").position, 1e-12);
  EXPECT_EQ(difference.dynamics.coordinates, 1);
  EXPECT_FALSE(compare(two, two).differs());
}

TEST(CompareRobots, EveryRobotIsItself) {
  for (const char* name : {"puma560", "humanoid24", "samm", "ur10e", "tumbler", "planar3r"}) {
    const std::string path = std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/" + name + ".urdf";
    Diagnostics diagnostics;
    const auto robot = read_urdf(path, diagnostics);
    ASSERT_TRUE(robot) << path;
    for (const Base base : {Base::fixed, Base::floating}) {
      EXPECT_FALSE(compare_robots(*robot, *robot, base, 0).differs()) << name;
    }
  }
}

TEST(CompareRobots, Printed) {
  const RobotDifference difference = compare(
      kArm,
      replaced(replaced(kArm, "value=\"1\"", "value=\"1.25\""), "upper=\"1\"", "upper=\"1.5\""));
  const std::string text = print_text(difference);
  for (const char* part : {"different", "tolerance 1e-06", "1 and 1.25", "upper: 1 and 1.5",
                           "gravity 0.2 (", "N m at j2"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  const auto json = nlohmann::json::parse(print_json(difference));
  EXPECT_TRUE(json["differs"]);
  EXPECT_NEAR(json["dynamics"]["gravity"]["relative"], 0.2, 1e-12);
  EXPECT_EQ(json["links"][2]["first"], "lower");
  EXPECT_NEAR(json["links"][2]["mass"], 0.2, 1e-15);
  EXPECT_EQ(json["joints"][1]["faults"][0], "upper: 1 and 1.5");
}

}  // namespace
}  // namespace treeline
