#include <set>
#include <utility>

#include "link_loops_fixture.hpp"

// Functions that loop over a table of links, of robots of all kinds. Would catch: a recursion that
// is wrong for a kind of joint, for rotors or for branches of the tree; a table in another order
// than the headers read it; C, or code by rules for safe code, that is not what the headers of C++
// say.

namespace treeline::tests {
namespace {

TEST(LinkLoopsCheck, HumanoidOnAFixedBase) {
  expect_right(load_unmade("humanoid24", "scene.yaml"), Real::float64, all_with_form());
}

TEST(LinkLoopsCheck, HumanoidThatFloatsInFloat) {
  expect_right(load_unmade("humanoid24", "scene_floating.yaml"), Real::float32, all_with_form());
}

TEST(LinkLoopsCheck, SafeCodeOfAHumanoidThatFloats) {
  expect_safe(load_unmade("humanoid24", "scene_floating.yaml"), Real::float32);
}

/// With rotors, friction of both kinds and springs in some of its joints.
Subjects with_drives(Subjects subjects) {
  for (const Joint& joint : subjects.robot.joints) {
    if (!info_of(joint.type).has_one_freedom() || joint.mimic) continue;
    subjects.scene.armature[joint.name] = 0.2;
    subjects.scene.joint_friction[joint.name].damping = 3;
    if (joint.child % 3 == 0) subjects.scene.joint_friction[joint.name] = {1, 5, 0.05};
    if (joint.child % 2 == 0) subjects.scene.joint_springs[joint.name] = {40, 0.3};
  }
  return subjects;
}

TEST(LinkLoopsCheck, SlidingJointsDrivesAndSomeRowsOfLocalAxes) {
  auto subjects = with_drives(load_unmade("samm", "scene.yaml"));
  for (ScenePoint& point : subjects.scene.operational_points) {
    point.axes = Axes::local;
    point.rows = {true, true, true, false, false, true};
  }
  expect_right(subjects, Real::float64, all_with_form());
  expect_safe(subjects, Real::float64);
}

TEST(LinkLoopsCheck, CoulombFrictionAlone) {
  auto subjects = load_unmade("planar3r", "scene.yaml");
  for (const Joint& joint : subjects.robot.joints) {
    if (!info_of(joint.type).has_one_freedom()) continue;
    subjects.scene.joint_friction[joint.name] = {0, 2, 0.1};
  }
  expect_right(subjects, Real::float32,
               {Function::inverse_dynamics, Function::gravity, Function::forward_dynamics});
}

/// A random robot with drives and rotors, of which some joint `has` what the test is about. Robots
/// of even seeds float, and try the functions of points too; half of all take friction and springs
/// at the end of a step.
void expect_right_at_random(std::uint64_t seed, RandomOptions options, bool (*has)(const Joint&)) {
  options.drives = 0.5;
  options.rotors = 0.5;
  options.floating_base = seed % 2 == 0;
  const auto [robot, scene] = random_mechanism(seed, options);
  ASSERT_TRUE(std::any_of(robot.joints.begin(), robot.joints.end(), has));
  Subjects unmade{robot, scene, {}};
  unmade.scene.language = language_of(seed);
  unmade.scene.implicit_friction = seed % 4 == 1 || seed % 4 == 2;
  expect_right_in(unmade, seed % 3 == 0 ? Real::float32 : Real::float64,
                  options.floating_base ? all_with_form() : kDynamics);
}

// A gripper whose fingers mimic one joint, as published, and random trees: multiples and offsets,
// joints that carry one another, before and after the one that they mimic.
TEST(LinkLoopsCheck, JointsThatShareCoordinates) {
  const Subjects gripper = read("published/kinova_gen3_2f85.urdf", kPointAtWrist);
  expect_right(gripper, Real::float64, all_with_form());
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.joints = 9;
    options.branching = 0.4;
    options.mimic = 0.5;
    expect_right_at_random(seed, options,
                           [](const Joint& joint) { return joint.mimic.has_value(); });
  }
}

TEST(LinkLoopsCheck, SafeCodeOfSharedCoordinates) {
  expect_safe(read("published/kinova_gen3_2f85.urdf", kPointAtWrist), Real::float32);
}

// Bodies that share the coordinates of their joints, and whose angles are not computed.
TEST(LinkLoopsCheck, GyroscopicRotors) {
  auto subjects = load_unmade("puma560", "scene.yaml");
  subjects.scene.base = Base::floating;
  for (const Joint& joint : subjects.robot.joints) {
    if (!info_of(joint.type).has_one_freedom()) continue;
    SceneRotor& rotor = subjects.scene.rotors[joint.name];
    rotor.inertia = 3e-4;
    rotor.ratio = joint.child % 2 == 0 ? 70 : -1.5;
  }
  expect_right(subjects, Real::float64, all_with_form());
}

// Of a multiple of an angle no sine is given, nor of the angle of a joint that mimics a sliding
// one.
TEST(LinkLoopsCheck, GivenSinesOfSharedCoordinates) {
  Subjects gripper = read("published/kinova_gen3_2f85.urdf", kPointAtWrist);
  gripper.scene.sin_cos = Sines::given;
  expect_right(gripper, Real::float32, all_with_form());
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.joints = 8;
    options.branching = 0.4;
    options.mimic = 0.6;
    auto [robot, scene] = random_mechanism(seed, options);
    scene.sin_cos = Sines::given;
    scene.language = language_of(seed);
    expect_right_in({robot, scene, {}}, Real::float64, kDynamics);
  }
}

