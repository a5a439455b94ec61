// Would catch: dead points and folds of loops that are not named or named elsewhere, poses that are
// blamed without reason, and wrong counts of what loops leave free. All figures follow from the
// sides of triangles.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "data/list_data.hpp"
#include "inspect/inspect_robot.hpp"
#include "sample.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

/// A four-bar: ground and coupler 0.3 m, rocker 0.25 m, crank as given.
Report inspect_four_bar(const std::string& scene_text, const std::string& crank = "0.12",
                        const std::string& rows = "[x, z]", const std::string& reach = "0.3") {
  Diagnostics diagnostics;
  const auto file = read_text_file(tests::data_file("written/four_bar.urdf"), diagnostics);
  const std::string urdf =
      std::regex_replace(file.value(), std::regex("xyz=\"0 0 0.12\""), "xyz=\"0 0 " + crank + "\"");
  const std::string closing =
      "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: [0, 0, 0.25]}, "
      "other_origin: {xyz: [" +
      reach + ", 0, 0]}, rows: " + rows + "}]\n";
  const auto robot = parse_urdf(urdf, "four_bar.urdf", diagnostics);
  const auto scene = parse_scene(closing + scene_text, "scene.yaml", robot.value(), diagnostics);
  return inspect_robot(robot.value(), scene.value());
}

std::vector<RiskReport> loop_risks(const Report& report) {
  std::vector<RiskReport> risks;
  for (const RiskReport& risk : report.risks) {
    if (risk.kind == "loop") risks.push_back(risk);
  }
  return risks;
}

/// The pose that a finding names, rad.
double pose_of(const RiskReport& risk) {
  std::smatch found;
  const std::regex pose("at (-?[0-9.e-]+) rad");
  return std::regex_search(risk.finding, found, pose) ? std::stod(found[1]) : std::nan("");
}

TEST(InspectLoops, CountWhatRowsLeave) {
  const Report report = inspect_four_bar("passive: [coupler_joint, rocker_joint]");
  ASSERT_TRUE(report.loops);
  EXPECT_EQ(report.loops->rows, 2);
  EXPECT_EQ(report.loops->dependent, 0);
  EXPECT_EQ(report.loops->freedoms, 1);
  EXPECT_EQ(report.loops->unheld, 0);
  const Report hinge = inspect_four_bar("", "0.12", "[x, y, z, rx, rz]");
  ASSERT_TRUE(hinge.loops);
  EXPECT_EQ(hinge.loops->dependent, 3);
  EXPECT_EQ(hinge.loops->freedoms, 1);
  EXPECT_NE(print_text(hinge).find("5 rows, 3 implied by the others; 1 freedom"),
            std::string::npos);
  const auto json = nlohmann::json::parse(print_json(hinge));
  EXPECT_EQ(json["loops"]["dependent"], 3);
  EXPECT_TRUE(nlohmann::json::parse(print_json(inspect_sample()))["loops"].is_null());
}

TEST(InspectLoops, SayWhatNoMotorHolds) {
  const Report report = inspect_four_bar("passive: [crank_joint, coupler_joint, rocker_joint]");
  ASSERT_TRUE(report.loops);
  EXPECT_EQ(report.loops->unheld, 1);
  EXPECT_NE(print_text(report).find("1 not held by motors"), std::string::npos);
}

// Coupler and rocker are never in line: the crank's end stays within 0.18 and 0.42 m of the
// rocker's pivot, and they are 0.05 and 0.55 m long together.
TEST(InspectLoops, AreSilentWhereTheCrankTurnsFully) {
  EXPECT_TRUE(loop_risks(inspect_four_bar("passive: [coupler_joint, rocker_joint]")).empty());
}

// Crank and coupler are in line where the rocker's end is 0.42 or 0.18 m from the crank's pivot:
// 0.3^2 + 0.25^2 + 0.15 sin r is the square of that.
TEST(InspectLoops, NameTheDeadPointsOfADrivenRocker) {
  const auto risks = loop_risks(inspect_four_bar("passive: [crank_joint, coupler_joint]"));
  ASSERT_EQ(risks.size(), 1u);
  EXPECT_EQ(risks[0].joint, "rocker_joint");
  EXPECT_NE(risks[0].finding.find("no motor holds crank_joint, coupler_joint"), std::string::npos)
      << risks[0].finding;
  const double sine = std::sin(pose_of(risks[0]));
  const double nearest = std::min(std::abs(sine - (0.1764 - 0.1525) / 0.15),
                                  std::abs(sine - (0.0324 - 0.1525) / 0.15));
  EXPECT_LT(nearest, 1e-3) << risks[0].finding;
}

// With opposite sides alike all four bars fall into one line.
TEST(InspectLoops, NameTheFoldOfAParallelogram) {
  const auto risks = loop_risks(inspect_four_bar("", "0.25"));
  ASSERT_FALSE(risks.empty());
  EXPECT_EQ(risks[0].joint, "crank_joint");
  EXPECT_NE(risks[0].finding.find("fold"), std::string::npos);
  EXPECT_NEAR(std::abs(pose_of(risks[0])), std::numbers::pi / 2, 1e-3) << risks[0].finding;
}

// Would catch a decomposition of the no columns of the joints that could follow.
TEST(InspectLoops, TakeLoopsOfOneJointAlone) {
  const std::string frames = "between: [left, base], origin: {xyz: [0, 0.1, 0]}, ";
  const std::string closed = "other_origin: {xyz: [0.25, 0.1, 0]}, ";
  for (const std::string& held :
       {std::string("couplings: [{name: c, joints: {arm: 1}, offset: -0.5}]"),
        "constraints: [{name: c, " + frames + closed + "rows: [x]}]"}) {
    const Report report = inspect_sample(held);
    ASSERT_TRUE(report.loops) << held;
    EXPECT_EQ(report.loops->rows, 1) << held;
    EXPECT_EQ(report.loops->freedoms, 0) << held;
    EXPECT_TRUE(loop_risks(report).empty()) << held;
  }
  const Report rolling = inspect_sample(
      "constraints: [{name: c, between: [upper, base], origin: "
      "{xyz: [0, 0, 0.1]}, rolling: {radius: 0.1}}]");
  ASSERT_TRUE(rolling.loops);
  EXPECT_EQ(rolling.loops->freedoms, 0);
}

TEST(InspectLoops, SayWhereNoPoseCloses) {
  const Report report = inspect_four_bar("", "0.12", "[x, z]", "3");
  EXPECT_FALSE(report.loops);
  const auto risks = loop_risks(report);
  ASSERT_EQ(risks.size(), 1u);
  EXPECT_NE(risks[0].finding.find("no pose was found"), std::string::npos);
}

// Six legs of six velocities, and five ball joints that close them: six freedoms are left.
TEST(InspectLoops, CountTheFreedomsOfAStewartPlatform) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(tests::data_file("written/stewart.urdf"), diagnostics);
  const Report report = inspect_robot(
      robot.value(), parse_scene("", "scene.yaml", robot.value(), diagnostics).value());
  ASSERT_TRUE(report.loops);
  EXPECT_EQ(report.loops->rows, 15);
  EXPECT_EQ(report.loops->dependent, 0);
  EXPECT_EQ(report.loops->freedoms, 6);
}

}  // namespace
}  // namespace treeline
