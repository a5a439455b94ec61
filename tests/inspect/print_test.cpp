// Would catch: output that programs cannot read, and sections that disappear.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sample.hpp"

namespace treeline {
namespace {

/// A robot with names as exporters write them, in a chain of `joints` joints.
Report inspect_chain(int joints, const std::string& prefix) {
  std::string urdf = "<robot name='" + prefix + "'><link name='" + prefix + "_base'/>";
  std::string parent = prefix + "_base";
  for (int i = 0; i < joints; ++i) {
    const std::string name = prefix + "_" + std::to_string(i);
    urdf += "<joint name='" + name + "_joint' type='revolute'><parent link='" + parent +
            "'/><child link='" + name +
            "'/><origin xyz='0.1 0 0'/><axis xyz='0 0 1'/><limit "
            "lower='-123456.78' upper='123456.78' effort='-1234567' velocity='12345.678'/></joint>"
            "<link name='" +
            name +
            "'><inertial><origin xyz='-0.00012345 1.23456 -12.3456'/>"
            "<mass value='0.00123456'/><inertia ixx='1.23456e-05' iyy='9.87654e-06' "
            "izz='1.33333e-05' ixy='0' ixz='0' iyz='0'/></inertial></link>";
    parent = name;
  }
  Diagnostics diagnostics;
  const auto robot = parse_urdf(urdf + "</robot>", prefix + ".urdf", diagnostics);
  return inspect_robot(robot.value(), std::nullopt);
}

// Would catch: lines that are too long for a terminal because of long names, many joints or deep
// trees.
TEST(PrintText, StaysWithinHundredColumns) {
  const std::string name = "left_front_articulated_suspension_upper_control_arm_v2_export";
  for (const Report& report : {inspect_sample(), inspect_chain(60, "j"), inspect_chain(12, name),
                               inspect_chain(6, std::string(150, 'x'))}) {
    const std::string text = print_text(report);
    for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
      end = text.find('\n', at);
      EXPECT_LE(end - at, 100U) << text.substr(at, end - at);
    }
    EXPECT_EQ(text.rfind(print_summary(report), 0), 0U);
  }
}

// Would catch: a summary that does not begin with the worst findings.
TEST(PrintSummary, NamesWhatIsWrong) {
  const std::string summary = print_summary(inspect_sample());
  EXPECT_NE(summary.find("inertias 1 that no body can have: upper"), std::string::npos) << summary;
  EXPECT_NE(summary.find("M        condition 2.2222"), std::string::npos) << summary;
  EXPECT_LE(std::count(summary.begin(), summary.end(), '\n'), 12);
}

TEST(PrintText, HasEverySection) {
  const std::string text = print_text(inspect_sample());
  for (const char* part :
       {"two \"hands\" (sample.urdf)", "base     fixed, gravity 0 0 -9.81 m/s^2",
        "5 links, 3 moving joints, 2 coordinates, 2 velocities", "14 kg, of which 12 kg move",
        "\ntree\n", "    upper", "not physical", "joints, in the order of q", "rad/s", "N m",
        "= -0.5 * slide + 0.1", "inertias that are not physical", "what was reduced", "mass matrix",
        "condition    2.2222"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(PrintJson, CanBeReadBack) {
  const auto json = nlohmann::json::parse(print_json(inspect_sample()));
  EXPECT_EQ(json["robot"], "two \"hands\"");
  EXPECT_EQ(json["scene"], nullptr);
  EXPECT_EQ(json["links"].size(), 5U);
  EXPECT_EQ(json["links"][2]["lumped_with"], "upper");
  EXPECT_EQ(json["links"][1]["inertial"]["mass"], 3);
  EXPECT_EQ(json["joints"][0]["upper"], 2);
  EXPECT_EQ(json["joints"][1]["upper"], nullptr);
  EXPECT_EQ(json["mass_matrix"]["diagonal"].size(), 2U);
}

TEST(PrintDot, EscapesNamesAndMarksEdges) {
  const std::string dot = print_dot(inspect_sample());
  for (const char* part :
       {"digraph \"two \\\"hands\\\"\" {", "link1 [label=\"upper\\n3 kg\", color=red];",
        "link1 -> link2 [label=\"mount\\nfixed\", style=dashed];", "style=dotted",
        "link0 -> link1 [label=\"arm\\nrevolute\", style=solid];"}) {
    EXPECT_NE(dot.find(part), std::string::npos) << part << "\n" << dot;
  }
}

// Would catch: a rotor, friction or spring of the scene that is not shown, or shown of a joint that
// has none.
TEST(Print, ShowsWhatTheScenePutsIntoJoints) {
  const std::string scene =
      "armature: {arm: 0.25}\n"
      "joint_friction: {model: coulomb, joints: {arm: {damping: 3}, slide: {friction: 7, width: "
      "0.5}}}\n"
      "joint_springs: {slide: {stiffness: 40, rest: 0.125}}\n";
  const Report report = inspect_sample(scene);
  EXPECT_NE(
      print_text(report).find("rotors, friction and springs (SI units)\n"
                              "  joint  rotor  damping  friction  within  stiffness   rest\n"
                              "  arm     0.25        3\n"
                              "  slide                         7     0.5         40  0.125\n"),
      std::string::npos)
      << print_text(report);
  const auto joints = nlohmann::json::parse(print_json(report))["joints"];
  EXPECT_EQ(joints[0]["drive"]["rotor"], 0.25);
  EXPECT_EQ(joints[1]["drive"]["width"], 0.5);
  EXPECT_FALSE(joints[2].contains("drive"));
  EXPECT_EQ(print_text(inspect_sample()).find("springs"), std::string::npos);
}

}  // namespace
}  // namespace treeline