// The other functions of the scene take friction and springs as they are. A base that floats,
// joints that slide, that share coordinates, and whose only drives are springs.
TEST(LinkLoopsCheck, FrictionAndSpringsAtTheEndOfAStep) {
  auto samm = with_drives(load_unmade("samm", "scene.yaml"));
  samm.scene.implicit_friction = true;
  expect_right(samm, Real::float64, all_with_form());
  auto gripper = with_drives(read("published/kinova_gen3_2f85.urdf", kPointAtWrist));
  gripper.scene.implicit_friction = true;
  gripper.scene.base = Base::floating;
  expect_right(gripper, Real::float32, kDynamics);
  auto humanoid = load_unmade("humanoid24", "scene_floating.yaml");
  humanoid.scene.joint_springs["knee"] = {40, 0.3};
  humanoid.scene.implicit_friction = true;
  expect_safe(humanoid, Real::float32);
}

// Hips and shoulders of a humanoid; random trees whose ball joints have drives and rotors, beside
// joints that share coordinates, on fixed and floating bases.
TEST(LinkLoopsCheck, BallJoints) {
  const Subjects humanoid = read(
      "written/ball_humanoid.urdf",
      "operational_points: [{name: hand, link: left_forearm}, {name: foot, link: right_foot}]\n");
  expect_right(humanoid, Real::float64, all_with_form());
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.joints = 7;
    options.branching = 0.4;
    options.mix.ball = 3;
    options.mimic = seed % 3 == 0 ? 0.4 : 0;
    expect_right_at_random(seed, options,
                           [](const Joint& joint) { return joint.type == JointType::ball; });
  }
}

// Bodies that a robot carries without holding them, beside joints of all kinds.
TEST(LinkLoopsCheck, FreeJointsBeyondTheBase) {
  for (const std::uint64_t seed : {71U, 72U, 73U, 74U, 76U, 78U}) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.joints = 6;
    options.branching = 0.4;
    options.mix.floating = 5;
    options.mix.ball = seed % 2 == 0 ? 2 : 0;
    options.mimic = seed % 3 == 0 ? 0.4 : 0;
    expect_right_at_random(seed, options,
                           [](const Joint& joint) { return joint.type == JointType::floating; });
  }
}

TEST(LinkLoopsCheck, SafeCodeOfBallJointsWithGivenSines) {
  Subjects humanoid = read("written/ball_humanoid.urdf",
                           "operational_points: [{name: hand, link: left_forearm}]\n");
  humanoid.scene.sin_cos = Sines::given;
  expect_safe(humanoid, Real::float64);
}

