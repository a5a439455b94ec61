// Would catch: a joint that loses digits and is not named, a joint that is named without reason,
// and findings that differ from run to run. The robots' singularities are known in closed form.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "inspect/inspect_robot.hpp"
#include "sample.hpp"

namespace treeline {
namespace {

/// Two links of 1 m in the plane, of 1 kg each except for the second's `tip` (kg, and kg m^2).
std::string planar_arm(const std::string& tip, const std::string& elbow_limits) {
  return R"(<robot name="planar"><link name="base"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <link name="upper"><inertial><origin xyz="0.5 0 0"/><mass value="1"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
  <joint name="elbow" type="revolute"><origin xyz="1 0 0"/><parent link="upper"/>
    <child link="fore"/><axis xyz="0 0 1"/><limit )" +
         elbow_limits + R"( effort="1" velocity="1"/></joint>
  <link name="fore"><inertial><mass value=")" +
         tip + R"("/><inertia ixx="TIP" ixy="0" ixz="0" iyy="TIP" iyz="0" izz="TIP"/></inertial>
  </link></robot>)";
}

Report inspect(std::string urdf, const std::string& tip, const std::string& scene_text) {
  for (auto at = urdf.find("TIP"); at != std::string::npos; at = urdf.find("TIP")) {
    urdf.replace(at, 3, tip);
  }
  Diagnostics diagnostics;
  const auto robot = parse_urdf(urdf, "planar.urdf", diagnostics);
  const auto scene = parse_scene(scene_text, "scene.yaml", robot.value(), diagnostics);
  return inspect_robot(robot.value(), scene.value());
}

Report inspect_own(const std::string& name) {
  const std::string folder = std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/";
  Diagnostics diagnostics;
  const auto robot = read_urdf(folder + name + ".urdf", diagnostics);
  return inspect_robot(robot.value(),
                       read_scene(folder + "scene.yaml", robot.value(), diagnostics).value());
}

const RiskReport* find(const Report& report, const std::string& joint, const std::string& kind) {
  const auto found = std::find_if(
      report.risks.begin(), report.risks.end(),
      [&](const RiskReport& risk) { return risk.joint == joint && risk.kind == kind; });
  return found == report.risks.end() ? nullptr : &*found;
}

constexpr const char* kTip =
    "operational_points: [{name: tip, link: fore, origin: {xyz: [1, 0, 0]}, rows: [x, y]}]\n";

TEST(InspectRisks, NamesTheElbowThatStretches) {
  const Report report = inspect(planar_arm("1", "lower=\"-2\" upper=\"2\""), "0.1", kTip);
  const RiskReport* elbow = find(report, "elbow", "singularity");
  ASSERT_NE(elbow, nullptr);
  EXPECT_GT(elbow->digits_lost, 10);
  EXPECT_NE(elbow->finding.find("as at 0 rad, from 4 of 4 poses"), std::string::npos)
      << elbow->finding;
  EXPECT_NE(elbow->advice.find("damped"), std::string::npos);
  EXPECT_EQ(find(report, "shoulder", "singularity"), nullptr);
  EXPECT_EQ(report.risks.size(), 1U);
}

TEST(InspectRisks, IsSilentWhereLimitsKeepTheElbowBent) {
  EXPECT_TRUE(inspect(planar_arm("1", "lower=\"0.5\" upper=\"2\""), "0.1", kTip).risks.empty());
}

TEST(InspectRisks, SaysWhenTheTaskAsksForMoreThanTheJointsCanDo) {
  const Report report = inspect(
      planar_arm("1", "lower=\"0.5\" upper=\"2\""), "0.1",
      "functions: [lambda_inverse]\n"
      "operational_points: [{name: tip, link: fore, origin: {xyz: [1, 0, 0]}, rows: [x, y]}, "
      "{name: twin, link: fore, origin: {xyz: [1, 0, 0]}, rows: [x, y]}]\n");
  EXPECT_NE(find(report, "", "task"), nullptr);
  EXPECT_EQ(report.risks.size(), 1U);
}

TEST(InspectRisks, NamesJointsThatNothingMovesWith) {
  const Report none = inspect(planar_arm("0", "lower=\"0.5\" upper=\"2\""), "0", "name: arm\n");
  const RiskReport* elbow = find(none, "elbow", "inertia");
  ASSERT_NE(elbow, nullptr);
  EXPECT_NE(elbow->finding.find("singular"), std::string::npos);
  // If it is heavy enough, M_22 / D_2 is small again: a light link alone loses nothing.
  EXPECT_TRUE(inspect(planar_arm("1e-9", "lower=\"0.5\" upper=\"2\""), "1e-10", "name: arm\n")
                  .risks.empty());
}

