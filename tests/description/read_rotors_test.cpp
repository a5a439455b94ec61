// Would catch: a rotor that is lost, given to another joint, or counted without the square of the
// gear ratio; a rotor of the file that a scene counts unasked; a coupling that is read as if each
// motor drove one joint.
#include <gtest/gtest.h>

#include "description/read_scene.hpp"
#include "description/urdf_parts.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

std::string motor(const std::string& joint, const std::string& inside) {
  return "<transmission name='t_" + joint + "'><joint name='" + joint + "'/><actuator name='m_" +
         joint + "'>" + inside + "</actuator></transmission>";
}

/// Joint a turns, joint b slides.
std::string urdf_with(const std::string& inside) {
  const std::string limit = "<limit lower='-1' upper='1' effort='1' velocity='1'/>";
  return "<robot name='r'><link name='base'/><link name='l'>" + kBody + "</link><link name='m'>" +
         kBody + "</link><joint name='a' type='revolute'><parent link='base'/><child link='l'/>" +
         limit + "</joint><joint name='b' type='prismatic'><parent link='l'/><child link='m'/>" +
         limit + "</joint>" + inside + "</robot>";
}

Robot read_with(const std::string& inside) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(urdf_with(inside), "r.urdf", diagnostics);
  EXPECT_TRUE(robot) << to_string(diagnostics);
  return robot.value();
}

TEST(ReadRotors, TakesInertiaAndRatioOfTransmissions) {
  const Robot robot =
      read_with(motor("b", "<mechanicalReduction> 50 </mechanicalReduction>") +
                motor("a",
                      "<mechanicalReduction>1</mechanicalReduction><drake:gear_ratio value='160'/>"
                      "<drake:rotor_inertia value='0.0002'/>") +
                motor("nobody", "<drake:rotor_inertia value='1'/>"));
  EXPECT_DOUBLE_EQ(armature_of(robot.joints[0]), 160 * 160 * 0.0002);
  ASSERT_TRUE(robot.joints[1].rotor);
  EXPECT_FALSE(robot.joints[1].rotor->inertia);
  EXPECT_EQ(robot.joints[1].rotor->ratio, 50);
  EXPECT_EQ(armature_of(robot.joints[1]), 0);
}

TEST(ReadRotors, TakesTheInertiasOfOtherNames) {
  const Robot robot = read_with(
      motor("a", "<mechanicalReduction>9</mechanicalReduction><motorInertia>0.002</motorInertia>") +
      motor("b", "<mechanicalReduction>3</mechanicalReduction><rotorInertia value='0.01'/>"));
  EXPECT_DOUBLE_EQ(armature_of(robot.joints[0]), 81 * 0.002);
  EXPECT_DOUBLE_EQ(armature_of(robot.joints[1]), 9 * 0.01);
}

TEST(ReadRotors, TakesTheArmatureOfDynamics) {
  const std::string urdf = urdf_with("");
  const std::string with = "<dynamics armature='0.25'/></joint><joint name='b'";
  std::string changed = urdf;
  changed.replace(changed.find("</joint><joint name='b'"), 23, with);
  Diagnostics diagnostics;
  const auto robot = parse_urdf(changed, "r.urdf", diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_EQ(armature_of(robot->joints[0]), 0.25);
}

// Would catch a rotor that a ratio of 0, left by an exporter, takes away without a word.
TEST(ReadRotors, WarnOfARatioOfZero) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(urdf_with(motor("a",
                                                "<mechanicalReduction>0</mechanicalReduction>"
                                                "<drake:rotor_inertia value='1'/>")),
                                "r.urdf", diagnostics);
  ASSERT_TRUE(robot);
  EXPECT_FALSE(robot->joints[0].rotor);
  expect_diagnosed(
      diagnostics, "r.urdf",
      {Severity::warning, 1, "robot/transmission[t_a]", "the gear ratio is 0", "turns"});
}

TEST(ReadRotors, RefusesWhatNoMotorHas) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_urdf(urdf_with(motor("a", "<drake:rotor_inertia value='-1'/>")), "r.urdf",
                          diagnostics));
  expect_diagnosed(diagnostics, "r.urdf",
                   {Severity::error, 1, "robot/transmission[t_a]", "-1 is negative", "positive"});
  Diagnostics coupled;
  const auto robot = parse_urdf(
      urdf_with("<transmission name='t'><joint name='a'/><joint name='b'/><actuator name='m'>"
                "<drake:rotor_inertia value='1'/></actuator></transmission>"),
      "r.urdf", coupled);
  ASSERT_TRUE(robot);
  EXPECT_EQ(armature_of(robot->joints[0]) + armature_of(robot->joints[1]), 0);
  expect_diagnosed(coupled, "r.urdf",
                   {Severity::warning, 1, "robot/transmission[t]", "couples them", "armatures"});
}

