#include "link_loops_fixture.hpp"
#include "mechanism/build_mechanism.hpp"
#include "recursion/parameters/model_parameter.hpp"

// Functions that loop over a table of links, with points of all kinds and what arguments say of a
// robot. Would catch: rows of some axes, or of points on the world, that are wrong; a law of rows
// that yield with other borders than the oracle's; an argument that is read in another frame.

namespace treeline::tests {
namespace {

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

// Of most links an argument gives some of the ten inertial parameters, of some none.
TEST(LinkLoopsCheck, BaseParametersAsAnArgument) {
  auto subjects = load_unmade("samm", "scene.yaml");
  subjects.scene.inputs.base_parameters = true;
  expect_right(subjects, Real::float64, all_with_form());
  auto humanoid = load_unmade("humanoid24", "scene_floating.yaml");
  humanoid.scene.inputs.base_parameters = true;
  humanoid.scene.inputs.payloads.push_back({humanoid.scene.operational_points.front().link});
  expect_safe(humanoid, Real::float64);
}

/// With base parameters as an argument, rotors and friction among them.
Subjects with_base_drives(Subjects subjects) {
  subjects.scene.inputs.base_parameters = true;
  subjects.scene.regressor.rotors = true;
  subjects.scene.regressor.friction = true;
  subjects.scene.regressor.coulomb = true;
  return subjects;
}

// Of some rotors base parameters are named after a link. Springs stay as the files have them, and
// what the argument gives counts in the step too. Would catch: a rotor of another joint, or one
// that a part of a function takes from the table.
TEST(LinkLoopsCheck, RotorsAndFrictionAmongBaseParameters) {
  auto samm = with_base_drives(load_unmade("samm", "scene.yaml"));
  samm.scene.joint_springs["joint2"] = {40, 0.3};
  expect_right(samm, Real::float64, all_with_form());
  auto gripper = with_base_drives(read("published/kinova_gen3_2f85.urdf", kPointAtWrist));
  gripper.scene.base = Base::floating;
  expect_right(gripper, Real::float64, kDynamics);
  auto humanoid = with_base_drives(load_unmade("humanoid24", "scene_floating.yaml"));
  humanoid.scene.regressor.coulomb = false;
  humanoid.scene.joint_friction["knee"] = {1, 5, 0.05};
  humanoid.scene.implicit_friction = true;
  expect_safe(humanoid, Real::float64);
}

// Would catch: Coulomb friction of a joint that mimics at another multiple or width, and a rotor of
// one that stays as the files have it.
TEST(LinkLoopsCheck, RotorsAndFrictionOfFollowersAmongBaseParameters) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const auto [robot, scene] =
        random_mechanism(seed, {.joints = 7, .mimic = 0.7, .rotors = 0.5, .varied_mimics = true});
    const Subjects followers = with_base_drives({robot, scene, {}});
    const auto columns = regressor_columns(build_mechanism(robot, followers.scene));
    ASSERT_TRUE(std::any_of(columns.begin(), columns.end(),
                            [](const ModelParameter& each) { return each.factor != 1; }));
    expect_right(followers, Real::float64, kDynamics);
  }
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

/// Puts the points in strict priority as they are listed.
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

// The link that nothing moves is in every file, and may be named as any other. Its rows yield.
TEST(LinkLoopsCheck, PointsAndForcesOnTheWorld) {
  auto subjects = load_unmade("puma560", "scene.yaml");
  const std::string root = subjects.robot.links.front().name;
  ScenePoint ground = subjects.scene.operational_points.front();
  ground.name = "ground";
  ground.link = root;
  subjects.scene.external_forces.push_back({.name = "push", .link = ground.link});
  subjects.scene.external_forces.push_back({.name = "pull", .link = "link5"});
  auto& points = subjects.scene.operational_points;
  points.insert(points.begin(), ground);
  expect_right(subjects, Real::float64, all_with_form());
  points.front().axes = Axes::local;
  expect_safe(in_priority(subjects), Real::float32);
}

// Functions that do not depend on gravity share the table that those have which do.
TEST(LinkLoopsCheck, GravityAloneAsAnArgument) {
  auto subjects = load_unmade("puma560", "scene.yaml");
  subjects.scene.inputs.gravity = true;
  subjects.scene.sin_cos = Sines::given;
  expect_right(subjects, Real::float32, all_with_form());
}

}  // namespace
}  // namespace treeline::tests
