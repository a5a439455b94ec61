// Would catch: settings of a sound scene that are lost or read as something else, and defaults that
// are not the documented ones.
#include "description/read_scene.hpp"

#include <gtest/gtest.h>

#include "description/count_freedoms.hpp"
#include "description/read_urdf.hpp"
#include "diagnosed.hpp"

namespace treeline {
namespace {

const std::string kBody =
    "<inertial><mass value='1'/>"
    "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";

/// base -shoulder-> upper -elbow-> fore -flange-> tool, and base -slide-> rail, -follow-> door with
/// follow mimicking slide.
Robot make_robot(const std::string& name = "two arm-1", const std::string& body = kBody) {
  const auto link = [&](const std::string& n) {
    return "<link name='" + n + "'>" + body + "</link>";
  };
  const auto joint = [](const std::string& n, const std::string& type, const std::string& parent,
                        const std::string& child, const std::string& inside) {
    return "<joint name='" + n + "' type='" + type + "'><parent link='" + parent +
           "'/><child link='" + child + "'/>" + inside + "</joint>";
  };
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='" + name + "'>" + link("base") + link("upper") + link("fore") + link("tool") +
          link("rail") + link("door") + joint("shoulder", "continuous", "base", "upper", "") +
          joint("elbow", "revolute", "upper", "fore",
                "<limit lower='-1' upper='1' effort='1' velocity='1'/>") +
          joint("flange", "fixed", "fore", "tool", "") +
          joint("slide", "prismatic", "base", "rail",
                "<limit lower='0' upper='1' effort='1' velocity='1'/>") +
          joint("follow", "continuous", "base", "door", "<mimic joint='slide'/>") + "</robot>",
      "r.urdf", diagnostics);
  EXPECT_TRUE(robot) << to_string(diagnostics);
  return robot.value();
}

Scene read(const std::string& text, const Robot& robot = make_robot()) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(text, "s.yaml", robot, diagnostics);
  EXPECT_TRUE(scene) << to_string(diagnostics);
  return scene.value_or(Scene{});
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

TEST(ReadScene, ChoosesAllFunctionsWithPoints) {
  const Scene scene = read("operational_points: [{name: tip, link: tool, rows: [x, y]}]");
  EXPECT_EQ(scene.functions, std::vector(kAllFunctions.begin(), kAllFunctions.end()));
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

struct Case {
  std::string name;
  std::string text;
  Expected expected;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class BadScene : public testing::TestWithParam<Case> {};

TEST_P(BadScene, IsDiagnosed) {
  const Case& c = GetParam();
  Diagnostics diagnostics;
  const auto scene = parse_scene(c.text, "bad.yaml", make_robot(), diagnostics);
  EXPECT_EQ(scene.has_value(), c.expected.severity != Severity::error) << to_string(diagnostics);
  expect_diagnosed(diagnostics, "bad.yaml", c.expected);
}

constexpr auto kError = Severity::error;
constexpr auto kWarning = Severity::warning;

const Case kCases[] = {
    {"NotYaml", "a: [\n", {kError, 2, "", "not well-formed YAML", "mend"}},
    {"NotUtf8", "name: \xFF\n", {kError, 0, "", "not UTF-8", ""}},
    {"TwoDocuments", "name: a\n---\nname: b\n", {kError, 2, "", "more than one document", ""}},
    {"StartsWithComma", ", name: a", {kError, 1, "", "more than one document", ""}},
    {"NoMap",
     "just text",
     {kError, 1, "", "a map is expected here, not \"just text\"", "key: value"}},
    {"UnknownKey",
     "\ngravty: [0, 0, 0]",
     {kError, 2, "gravty", "\"gravty\" is unknown", "did you mean \"gravity\"?"}},
    {"KeyTwice", "base: fixed\nbase: fixed", {kError, 2, "base", "given twice", "keep one"}},
    {"MergeKey", "<<: {base: fixed}", {kError, 1, "<<", "unknown", ""}},
    {"NoIdentifier",
     "name: left-arm",
     {kError, 1, "name", "\"left-arm\" cannot", "write left_arm"}},
    {"Keyword", "name: class", {kError, 1, "name", "\"class\" cannot", "write class_"}},
    {"EmptyName", "name:\nbase: fixed", {kError, 1, "name", "not empty", "one word"}},
    {"UnknownBase",
     "base: flaoting",
     {kError, 1, "base", "\"flaoting\"", "did you mean \"floating\"?"}},
    {"ShortGravity",
     "gravity: [0, 0]",
     {kError, 1, "gravity", "three numbers is expected here, not 2", "[x, y, z]"}},
    {"QuotedNumber",
     "gravity: [0, 0, '1']",
     {kError, 1, "gravity[2]", "finite number", "without quotes"}},
    {"InfiniteNumber", "gravity: [0, 0, inf]", {kError, 1, "gravity[2]", "finite number", ""}},
    {"YamlInfinity", "gravity: [0, 0, .inf]", {kError, 1, "gravity[2]", "finite number", ""}},
    {"UnknownReal", "real: doubel", {kError, 1, "real", "\"doubel\"", "did you mean \"double\"?"}},
    {"NoList", "functions: jacobian", {kError, 1, "functions", "a list is expected", "- item"}},
    {"UnknownFunction",
     "functions:\n  - lamda",
     {kError, 2, "functions[0]", "\"lamda\"", "did you mean \"lambda\"?"}},
    {"FunctionTwice",
     "functions: [gravity, gravity]",
     {kError, 1, "functions[1]", "twice", "once"}},
    {"NoFunction", "functions: []", {kError, 1, "functions", "no function", "leave out"}},
    {"FunctionWithoutPoints",
     "functions: [jacobian]",
     {kError, 1, "", "no operational point", "operational_points"}},
    {"UnknownLink",
     "operational_points:\n- name: a\n  link: tol",
     {kError, 3, "operational_points[0]/link", "no link \"tol\"", "did you mean \"tool\"?"}},
    {"NoLink",
     "operational_points: [{name: a}]",
     {kError, 1, "operational_points[0]", "\"link\" is missing", "link"}},
    {"NoPointName",
     "operational_points: [{link: tool}]",
     {kError, 1, "operational_points[0]", "\"name\" is missing", "name"}},
    {"BadPointName",
     "operational_points: [{name: 1a, link: tool}]",
     {kError, 1, "operational_points[0]/name", "\"1a\" cannot", "n1a"}},
    {"PointTwice",
     "operational_points:\n- {name: a, link: tool, rows: [x]}\n- {name: a, link: rail, rows: [x]}",
     {kError, 3, "operational_points[1]", "\"a\" is already taken", "its own"}},
    {"UnknownRow",
     "operational_points: [{name: a, link: tool, rows: [xx]}]",
     {kError, 1, "operational_points[0]/rows[0]", "\"xx\"", "did you mean \"x\"?"}},
    {"RowTwice",
     "operational_points: [{name: a, link: tool, rows: [x, x]}]",
     {kError, 1, "operational_points[0]/rows[1]", "twice", ""}},
    {"RowsOutOfOrder",
     "operational_points: [{name: a, link: tool, rows: [y, x]}]",
     {kError, 1, "operational_points[0]/rows[1]", "order", "x y z rx ry rz"}},
    {"NoRow",
     "operational_points: [{name: a, link: tool, rows: []}]",
     {kError, 1, "operational_points[0]/rows", "no row", "leave out"}},
    {"PriorityZero",
     "operational_points: [{name: a, link: tool, rows: [x], priority: 0}]",
     {kError, 1, "operational_points[0]/priority", "0 is no priority", "from 1 on"}},
    {"PriorityBetween",
     "operational_points: [{name: a, link: tool, rows: [x], priority: 1.5}]",
     {kError, 1, "operational_points[0]/priority", "1.5 is no priority", "whole number"}},
    {"PriorityInWords",
     "operational_points: [{name: a, link: tool, rows: [x], priority: high}]",
     {kError, 1, "operational_points[0]/priority", "finite number", ""}},
    {"PriorityOfAForce",
     "external_forces: [{name: a, link: tool, priority: 1}]",
     {kError, 1, "external_forces[0]/priority", "unknown", "the keys here are"}},
    {"UnknownOriginKey",
     "operational_points: [{name: a, link: tool, origin: {xzy: [0, 0, 0]}}]",
     {kError, 1, "operational_points[0]/origin/xzy", "unknown", "did you mean \"xyz\"?"}},
    {"RowsOfAForce",
     "external_forces: [{name: a, link: tool, rows: [x]}]",
     {kError, 1, "external_forces[0]/rows", "unknown", "the keys here are"}},
    {"MoreRowsThanLinkMoves",
     "operational_points: [{name: a, link: tool, rows: [x, y, z]}]",
     {kError, 1, "", "\"a\" has 3 rows, but its link \"tool\" moves with 2 coordinates",
      "fewer rows"}},
    {"MoreRowsTogether",
     "operational_points: [{name: a, link: tool, rows: [x, y]}, {name: b, link: fore, rows: [x]}]",
     {kError, 1, "", "3 rows together, but 2 coordinates", "fewer rows"}},
    {"PointOnTheGround",
     "operational_points: [{name: a, link: base, rows: [x]}]",
     {kError, 1, "", "moves with 0 coordinates", "fewer rows"}},
    {"LockedUnknown",
     "locked: {elbw: 1}",
     {kError, 1, "locked/elbw", "no joint \"elbw\"", "did you mean \"elbow\"?"}},
    {"LockedFixed", "locked: {flange: 1}", {kError, 1, "locked/flange", "fixed", "remove"}},
    {"LockedMimic", "locked: {follow: 1}", {kError, 1, "locked/follow", "mimics", "\"slide\""}},
    {"LockedNoNumber", "locked: {elbow: up}", {kError, 1, "locked/elbow", "not \"up\"", "decimal"}},
    {"LockedOutside",
     "locked: {elbow: 2}",
     {kWarning, 1, "locked/elbow", "2 is outside the joint's limits, -1 to 1", "unit"}},
    {"AllLocked",
     "locked: {elbow: 0, shoulder: 0, slide: 0}",
     {kError, 1, "", "nothing moves", "floating"}},
    {"AxesOfAContact",
     "contacts: [{name: a, link: tool, axes: world}]",
     {kError, 1, "contacts[0]/axes", "unknown", "the keys here are"}},
    {"ContactOnTheGround",
     "contacts: [{name: a, link: base}]",
     {kError, 1, "", "\"a\" is on link \"base\", which cannot move", "a joint that moves"}},
    {"NoContact",
     "functions: [effective_mass]",
     {kError, 1, "", "effective_mass is listed, but there is no contact", "contacts"}},
    {"UnusedContact",
     "contacts: [{name: a, link: tool}]\nfunctions: [gravity]",
     {kWarning, 1, "", "no function takes them", "add"}},
    {"DampedNeedsFunctions",
     "damped: {mass: 1, inertia: 1}\noperational_points: [{name: a, link: tool, rows: [x]}]\n"
     "functions: [jacobian, bias_acceleration, inverse_dynamics]",
     {kError, 1, "", "damped needs lambda_inverse", "add it to functions"}},
    {"DampedNeedsPoints",
     "damped: {mass: 1, inertia: 1}",
     {kError, 1, "", "damped needs jacobian", "operational_points"}},
    {"DampedNeedsInertia",
     "damped: {mass: 1}\noperational_points: [{name: a, link: tool, rows: [x]}]",
     {kError, 1, "damped", "\"inertia\" is missing", "kg m^2"}},
    {"DampedIsPositive",
     "damped: {mass: 1, inertia: 0}\noperational_points: [{name: a, link: tool, rows: [x]}]",
     {kError, 1, "damped/inertia", "not positive", "yields"}},
    {"UnusedForce",
     "external_forces: [{name: a, link: tool}]\nfunctions: [gravity]",
     {kWarning, 1, "", "no function takes them", "add"}},
};
INSTANTIATE_TEST_SUITE_P(Cases, BadScene, testing::ValuesIn(kCases),
                         [](const testing::TestParamInfo<Case>& c) { return c.param.name; });

TEST(BadSceneRobot, HasJointsOfOneIdentifier) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='r'><link name='a'/><link name='b'>" + kBody + "</link><link name='c'>" + kBody +
          "</link><joint name='j-1' type='continuous'><parent link='a'/><child link='b'/></joint>"
          "<joint name='j.1' type='continuous'><parent link='a'/><child link='c'/></joint></robot>",
      "r.urdf", diagnostics);
  ASSERT_TRUE(robot);
  EXPECT_FALSE(parse_scene("", "s.yaml", *robot, diagnostics));
  expect_diagnosed(diagnostics, "s.yaml",
                   {kError, 0, "", "\"j-1\" and \"j.1\" of r.urdf would both be j_1", "rename"});
}

TEST(BadSceneRobot, IsSingular) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_scene("functions: [forward_dynamics]", "s.yaml", make_robot("massless", ""),
                           diagnostics));
  expect_diagnosed(diagnostics, "s.yaml",
                   {kError, 1, "", "nothing beyond joint \"shoulder\" has mass", "lock"});
}

// Would catch a centre of mass that is 0/0.
TEST(BadSceneRobot, HasNoMassToHaveACentre) {
  Robot robot = make_robot("massless", "");
  for (Link& link : robot.links) link.inertial.reset();
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_scene("functions: [center_of_mass]", "s.yaml", robot, diagnostics));
  expect_diagnosed(diagnostics, "s.yaml", {kError, 1, "", "no link has mass", "URDF"});
}

}  // namespace
}  // namespace treeline