Scene scene_of(const std::string& text, const Robot& robot, Diagnostics& diagnostics) {
  const auto scene = parse_scene(text, "s.yaml", robot, diagnostics);
  EXPECT_TRUE(scene) << to_string(diagnostics);
  return scene.value_or(Scene{});
}

TEST(ReadRotors, SceneSaysWhichCount) {
  const Robot robot = read_with(motor("a",
                                      "<drake:gear_ratio value='10'/>"
                                      "<drake:rotor_inertia value='0.5'/>") +
                                motor("b", "<mechanicalReduction>4</mechanicalReduction>"));
  using Armature = std::map<std::string, double>;
  Diagnostics unasked, asked;
  EXPECT_EQ(scene_of("base: fixed", robot, unasked).armature, Armature{});
  expect_diagnosed(unasked, "s.yaml",
                   {Severity::note, 1, "", "rotors of 1 joints; no function", "armature: file"});
  EXPECT_EQ(scene_of("armature: none", robot, asked).armature, Armature{});
  EXPECT_EQ(scene_of("armature: file", robot, asked).armature, (Armature{{"a", 50}}));
  EXPECT_EQ(scene_of("armature: {b: 3}", robot, asked).armature, (Armature{{"b", 3}}));
  EXPECT_EQ(scene_of("armature: {b: {rotor_inertia: 2}, a: {rotor_inertia: 1, gear_ratio: -3}}",
                     robot, asked)
                .armature,
            (Armature{{"a", 9}, {"b", 32}}));
  EXPECT_TRUE(asked.list().empty()) << to_string(asked);
}

TEST(ReadRotors, MayBeBodiesOfTheirOwn) {
  const Robot robot = read_with(motor("a", "<drake:gear_ratio value='10'/>"));
  Diagnostics diagnostics;
  const Scene scene = scene_of(
      "armature: {a: {rotor_inertia: 0.5, gyroscopic: true}, b: {rotor_inertia: 2, gear_ratio: -3, "
      "gyroscopic: true, link: " +
          robot.links[0].name + ", axis: [0, 0, 2]}}",
      robot, diagnostics);
  EXPECT_TRUE(scene.armature.empty());
  ASSERT_EQ(scene.rotors.size(), 2U) << to_string(diagnostics);
  EXPECT_EQ(scene.rotors.at("a").inertia, 0.5);
  EXPECT_EQ(scene.rotors.at("a").ratio, 10);
  EXPECT_FALSE(scene.rotors.at("a").axis);
  EXPECT_EQ(scene.rotors.at("b").ratio, -3);
  EXPECT_EQ(scene.rotors.at("b").link, robot.links[0].name);
  EXPECT_EQ(scene.rotors.at("b").axis, (std::array<double, 3>{0, 0, 1}));
  const auto refused = [&](const std::string& rotor) {
    Diagnostics found;
    EXPECT_FALSE(
        parse_scene("armature: {a: {rotor_inertia: 1, " + rotor + "}}", "s.yaml", robot, found))
        << rotor;
    return to_string(found);
  };
  EXPECT_NE(refused("gyroscopic: true, link: nowhere, axis: [1, 0, 0]").find("no link \"nowhere\""),
            std::string::npos);
  EXPECT_NE(refused("gyroscopic: true, link: " + robot.links[0].name).find("axis is missing"),
            std::string::npos);
  EXPECT_NE(refused("gyroscopic: true, axis: [0, 0, 0]").find("no direction"), std::string::npos);
  EXPECT_NE(refused("axis: [0, 0, 1]").find("gyroscopic: true"), std::string::npos);
  EXPECT_NE(refused("gear_ratio: 0").find("gear_ratio: 0 is no ratio"), std::string::npos);
}

// Talos turns its wrists by differentials: one transmission, two joints, two motors. Nothing of it
// is of account, so nothing is said of it.
TEST(ReadRotors, AreSilentOfADifferentialWithoutRotors) {
  const auto differential = [](const std::string& inside) {
    return urdf_with(
        "<transmission name='t'><actuator name='m'><mechanicalReduction>1</mechanicalReduction>"
        "</actuator><actuator name='n'>" +
        inside + "</actuator><joint name='a'/><joint name='b'/></transmission>");
  };
  Diagnostics diagnostics;
  EXPECT_TRUE(parse_urdf(differential(""), "r.urdf", diagnostics));
  EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics);
  EXPECT_TRUE(parse_urdf(differential("<drake:rotor_inertia value='1'/>"), "r.urdf", diagnostics));
  expect_diagnosed(diagnostics, "r.urdf",
                   {Severity::warning, 1, "robot/transmission[t]", "couples them", "armatures"});
}

}  // namespace
}  // namespace treeline
