// Base parameters that are known by hand or from the literature. Would catch: a combination with
// another coefficient, name or order, and weight that is felt where no gravity acts along.
#include "recursion/parameters/base_parameters.hpp"

#include <gtest/gtest.h>

#include "description/read_urdf.hpp"
#include "mechanism/build_mechanism.hpp"
#include "random_mechanism.hpp"

namespace treeline::tests {
namespace {

/// A serial arm of hinges, one metre apart along x, with these axes.
RandomMechanism arm(const std::vector<std::array<double, 3>>& axes) {
  RandomMechanism made;
  made.robot.links.push_back({"base", {}, 0});
  made.robot.root = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Joint joint;
    joint.name = "joint" + std::to_string(i + 1);
    joint.type = JointType::revolute;
    joint.parent = static_cast<int>(i);
    joint.child = static_cast<int>(i) + 1;
    if (i > 0) joint.origin.xyz = {1, 0, 0};
    joint.axis = axes[i];
    made.robot.joints.push_back(joint);
    made.robot.links.push_back({"link" + std::to_string(i + 1), {}, 0});
  }
  return made;
}

std::vector<std::string> described(const RandomMechanism& made, const SceneRegressor& asked = {}) {
  const BaseParameters found = find_base_parameters(build_mechanism(made.robot, made.scene), asked);
  std::vector<std::string> texts;
  for (const BaseParameter& base : found.base) texts.push_back(describe(base, found));
  return texts;
}

// By hand: the elbow's mass hangs on the upper arm, and gravity acts on both.
TEST(BaseParameters, OfTwoHingesInAVerticalPlane) {
  const auto texts = described(arm({{0, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(texts,
            (std::vector<std::string>{"link1 mc_x + link2 m", "link1 mc_z", "link1 Iyy + link2 m",
                                      "link2 mc_x", "link2 mc_z", "link2 Iyy"}));
}

// By hand: with vertical axes no weight is felt. A rotor at the base turns with the link.
TEST(BaseParameters, OfTwoHingesInAHorizontalPlane) {
  SceneRegressor asked;
  asked.rotors = true;
  const auto texts = described(arm({{0, 0, 1}, {0, 0, 1}}), asked);
  EXPECT_EQ(texts, (std::vector<std::string>{"link1 Izz + link2 m + joint1 rotor", "link2 mc_x",
                                             "link2 mc_y", "link2 Izz", "joint2 rotor"}));
}

// With gravity as an argument, which may have any direction, weight is felt there too.
TEST(BaseParameters, FeelGravityThatIsAnArgument) {
  RandomMechanism made = arm({{0, 0, 1}});
  EXPECT_EQ(described(made), std::vector<std::string>{"link1 Izz"});
  made.scene.inputs.gravity = true;
  EXPECT_EQ(described(made), (std::vector<std::string>{"link1 mc_x", "link1 mc_y", "link1 Izz"}));
}

// By hand: of what the second link turns about the first axis, Ixx s^2 + Izz c^2 = Izz + (Ixx -
// Izz) s^2, where the mass of the third adds one to Izz, and another one from where the second axis
// is.
TEST(BaseParameters, OfAHingeAcrossAnother) {
  const auto texts = described(arm({{0, 0, 1}, {0, 1, 0}, {0, 0, 1}}));
  ASSERT_EQ(texts.size(), 15U);
  EXPECT_EQ(texts[0], "link1 Izz + link2 m + link2 Izz + 2 link3 m");
}

// Two fingers that always open alike: only the sum of their masses is felt in the motion.
TEST(BaseParameters, OfFingersThatMoveAlike) {
  RandomMechanism made;
  made.robot.links = {{"palm", {}, 0}, {"left", {}, 0}, {"right", {}, 0}};
  made.robot.root = 0;
  for (int i = 0; i < 2; ++i) {
    Joint joint;
    joint.name = i == 0 ? "left_joint" : "right_joint";
    joint.type = JointType::prismatic;
    joint.parent = 0;
    joint.child = i + 1;
    joint.axis = {i == 0 ? 1.0 : -1.0, 0, 0};
    if (i == 1) joint.mimic = Mimic{0, 1, 0};
    made.robot.joints.push_back(joint);
  }
  EXPECT_EQ(described(made), std::vector<std::string>{"left m + right m"});
  made.scene.gravity = {-9.81, 0, 0};  // lifts one and lowers the other
  EXPECT_EQ(described(made), (std::vector<std::string>{"left m", "right m"}));
}

/// Two hinges in a horizontal plane, the second at `multiplier` times the first.
RandomMechanism geared_arm(double multiplier) {
  RandomMechanism made = arm({{0, 0, 1}, {0, 0, 1}});
  made.robot.joints[1].mimic = Mimic{0, multiplier, 0.3};
  return made;
}

const SceneRegressor kAllDrives{.rotors = true, .friction = true, .coulomb = true};

// By hand: at the rate qd of the first joint the second turns by -2 qd, and the second link by -qd.
// What rotor and viscous friction of the second take counts four times at the first. Its Coulomb
// friction is 2 s(2 qd / w), another function.
TEST(BaseParameters, OfAJointThatFollowsAnother) {
  const RandomMechanism made = geared_arm(-2);
  EXPECT_EQ(
      described(made, kAllDrives),
      (std::vector<std::string>{"link1 Izz + link2 m + link2 Izz + joint1 rotor + 4 joint2 rotor",
                                "link2 mc_x", "link2 mc_y", "joint1 viscous + 4 joint2 viscous",
                                "joint1 coulomb", "joint2 coulomb"}));
  const auto columns = list_model_parameters(build_mechanism(made.robot, made.scene), kAllDrives);
  ASSERT_EQ(columns.size(), 26U);
  EXPECT_EQ(sign_of(columns[24]), "s(qd / 0.01)");
  EXPECT_EQ(sign_of(columns[25]), "2 s(2 qd / 0.01)");
}

// By hand: of the same width where it is felt, friction of both is one function of qd.
TEST(BaseParameters, AddCoulombFrictionOfTheSameWidth) {
  EXPECT_EQ(described(geared_arm(-1), kAllDrives).back(), "joint1 coulomb + joint2 coulomb");
  RandomMechanism made = geared_arm(-2);
  made.scene.joint_friction["joint2"] = {0.3, 0.1, 0.02};
  EXPECT_EQ(described(made, kAllDrives).back(), "joint1 coulomb + 2 joint2 coulomb");
}

// By hand, as the scene states them: 0.5 + 4 * 0.3, 0.2 and 0.1, 4 * 0.7.
TEST(BaseParameters, OfAFollowerHaveValuesOfTheScene) {
  RandomMechanism made = geared_arm(-2);
  made.scene.armature["joint2"] = 0.7;
  made.scene.joint_friction = {{"joint1", {0.5, 0.2, 0.01}}, {"joint2", {0.3, 0.1, 0.05}}};
  const Mechanism mechanism = build_mechanism(made.robot, made.scene);
  const BaseParameters found = find_base_parameters(mechanism, kAllDrives);
  ASSERT_EQ(found.base.size(), 6U);
  const std::vector<double> values{2.8, 0, 0, 1.7, 0.2, 0.1};
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_NEAR(static_cast<double>(value_in_files(found.base[k], found, mechanism)), values[k],
                1e-15)
        << describe(found.base[k], found);
  }
}

// A joint that multiplies by 0 never moves: nothing is felt of what sits in it.
TEST(BaseParameters, OfAFollowerThatNeverMoves) {
  const RandomMechanism made = geared_arm(0);
  const auto columns = list_model_parameters(build_mechanism(made.robot, made.scene), kAllDrives);
  ASSERT_EQ(columns.size(), 23U);
  EXPECT_EQ(name_of(columns.back()), "joint1 coulomb");
}

// A joint may have the name of the base that floats, which has no motor.
TEST(BaseParameters, OfAJointThatIsCalledBase) {
  RandomMechanism made = arm({{0, 0, 1}});
  made.robot.joints[0].name = "base";
  made.scene.base = Base::floating;
  made.scene.armature["base"] = 0.5;
  const Mechanism mechanism = build_mechanism(made.robot, made.scene);
  EXPECT_EQ(mechanism.links[0].drive.inertia, 0);
  EXPECT_EQ(mechanism.links[1].drive.inertia, 0.5);
  const auto texts = described(made, kAllDrives);
  EXPECT_EQ(texts[texts.size() - 2], "base viscous");
  EXPECT_EQ(texts.back(), "base coulomb");
}

// Counts of the literature: 36 for the PUMA 560 (Armstrong, Khatib & Burdick 1986 count them;
// Mayeda, Yoshida & Osuka 1990: 7 n - 4 for hinges, less 2 of the first axis along gravity).
TEST(BaseParameters, CountsOfTheLiterature) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(TREELINE_ROBOTS_DIR "/puma560/puma560.urdf", diagnostics);
  ASSERT_TRUE(robot);
  const Mechanism mechanism = build_mechanism(*robot, {});
  EXPECT_EQ(find_base_parameters(mechanism, {}).base.size(), 36U);
  SceneRegressor with_rotors;
  with_rotors.rotors = true;
  // Those of the first two joints cannot be told from Izz of links that turn about one axis only
  // (Khalil & Dombre, Modeling, Identification and Control of Robots, section 9.4).
  EXPECT_EQ(find_base_parameters(mechanism, with_rotors).base.size(), 40U);
}

}  // namespace
}  // namespace treeline::tests
