// Would catch: settings of a correct scene that are lost or read as something else, and defaults
// that differ from the documented ones.
#include "description/read_scene.hpp"

#include <gtest/gtest.h>

#include "description/scene_queries.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

Scene read(const std::string& text, const Robot& robot = make_robot()) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(text, "s.yaml", robot, diagnostics);
  EXPECT_TRUE(scene) << to_string(diagnostics);
  return scene.value_or(Scene{});
}

Robot single_body(const std::string& inside) {
  Diagnostics diagnostics;
  return parse_urdf("<robot name='drone'><link name='frame'>" + inside + "</link></robot>",
                    "d.urdf", diagnostics)
      .value();
}

// Would catch: a drone that is refused because it has no joints.
TEST(ReadScene, FloatsTheBaseWhereNothingElseMoves) {
  Diagnostics diagnostics;
  const auto scene = parse_scene("real: float", "s.yaml", single_body(kBody), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_EQ(scene->base, Base::floating);
  expect_diagnosed(diagnostics, "s.yaml",
                   {Severity::note, 1, "", "floats, for no joint moves", "base: fixed"});
  Diagnostics fixed;
  EXPECT_FALSE(parse_scene("base: fixed", "s.yaml", single_body(kBody), fixed));
  EXPECT_FALSE(parse_scene("", "s.yaml", single_body(""), fixed));  // nothing to move
}

// Would catch: a missing scene that is an error, or that is accepted without a message.
TEST(ReadScene, NeedsNoFile) {
  Diagnostics diagnostics;
  const auto scene = read_scene("", single_body(kBody), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_EQ(scene->base, Base::floating);
  ASSERT_EQ(diagnostics.list().size(), 1U) << to_string(diagnostics);
  expect_diagnosed(
      diagnostics, "d.urdf",
      {Severity::note, 0, "",
       "there is no scene: functions of the joints alone, and the base floats", "init-scene"});
  Diagnostics of_arm;
  EXPECT_EQ(read_scene("", make_robot(), of_arm)->functions, read("").functions);
  expect_diagnosed(of_arm, "r.urdf", {Severity::note, 0, "", "the base is fixed", "init-scene"});
}

TEST(ReadScene, HasDefaults) {
  const Scene scene = read("");
  EXPECT_EQ(scene.file, "s.yaml");
  EXPECT_EQ(scene.name, "two_arm_1");
  EXPECT_EQ(scene.base, Base::fixed);
  EXPECT_EQ(scene.gravity, (std::array{0.0, 0.0, -9.81}));
  EXPECT_EQ(scene.real, Real::float64);
  EXPECT_EQ(scene.batch, 0);
  EXPECT_TRUE(scene.locked.empty());
  EXPECT_EQ(scene.functions,
            (std::vector{Function::inverse_dynamics, Function::gravity, Function::nonlinear_effects,
                         Function::mass_matrix, Function::forward_dynamics}));
}

TEST(ReadScene, ReadsEverySetting) {
  const Scene scene = read(R"(
name: arm
base: floating
gravity: [0, +1.5, -1e-1]
real: float
batch: 16
damped: {mass: 200, inertia: 1.5}
sin_cos: given
accuracy: best
operational_points:
  - name: tip
    link: tool
    origin: {xyz: [0, 0, 0.1], rpy: [0.1, 0.2, 0.3]}
    rows: [x, z, ry]
    axes: local
  - {name: other, link: rail, rows: [rx]}
external_forces:
  - {name: grip, link: tool, origin: {xyz: [1, 2, 3]}, axes: local}
functions: [control_torque, inverse_dynamics, jacobian, bias_acceleration, lambda_inverse]
locked: {slide: 0.25}
)");
  EXPECT_EQ(scene.name, "arm");
  EXPECT_EQ(scene.base, Base::floating);
  EXPECT_EQ(scene.gravity, (std::array{0.0, 1.5, -0.1}));
  EXPECT_EQ(scene.real, Real::float32);
  EXPECT_EQ(scene.batch, 16);
  EXPECT_EQ(scene.sin_cos, Sines::given);
  EXPECT_EQ(scene.accuracy, Accuracy::best);
  ASSERT_EQ(scene.operational_points.size(), 2U);
  const ScenePoint& tip = scene.operational_points[0];
  EXPECT_EQ(tip.name, "tip");
  EXPECT_EQ(tip.link, "tool");
  EXPECT_EQ(tip.origin.xyz, (std::array{0.0, 0.0, 0.1}));
  EXPECT_EQ(tip.origin.rpy, (std::array{0.1, 0.2, 0.3}));
  EXPECT_EQ(tip.axes, Axes::local);
  EXPECT_EQ(tip.rows, (std::array{true, false, true, false, true, false}));
  EXPECT_EQ(scene.operational_points[1].axes, Axes::world);
  EXPECT_EQ(scene.operational_points[1].rows,
            (std::array{false, false, false, true, false, false}));
  ASSERT_EQ(scene.external_forces.size(), 1U);
  EXPECT_EQ(scene.external_forces[0].origin.xyz, (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ(scene.functions, (std::vector{Function::jacobian, Function::bias_acceleration,
                                          Function::inverse_dynamics, Function::lambda_inverse,
                                          Function::control_torque}));
  ASSERT_TRUE(scene.damped);
  EXPECT_EQ(scene.damped->mass, 200);
  EXPECT_EQ(scene.damped->inertia, 1.5);
  EXPECT_EQ(scene.locked.at("slide"), 0.25);
}

// Would catch: lanes in C that nobody asked for, or asked-for ones that are lost.
TEST(ReadScene, EveryLanguageHasTheLanesOfTheTarget) {
  EXPECT_EQ(read("").language, Language::cpp);
  EXPECT_EQ(read("language: c++").lanes, 8);
  EXPECT_EQ(read("language: c").language, Language::c);
  EXPECT_EQ(read("language: c").lanes, 8);
  EXPECT_EQ(read("{language: c, lanes: 4}").lanes, 4);
  EXPECT_EQ(read("language: opencl").language, Language::opencl);
}

TEST(ReadScene, ChoosesAllFunctionsWithPoints) {
  const Scene scene = read("operational_points: [{name: tip, link: tool, rows: [x, y]}]");
  EXPECT_EQ(scene.functions, std::vector(kDefaultFunctions.begin(), kDefaultFunctions.end()));
}

TEST(ReadScene, ReadsContactsAndTheirFunctions) {
  const Scene scene = read("contacts: [{name: palm, link: tool, origin: {xyz: [0, 0, -0.1]}}]");
  ASSERT_EQ(scene.contacts.size(), 1U);
  EXPECT_EQ(scene.contacts[0].name, "palm");
  EXPECT_EQ(scene.contacts[0].origin.xyz, (std::array{0.0, 0.0, -0.1}));
  EXPECT_EQ(scene.contacts[0].axes, Axes::world);
  EXPECT_EQ(scene.contacts[0].rows, (std::array{true, true, true, false, false, false}));
  const auto lists = [&](Function function) {
    return std::count(scene.functions.begin(), scene.functions.end(), function) == 1;
  };
  EXPECT_TRUE(lists(Function::effective_mass));
  EXPECT_TRUE(lists(Function::contact_motion));
  EXPECT_FALSE(lists(Function::link_inverse_inertias));  // 36 numbers a link: only when asked for
  EXPECT_EQ(read("functions: [link_inverse_inertias]").functions,
            std::vector{Function::link_inverse_inertias});
}

TEST(ReadScene, AllowsMoreRowsThanCoordinatesWithoutLambda) {
  const Scene scene = read(
      "operational_points: [{name: tip, link: tool}]\nfunctions: [forward_kinematics, jacobian]");
  EXPECT_EQ(scene.functions, (std::vector{Function::forward_kinematics, Function::jacobian}));
}

TEST(ReadScene, LeavesOutInversesOfASingularMassMatrix) {
  const Scene scene = read("", make_robot("massless", ""));
  EXPECT_EQ(scene.functions, (std::vector{Function::inverse_dynamics, Function::gravity,
                                          Function::nonlinear_effects, Function::mass_matrix}));
}

TEST(Freedoms, FollowMimicsAndLocks) {
  const Robot robot = make_robot();
  Scene scene;
  EXPECT_EQ(count(find_freedoms(robot, scene)), 3);
  EXPECT_EQ(count(find_freedoms_of_link(robot, scene, "tool")), 2);
  EXPECT_EQ(count(find_freedoms_of_link(robot, scene, "base")), 0);
  EXPECT_EQ(find_freedoms_of_link(robot, scene, "door"),
            find_freedoms_of_link(robot, scene, "rail"));
  scene.base = Base::floating;
  EXPECT_EQ(count(find_freedoms(robot, scene)), 9);
  EXPECT_EQ(count(find_freedoms_of_link(robot, scene, "base")), 6);
  scene.locked = {{"slide", 0.0}};
  EXPECT_EQ(count(find_freedoms(robot, scene)), 8);
  EXPECT_EQ(count(find_freedoms_of_link(robot, scene, "door")), 6);
}

}  // namespace
}  // namespace treeline
