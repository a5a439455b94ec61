// Would catch: coefficients of the file that a scene counts unasked or not at all, an override that
// loses the other coefficient, Coulomb friction in a viscous model, a width or a step that is
// dropped, and what is left out in silence.
#include <gtest/gtest.h>

#include "description/read_keys.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

/// Joint a turns at up to 2 rad/s with damping 0.5 and friction 0.2; b slides, with damping 3; c
/// floats with damping 1, d turns without either.
Robot robot_with_friction() {
  const std::string limit = "<limit lower='-1' upper='1' effort='1' velocity='2'/>";
  const auto joint = [](const std::string& name, const std::string& type, const std::string& from,
                        const std::string& to, const std::string& inside) {
    return "<joint name='" + name + "' type='" + type + "'><parent link='" + from +
           "'/><child link='" + to + "'/>" + inside + "</joint>";
  };
  const auto link = [](const std::string& name) {
    return "<link name='" + name + "'>" + kBody + "</link>";
  };
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='r'><link name='base'/>" + link("l") + link("m") + link("n") + link("o") +
          joint("a", "revolute", "base", "l", limit + "<dynamics damping='0.5' friction='0.2'/>") +
          joint("b", "prismatic", "l", "m", limit + "<dynamics damping='3'/>") +
          joint("c", "floating", "base", "n", "<dynamics damping='1'/>") +
          joint("d", "continuous", "m", "o", "") + "</robot>",
      "r.urdf", diagnostics);
  EXPECT_TRUE(robot) << to_string(diagnostics);
  return robot.value();
}

Scene scene_from(const std::string& text) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(text, "s.yaml", robot_with_friction(), diagnostics);
  EXPECT_TRUE(scene) << to_string(diagnostics);
  return scene.value();
}

void expect_friction(const Scene& scene, const std::string& joint, double damping, double friction,
                     double width) {
  ASSERT_TRUE(scene.joint_friction.contains(joint)) << joint;
  const SceneFriction& own = scene.joint_friction.at(joint);
  EXPECT_EQ(own.damping, damping) << joint;
  EXPECT_EQ(own.friction, friction) << joint;
  if (friction > 0) {
    EXPECT_EQ(own.width, width) << joint;
  }
}

TEST(ReadJointFriction, CountsWhatTheModelHas) {
  const Scene viscous = scene_from("joint_friction: viscous");
  EXPECT_EQ(viscous.joint_friction.size(), 2U);
  expect_friction(viscous, "a", 0.5, 0, 0);
  expect_friction(viscous, "b", 3, 0, 0);
  EXPECT_FALSE(viscous.implicit_friction);
  const Scene coulomb = scene_from("joint_friction: coulomb");
  EXPECT_EQ(coulomb.joint_friction.size(), 2U);
  expect_friction(coulomb, "a", 0.5, 0.2, 0.01);
  expect_friction(coulomb, "b", 3, 0, 0);
  EXPECT_TRUE(scene_from("joint_friction: none").joint_friction.empty());
  EXPECT_TRUE(scene_from("base: fixed").joint_friction.empty());
}

TEST(ReadJointFriction, PrefersWhatTheSceneSaysOfAJoint) {
  const Scene scene = scene_from(
      "joint_friction: {model: coulomb, width: 0.02, implicit: true, joints: {a: {friction: 0.7}, "
      "b: {damping: 0}, d: {damping: 4, friction: 6, width: 0.1}}}");
  EXPECT_EQ(scene.joint_friction.size(), 2U);
  expect_friction(scene, "a", 0.5, 0.7, 0.02);
  expect_friction(scene, "d", 4, 6, 0.1);
  EXPECT_TRUE(scene.implicit_friction);
}

TEST(ReadJointFriction, TellsWhatIsLeftOut) {
  const auto notes = [](const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_TRUE(parse_scene(text, "s.yaml", robot_with_friction(), diagnostics));
    return to_string(diagnostics);
  };
  const std::string unread = notes("base: fixed");
  EXPECT_NE(unread.find("damping or friction of 2 joints; no function counts them"),
            std::string::npos);
  EXPECT_NE(unread.find("damping or friction of a joint; no function counts them\n"
                        "  only joints of one degree of freedom have friction"),
            std::string::npos)
      << unread;
  const std::string viscous = notes("joint_friction: viscous");
  EXPECT_NE(viscous.find("Coulomb friction of a joint, which"), std::string::npos) << viscous;
  EXPECT_NE(viscous.find("friction of \"c\", a floating joint, is left out"), std::string::npos);
  EXPECT_EQ(notes("joint_friction: none").find("friction"), std::string::npos);
}