// Where small code is asked for, functions that never have this form say nothing of it. Chosen by
// name, it is an error.
TEST(LinkLoopsCheck, FunctionsWithoutThisFormStayAsLines) {
  auto subjects = load_unmade("puma560", "scene.yaml");
  subjects.scene.optimize = Optimize::size;
  subjects.scene.damped.reset();
  subjects.scene.functions = {Function::kinetic_energy};
  Diagnostics diagnostics;
  const auto lines = generate_code(subjects.robot, subjects.scene, {}, diagnostics);
  ASSERT_TRUE(lines);
  EXPECT_FALSE(lines->functions.front().program.loops);
  EXPECT_TRUE(diagnostics.list().empty());
  Choices choices;
  choices.plain[Function::kinetic_energy] = {kLoopsKey};
  EXPECT_FALSE(generate_code(subjects.robot, subjects.scene, {}, diagnostics, choices));
  ASSERT_EQ(diagnostics.list().size(), 1U);
  EXPECT_NE(diagnostics.list().front().fault.find("no such form"), std::string::npos);
}

/// Names of the headers of loops in a generated folder, and the text of all.
std::pair<std::set<std::string>, std::string> loop_headers(const Subjects& subjects) {
  std::pair<std::set<std::string>, std::string> headers;
  for (const GeneratedFile& file : subjects.generation.files) {
    if (!file.name.starts_with("link_")) continue;
    headers.first.insert(file.name.substr(0, file.name.find('.')));
    headers.second += file.text;
  }
  return headers;
}

// Would catch: headers that a reviewer has to read though nothing calls what is in them.
TEST(LinkLoopsCheck, HeadersHaveWhatIsCalledAlone) {
  auto humanoid = load_unmade("humanoid24", "scene.yaml");
  for (const Language language : {Language::cpp, Language::c}) {
    for (const Profile profile : {Profile::plain, Profile::misra}) {
      humanoid.scene.language = language;
      humanoid.scene.profile = profile;
      const auto [names, text] =
          loop_headers(as_loops(humanoid, Real::float32, {Function::mass_matrix}));
      EXPECT_EQ(names, std::set<std::string>{"link_functions"});
      EXPECT_NE(text.find("find_mass_matrix("), std::string::npos);
      for (const char* other :
           {"inverse_dynamics(", "move_links(", "articulate(", "solve_lower("}) {
        EXPECT_EQ(text.find(other), std::string::npos) << other;
      }
    }
  }
}

// Would catch: loops that g++ copies into each function that calls them, 1.6 of 12.5 KB of
// humanoid24's seven functions in float on a Cortex-M4F.
TEST(LinkLoopsCheck, WhatSeveralFunctionsCallStandsAlone) {
  auto humanoid = load_unmade("humanoid24", "scene.yaml");
  const auto stands_alone = [&](const std::vector<Function>& functions) {
    const std::string text = loop_headers(as_loops(humanoid, Real::float32, functions)).second;
    EXPECT_NE(text.find("gather_forces("), std::string::npos);
    const bool alone = text.find("\nTREELINE_LINK_SHARED inline void gather_forces(") != text.npos;
    EXPECT_EQ(text.find("TREELINE_LINK_SHARED") != text.npos, alone);
    return alone;
  };
  const std::vector<Function> two = {Function::inverse_dynamics, Function::control_torque};
  EXPECT_TRUE(stands_alone(two));
  EXPECT_FALSE(stands_alone({Function::inverse_dynamics}));
  humanoid.scene.language = Language::c;  // static functions of each source
  EXPECT_FALSE(stands_alone(two));
  humanoid.scene.language = Language::cpp;
  humanoid.scene.profile = Profile::misra;
  EXPECT_FALSE(stands_alone(two));
}

TEST(LinkLoopsCheck, SmallFunctionsStayAsLines) {
  auto subjects = load_unmade("planar3r", "scene.yaml");
  subjects.scene.optimize = Optimize::size;
  subjects.scene.functions = {Function::gravity};
  for (const auto& generated : generate(subjects.robot, subjects.scene).functions) {
    EXPECT_FALSE(generated.program.loops);
  }
}

}  // namespace
}  // namespace treeline::tests
