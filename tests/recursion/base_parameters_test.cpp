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