// M_11 / D_1 is (1e-7 + 0.25e-7 + 1e-1) / 1.25e-7 where the axes are one.
TEST(InspectRisks, NamesTwinsWithNextToNothingBetweenThem) {
  std::string urdf = planar_arm("1", "lower=\"0.5\" upper=\"2\"");
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (auto at = urdf.find(from); at != std::string::npos; at = urdf.find(from)) {
      urdf.replace(at, from.size(), to);
    }
  };
  replace("xyz=\"1 0 0\"", "xyz=\"0 0 0\"");
  replace("<origin xyz=\"0.5 0 0\"/><mass value=\"1\"/>",
          "<origin xyz=\"0.50 0 0\"/><mass value=\"1e-7\"/>");
  replace("\"0.1\"", "\"1e-7\"");
  const Report report = inspect(urdf, "0.1", "name: arm\n");
  for (const char* joint : {"shoulder", "elbow"}) {
    const RiskReport* risk = find(report, joint, "inertia");
    ASSERT_NE(risk, nullptr) << joint;
    EXPECT_NEAR(risk->digits_lost, std::log10(0.1 / 1.25e-7), 0.01);
  }
}

// A forearm of 1e-10 kg m^2 on an arm of 1 kg: in all poses the shoulder's contribution to
// Lambda^-1 is lost to rounding, although the task is possible. Would catch: a report that blames
// the task.
TEST(InspectRisks, NamesTheLightJointThatDrownsAHeavyOne) {
  const std::string arm = planar_arm("1e-10", "lower=\"0.5\" upper=\"2\"");
  const Report report = inspect(arm, "1e-11", kTip);
  const RiskReport* elbow = find(report, "elbow", "mass");
  ASSERT_NE(elbow, nullptr);
  EXPECT_GT(elbow->digits_lost, 8);
  EXPECT_NE(elbow->finding.find("more easily than shoulder does"), std::string::npos);
  EXPECT_EQ(report.risks.size(), 1U);
}

// A heavy link behind a light one, and a light link between heavy ones, lose nothing (`heavy_tip`
// and `light_link` of tests/stress) and are not reported.
TEST(InspectRisks, IsSilentAboutMassesThatCostNothing) {
  std::string urdf = planar_arm("1e4", "lower=\"0.5\" upper=\"2\"");
  EXPECT_TRUE(inspect(urdf, "1e3", kTip).risks.empty());
  urdf = planar_arm("1", "lower=\"0.5\" upper=\"2\"");
  for (const auto& [heavy, light] :
       {std::pair{"<mass value=\"1\"/>\n    <", "<mass value=\"1e-9\"/><"},
        std::pair{"ixx=\"0.1\"", "ixx=\"1e-10\""}, std::pair{"iyy=\"0.1\"", "iyy=\"1e-10\""},
        std::pair{"izz=\"0.1\"", "izz=\"1e-10\""}}) {
    const auto at = urdf.find(heavy);
    ASSERT_NE(at, std::string::npos) << heavy;
    urdf.replace(at, std::string(heavy).size(), light);
  }
  for (const RiskReport& risk : inspect(urdf, "0.1", kTip).risks) {
    EXPECT_NE(risk.kind, "mass") << risk.finding;
  }
}

TEST(InspectRisks, WarnsOfJointsThatTurnForever) {
  std::string urdf = planar_arm("1", "lower=\"0.5\" upper=\"2\"");
  urdf.replace(urdf.find("revolute"), 8, "continuous");
  const Report report = inspect(urdf, "0.1", "name: arm\n");
  EXPECT_NE(find(report, "shoulder", "angle"), nullptr);
}

// Would catch: a follower's own angle, the multiplier times its leader's, that is passed over.
TEST(InspectRisks, WarnsOfFollowersThatTurnFar) {
  const auto angles = [](const char* multiplier) {
    std::string urdf = planar_arm("1", "lower=\"-1e10\" upper=\"1e10\"");
    const std::string range = "lower=\"-3\" upper=\"3\"";
    urdf.replace(urdf.find(range), range.size(), "lower=\"-100\" upper=\"100\"");
    const std::size_t at = urdf.rfind("</joint>");
    urdf.insert(at, fmt::format("<mimic joint=\"shoulder\" multiplier=\"{}\"/>", multiplier));
    const Report report = inspect(urdf, "0.1", "name: arm\n");
    return find(report, "elbow", "angle") != nullptr;
  };
  EXPECT_FALSE(angles("100"));
  EXPECT_TRUE(angles("-1e7"));
}

TEST(InspectRisks, KnowsWhatLocksIndustrialArms) {
  for (const char* robot : {"puma560", "ur10e"}) {
    const Report report = inspect_own(robot);
    int singular = 0;
    for (const RiskReport& risk : report.risks) singular += risk.kind == "singularity" ? 1 : 0;
    EXPECT_GE(singular, 2) << robot << ": elbow and wrist at least";
    const Report again = inspect_own(robot);
    ASSERT_EQ(again.risks.size(), report.risks.size());
    for (std::size_t i = 0; i < again.risks.size(); ++i) {
      EXPECT_EQ(again.risks[i].digits_lost, report.risks[i].digits_lost);
      EXPECT_EQ(again.risks[i].finding, report.risks[i].finding);
    }
  }
}

}  // namespace
}  // namespace treeline