// Whatever else could be said is about another model.
TEST(ReadJointFriction, SaysOneThingOfAModelThatIsMisspelt) {
  for (const char* text : {"joint_friction: viscos", "joint_friction: {model: viscos}"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_scene(text, "s.yaml", robot_with_friction(), diagnostics));
    EXPECT_EQ(diagnostics.list().size(), 1U) << to_string(diagnostics);
    EXPECT_NE(to_string(diagnostics).find("did you mean \"viscous\"?"), std::string::npos);
  }
}

TEST(ReadJointSprings, MayBeImplicit) {
  const Scene scene = scene_from("joint_springs: {implicit: true, a: {stiffness: 6}}");
  EXPECT_EQ(scene.joint_springs.size(), 1U);
  EXPECT_TRUE(scene.implicit_friction);
  EXPECT_FALSE(scene_from("joint_springs: {a: {stiffness: 6}}").implicit_friction);
}

TEST(ReadJointSprings, ReadsStiffnessAndRest) {
  const Scene scene =
      scene_from("joint_springs: {a: {stiffness: 6, rest: 0.25}, b: {stiffness: 2}}");
  ASSERT_EQ(scene.joint_springs.size(), 2U);
  EXPECT_EQ(scene.joint_springs.at("a").stiffness, 6);
  EXPECT_EQ(scene.joint_springs.at("a").rest, 0.25);
  EXPECT_EQ(scene.joint_springs.at("b").rest, 0);
}

struct Refused {
  const char* text;
  Expected expected;
};

TEST(ReadJointFriction, RefusesWhatIsNoFriction) {
  const Refused refused[] = {
      {"joint_friction: dry", {kError, 1, "joint_friction", "\"dry\"", ""}},
      {"joint_friction: {width: 1}",
       {kError, 1, "joint_friction", "\"model\" is missing", "coulomb"}},
      {"joint_friction: {model: viscous, width: 1}",
       {kError, 1, "joint_friction/width", "no Coulomb part", "model: coulomb"}},
      {"joint_friction: {model: viscous, joints: {a: {friction: 1}}}",
       {kError, 1, "joint_friction/joints/a/friction", "no Coulomb part", "model: coulomb"}},
      {"joint_friction: {model: coulomb, width: 0}",
       {kError, 1, "joint_friction/width", "0 is not positive", "positive"}},
      {"joint_friction: {model: coulomb, joints: {a: {damping: -1}}}",
       {kError, 1, "joint_friction/joints/a/damping", "-1 is negative", "positive"}},
      {"joint_friction: {model: coulomb, width: 3.0e-4}",
       {kError, 1, "joint_friction", "velocity limit of 2", "4.0e-04 or more"}},
      {"joint_friction: {model: viscous, joints: {c: {damping: 1}}}",
       {kError, 1, "joint_friction/joints/c", "not one degree", "remove"}},
      {"joint_friction: {model: viscous, joints: {e: {damping: 1}}}",
       {kError, 1, "joint_friction/joints/e", "no joint \"e\"", ""}},
      {"joint_friction: {model: viscous, joints: {a: {damping: 0}, b: {damping: 0}}}",
       {kError, 1, "joint_friction", "no joint has damping", "joints:"}},
      {"joint_friction: {model: viscous, implicit: true}\nfunctions: [gravity]",
       {kError, 2, "functions", "no function takes a step", "forward_dynamics"}},
      {"joint_springs: {a: {rest: 1}}",
       {kError, 1, "joint_springs/a", "\"stiffness\" is missing", "N m/rad"}},
      {"joint_springs: {a: {stiffness: 0}}",
       {kError, 1, "joint_springs/a/stiffness", "0 is not positive", "rest"}},
      {"joint_springs: {c: {stiffness: 1}}",
       {kError, 1, "joint_springs/c", "not one degree", "remove"}},
      {"locked: {a: 0}\njoint_springs: {a: {stiffness: 1}}",
       {kError, 2, "joint_springs/a", "is locked", "remove"}},
  };
  for (const Refused& each : refused) {
    SCOPED_TRACE(each.text);
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_scene(each.text, "s.yaml", robot_with_friction(), diagnostics));
    expect_diagnosed(diagnostics, "s.yaml", each.expected);
  }
}

}  // namespace
}  // namespace treeline
