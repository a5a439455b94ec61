#include "data/list_data.hpp"
#include "fixture.hpp"
#include "recursion/routes/trace_loops.hpp"

// Functions that loop over a table of links, from the file to the compiled code, against 50 digits
// and against their own bounds. Would catch: a recursion that is wrong for a kind of joint, for
// rotors, for branches of the tree or for rows of some axes; a table in another order than the
// headers read it; a law of rows that yield with other borders than the oracle's; C, or code by
// rules for safe code, that is not what the headers of C++ say.

namespace treeline::tests {
namespace {

const std::vector<Function> kDynamics = {Function::inverse_dynamics, Function::gravity,
                                         Function::nonlinear_effects, Function::mass_matrix,
                                         Function::forward_dynamics};
const std::vector<Function> kOfPoints = {Function::lambda_inverse, Function::lambda,
                                         Function::control_torque};

const char* const kPointAtWrist =
    "operational_points: [{name: wrist, link: gen3_end_effector_link}]\n";

/// The robot with these functions, all as loops, in the language and profile of its scene.
Subjects as_loops(Subjects subjects, Real real, std::vector<Function> functions) {
  subjects.scene.optimize = Optimize::size;
  subjects.scene.real = real;
  subjects.scene.lanes = 1;
  subjects.scene.damped.reset();
  subjects.scene.functions = std::move(functions);
  Choices choices;
  for (const Function function : subjects.scene.functions) choices.plain[function] = {kLoopsKey};
  Diagnostics diagnostics;
  auto generation =
      generate_code(subjects.robot, subjects.scene,
                    {"robot.urdf", "no text", "scene.yaml", "no text"}, diagnostics, choices);
  for (const Diagnostic& diagnostic : diagnostics.list()) ADD_FAILURE() << to_string(diagnostic);
  if (!generation) throw std::runtime_error("nothing generated");
  subjects.generation = std::move(*generation);
  return subjects;
}

std::vector<Function> all_with_form() {
  std::vector<Function> functions = kDynamics;
  functions.insert(functions.end(), kOfPoints.begin(), kOfPoints.end());
  std::sort(functions.begin(), functions.end());
  return functions;
}

void expect_right_in(const Subjects& unmade, Real real, const std::vector<Function>& of) {
  const Subjects subjects = as_loops(unmade, real, of);
  for (const GeneratedFunction& generated : subjects.generation.functions) {
    EXPECT_TRUE(generated.program.loops) << generated.program.name;
  }
  CheckOptions options = quick_options(24);
  options.compile.flags += " -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror";
  const auto report = check_or_throw(subjects, options);
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(report.functions.size(), of.size());
  for (const FunctionReport& function : report.functions) {
    EXPECT_TRUE(function.bits_known) << function.name;
    EXPECT_EQ(function.bits_differ, 0) << function.name;
  }
}

/// Random robots take turns: half of the seeds are in C. Published ones are tried in both
/// languages.
Language language_of(std::uint64_t seed) {
  return seed % 4 < 2 ? Language::cpp : Language::c;
}

/// In both languages, whose loops are held to the bits of one graph.
void expect_right(Subjects unmade, Real real, const std::vector<Function>& of) {
  for (const Language language : {Language::cpp, Language::c}) {
    SCOPED_TRACE(language == Language::c ? "C" : "C++");
    unmade.scene.language = language;
    expect_right_in(unmade, real, of);
  }
}

/// Of `profile: misra`, which may not have other bits either.
void expect_safe(Subjects unmade, Real real) {
  unmade.scene.profile = Profile::misra;
  expect_right(std::move(unmade), real, all_with_form());
}

Subjects read(const std::string& urdf, const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto robot = read_urdf(data_file(urdf), diagnostics);
  if (!robot) throw std::runtime_error("the robot cannot be read");
  const auto scene = parse_scene(scene_text, "scene.yaml", *robot, diagnostics);
  if (!scene) throw std::runtime_error("the scene cannot be read");
  return {*robot, *scene, {}};
}

/// No function loops, and a single note says why.
void expect_lines(const Subjects& subjects, const std::string& why) {
  Diagnostics diagnostics;
  const auto generation = generate_code(subjects.robot, subjects.scene,
                                        {"robot.urdf", "", "scene.yaml", ""}, diagnostics);
  ASSERT_TRUE(generation);
  for (const auto& generated : generation->functions) EXPECT_FALSE(generated.program.loops);
  ASSERT_EQ(diagnostics.list().size(), 1U);
  const Diagnostic& note = diagnostics.list().front();
  EXPECT_EQ(note.severity, Severity::note);
  EXPECT_NE(note.fault.find(why), std::string::npos) << to_string(note);
}

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

// Some angles of the humanoid have offsets.
TEST(LinkLoopsCheck, GivenSinesAndPlainSolves) {
  for (const char* robot : {"ur10e", "humanoid24"}) {
    auto subjects = load_unmade(robot, "scene.yaml");
    subjects.scene.sin_cos = Sines::given;
    subjects.scene.singular = SingularTasks::exact;
    const std::vector<Function> functions = {Function::inverse_dynamics, Function::control_torque};
    for (const auto& each : as_loops(subjects, Real::float64, functions).generation.functions) {
      EXPECT_EQ(each.program.arguments[1].name, "sin_q") << robot;
      EXPECT_EQ(each.program.arguments[2].name, "cos_q") << robot;
    }
    expect_right(subjects, Real::float64, functions);
  }
}

/// With gravity, a payload on the last link, parameters of three links and two tools as arguments:
/// one of a quaternion of any length, one on the same link as another.
Subjects with_inputs(Subjects subjects) {
  Scene& scene = subjects.scene;
  scene.inputs.gravity = true;
  for (const Link& link : subjects.robot.links) {
    if (!link.inertial) continue;
    if (scene.inputs.parameters.size() < 3) scene.inputs.parameters.push_back({link.name});
  }
  scene.inputs.payloads.push_back({scene.operational_points.front().link});
  scene.inputs.payloads.push_back({scene.inputs.parameters.back().link});
  for (const ScenePoint& point : scene.operational_points) {
    scene.inputs.tools.push_back({point.name, 0.5, point.axes == Axes::local});
  }
  return subjects;
}

TEST(LinkLoopsCheck, PayloadsParametersToolsAndGravityAsArguments) {
  auto subjects = load_unmade("samm", "scene.yaml");
  for (ScenePoint& point : subjects.scene.operational_points) point.axes = Axes::local;
  subjects.scene.operational_points.back().axes = Axes::world;
  expect_right(with_inputs(subjects), Real::float64, all_with_form());
  expect_safe(with_inputs(load_unmade("humanoid24", "scene_floating.yaml")), Real::float32);
}

// At points with axes of the world and of their links, on bases that are fixed and that float.
TEST(LinkLoopsCheck, ExternalForces) {
  auto subjects = load_unmade("samm", "scene.yaml");
  const std::string link = subjects.scene.operational_points.front().link;
  subjects.scene.external_forces.push_back({.name = "push", .link = link});
  subjects.scene.external_forces.push_back(
      {.name = "pull", .link = link, .origin = {{0.1, -0.2, 0.3}, {1, 2, 3}}, .axes = Axes::local});
  const std::vector<Function> functions = {Function::inverse_dynamics, Function::gravity,
                                           Function::forward_dynamics, Function::control_torque};
  expect_right(subjects, Real::float64, functions);
  subjects.scene.base = Base::floating;
  subjects.scene.profile = Profile::misra;
  expect_right(subjects, Real::float32, functions);
}

/// Its points in strict priority as they are listed.
Subjects in_priority(Subjects subjects) {
  int priority = 1;
  for (ScenePoint& point : subjects.scene.operational_points) point.priority = priority++;
  return subjects;
}

// Two hands and a point that asks of the first hand's link what it does already; random trees with
// more rows than freedoms, some of which nothing moves: on sliding joints alone nothing turns.
TEST(LinkLoopsCheck, Priorities) {
  auto humanoid = load_unmade("humanoid24", "scene_floating.yaml");
  ScenePoint again = humanoid.scene.operational_points.front();
  again.name = "again";
  humanoid.scene.operational_points.push_back(again);
  expect_right(in_priority(humanoid), Real::float64, kOfPoints);
  humanoid.scene.singular = SingularTasks::exact;
  humanoid.scene.operational_points.pop_back();
  expect_safe(in_priority(humanoid), Real::float32);
  for (std::uint64_t seed = 51; seed <= 54; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.joints = 7;
    options.mix = seed == 52 ? JointMix{0, 0, 1, 0, 0, 0} : JointMix{4, 3, 1, 0, 0, 1};
    options.mimic = seed == 53 ? 0.5 : 0;
    options.operational_points = 3;
    auto [robot, scene] = random_mechanism(seed, options);
    scene.language = language_of(seed);
    expect_right_in(in_priority({robot, scene, {}}), seed == 54 ? Real::float32 : Real::float64,
                    {Function::control_torque});
  }
}

// What comes first stands last or in the middle, some rows are not controlled, and two points share
// a priority. Lambda and its inverse stay in the scene's order.
TEST(LinkLoopsCheck, PrioritiesInAnotherOrderThanPoints) {
  auto samm = load_unmade("samm", "scene.yaml");
  ScenePoint first = samm.scene.operational_points.front();
  first.name = "first";
  first.rows = {true, false, true, false, true, false};
  first.axes = Axes::local;
  for (ScenePoint& point : samm.scene.operational_points) point.priority = 3;
  samm.scene.operational_points.push_back(first);
  expect_right(samm, Real::float64, kOfPoints);
  auto humanoid = load_unmade("humanoid24", "scene_floating.yaml");
  humanoid.scene.operational_points.front().priority = 2;
  expect_safe(humanoid, Real::float32);
  for (std::uint64_t seed = 61; seed <= 64; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.joints = 7;
    options.mimic = seed == 63 ? 0.5 : 0;
    options.operational_points = 3;
    auto [robot, scene] = random_mechanism(seed, options);
    scene.language = language_of(seed);
    for (std::size_t k = 0; k < 3; ++k) {
      scene.operational_points[k].priority = static_cast<int>((k + seed) % 3 + 1);
    }
    expect_right_in({robot, scene, {}}, Real::float64, kOfPoints);
  }
}

// Functions that do not depend on gravity share the table that those have which do.
TEST(LinkLoopsCheck, GravityAloneAsAnArgument) {
  auto subjects = load_unmade("puma560", "scene.yaml");
  subjects.scene.inputs.gravity = true;
  subjects.scene.sin_cos = Sines::given;
  expect_right(subjects, Real::float32, all_with_form());
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

TEST(LinkLoopsCheck, SafeCodeOfBallJointsWithGivenSines) {
  Subjects humanoid = read("written/ball_humanoid.urdf",
                           "operational_points: [{name: hand, link: left_forearm}]\n");
  humanoid.scene.sin_cos = Sines::given;
  expect_safe(humanoid, Real::float64);
}

// Nothing is said of the function that never has this form.
TEST(LinkLoopsCheck, WhatTheTableCannotSayStaysAsLines) {
  auto subjects = load_unmade("puma560", "scene.yaml");
  subjects.scene.optimize = Optimize::size;
  subjects.scene.damped.reset();
  subjects.scene.functions = {Function::inverse_dynamics, Function::kinetic_energy};
  subjects.scene.inputs.base_parameters = true;
  expect_lines(subjects, "base parameters");
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
