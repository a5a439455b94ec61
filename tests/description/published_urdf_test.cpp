// Would catch: files from other parsers' test suites that are treated differently than by a good
// reader, and published robots that cannot be read.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "diagnosed.hpp"
#include "inspect/warn_of_limits.hpp"
#include "oracle/leave_out_singular.hpp"

namespace treeline {
namespace {

using tests::data_file;

std::string verdict(const Diagnostics& diagnostics) {
  if (diagnostics.has_errors()) return "reject";
  const auto& list = diagnostics.list();
  const bool warned = std::any_of(list.begin(), list.end(), [](const Diagnostic& d) {
    return d.severity == Severity::warning;
  });
  return warned ? "warn" : "accept";
}

/// Decisions where the test suites disagree. Limits do not matter for the dynamics, so a robot
/// without them is accepted. A joint that URDF does not have is refused, never guessed at, but for
/// the ball joint, on which others agree.
const std::map<std::string, std::string> kChosen = {
    {"rosurdf_fail_no_filename_in_mesh", "reject"},  // a joint without parent and child
    {"urdfdom_version_one_int", "warn"},
    {"urdfdom_joint_doubles", "reject"},  // a link with two parents
    {"tess_limit_no_effort", "warn"},
    {"tess_axis_empty", "reject"},
    {"urdfpy_new_transmission_missing_actuator", "reject"},  // no link
    {"drake_JointFloatingWarning", "warn"},                  // six degrees of freedom without mass
    {"drake_joint_parsing_test", "reject"},                  // joints in a namespace of Drake
    {"drake_Acrobot_unicode", "accept"},                     // "world" is the ground
    {"drake_tag_mismatch_2", "warn"},                        // a massless link
    {"mujoco_joint_types", "warn"},                          // no limits, no inertia
    {"idyntree_spherical", "warn"},                          // no inertia
    {"multicalc_bad_planar_joint", "accept"},
    {"multicalc_bad_zero_mass", "warn"},
    {"multicalc_passed_over_sections", "warn"},  // limit without effort and velocity
    {"multicalc_visual_and_collision", "warn"},
    {"urdfrs_deserialization", "reject"},  // two joints of one name
    {"bullet_hinge_spherical", "warn"},    // an axis in a ball joint
    {"bullet_gripper_prismatic", "warn"}};

bool agrees(const std::string& name, const std::string& expected, const std::string& found) {
  if (expected == "accept") return found != "reject";
  if (expected != "differ") return found == expected;
  const auto chosen = kChosen.find(name);
  return chosen == kChosen.end() || chosen->second == found;
}

/// Adds the warnings about joints and bases without inertia, and about placeholders among limits,
/// that a default scene gives.
void warn_in_scene(const Robot& robot, Diagnostics& diagnostics) {
  Diagnostics of_scene;
  auto scene = read_scene("", robot, of_scene);
  if (!scene) return;
  leave_out_singular(robot, *scene, "", diagnostics);
  warn_of_limits(robot, *scene, LimitUse::code, diagnostics);
}

TEST(PublishedUrdf, OddFilesAreTakenAsExpected) {
  std::ifstream table(data_file("odd/expected.tsv"));
  int files = 0;
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    std::istringstream columns(line);
    std::string name, expected;
    std::getline(columns, name, '\t');
    std::getline(columns, expected, '\t');
    Diagnostics diagnostics;
    const auto robot = read_urdf(data_file("odd/" + name + ".urdf"), diagnostics);
    EXPECT_EQ(robot.has_value(), !diagnostics.has_errors()) << name;
    if (robot) warn_in_scene(*robot, diagnostics);
    EXPECT_TRUE(agrees(name, expected, verdict(diagnostics)))
        << name << ": expected " << expected << ", found " << verdict(diagnostics) << '\n'
        << to_string(diagnostics);
    ++files;
  }
  EXPECT_EQ(files, 114);
}

TEST(PublishedUrdf, PublishedRobotsAreRead) {
  for (const tests::DataRobot& robot : tests::data_robots("published")) {
    Diagnostics diagnostics;
    EXPECT_TRUE(read_urdf(robot.path, diagnostics)) << to_string(diagnostics);
  }
}

TEST(PublishedUrdf, EveryErrorNamesItsPlaceAndRemedy) {
  for (const tests::DataRobot& robot : tests::data_robots("odd")) {
    Diagnostics diagnostics;
    (void)read_urdf(robot.path, diagnostics);
    for (const Diagnostic& d : diagnostics.list()) {
      EXPECT_EQ(d.file, robot.path);
      EXPECT_TRUE(d.line > 0 || !d.element.empty() || d.fault.find("no XML") != std::string::npos)
          << to_string(d);
      EXPECT_FALSE(d.severity == Severity::error && d.remedy.empty()) << to_string(d);
    }
  }
}

}  // namespace
}  // namespace treeline
