// Would catch: a fault in a scene that passes, or that is reported at another place or without a
// remedy.
#include <gtest/gtest.h>

#include "description/read_scene.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

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
    {"NotUtf8", "name: \xFF\n", {kError, 0, "", "not UTF-8", "save it as UTF-8"}},
    {"Utf16", std::string("\xFF\xFEn\0", 4), {kError, 0, "", "not UTF-8", "save it as UTF-8"}},
    {"Tab",
     "name: a\n# list\noperational_points:\n\t- name: a\n",
     {kError, 4, "", "a tab indents this line", "spaces"}},
    {"NotYamlThoughTabsStandElsewhere", "name:\ta\nb: [\n", {kError, 3, "", "not well-formed", ""}},
    {"TwoDocuments",
     "name: a\n---\nname: b\n",
     {kError, 2, "", "more than one document", "keep one"}},
    {"OutdentedLine",
     "  name: a\nbase: fixed\n",
     {kError, 2, "", "indented less than the first", "same column"}},
    // Other programs read degrees here.
    {"TagOfAValue",
     "name: a\nlocked: {elbow: !degrees 90}\n",
     {kError, 2, "", "the tag !degrees has no meaning", "in radians"}},
    {"TagOfAList", "gravity: !up [0, 0, 9]", {kError, 1, "", "the tag !up has no meaning", ""}},
    {"StartsWithComma", ", name: a", {kError, 1, "", "more than one document", ""}},
    {"NoMap",
     "just text",
     {kError, 1, "", "a map is expected here, not \"just text\"", "key: value"}},
    {"UnknownKey",
     "\ngravty: [0, 0, 0]",
     {kError, 2, "gravty", "\"gravty\" is unknown", "did you mean \"gravity\"?"}},
    {"KeyTwice", "base: fixed\nbase: fixed", {kError, 2, "base", "given twice", "keep one"}},
    {"AliasOfAValue",
     "name: &word floating\nbase: *word\nreal:\n  *word\n",
     {kError, 4, "real", "\"floating\" is not known here", "float, double"}},
    {"AliasInAList",
     "operational_points:\n- &point {name: a, link: tool, rows: [x]}\n- *point\n",
     {kError, 3, "operational_points[1]", "\"a\" is already taken", "a name of its own"}},
    {"KeyTwiceBehindAnAlias",
     "name: &word fixed\nbase: *word\nbase: *word",
     {kError, 3, "base", "given twice", "keep one"}},
    {"MergeKey", "<<: {base: fixed}", {kError, 1, "<<", "unknown", ""}},
    {"ArmatureOfNobody",
     "armature: {elbo: 1}",
     {kError, 1, "armature/elbo", "no joint \"elbo\"", "did you mean \"elbow\"?"}},
    {"ArmatureBelowZero",
     "armature: {elbow: -1}",
     {kError, 1, "armature/elbow", "-1 is negative", "not below 0"}},
    {"ArmatureOfFixedJoint",
     "armature: {flange: 1}",
     {kError, 1, "armature/flange", "not one degree", "remove"}},
    {"ArmatureOfLockedJoint",
     "locked: {elbow: 0}\narmature: {elbow: 1}",
     {kError, 2, "armature/elbow", "is locked", "remove"}},
    {"ArmatureWithoutInertia",
     "armature: {elbow: {gear_ratio: 3}}",
     {kError, 1, "armature/elbow", "\"rotor_inertia\" is missing", "kg m^2"}},
    {"ArmatureOfFileWithout",
     "armature: file",
     {kError, 1, "armature", "states no rotor", "joint: kg m^2"}},
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
    {"MinusSignOfAWordProcessor",
     "gravity: [0, 0, \xE2\x88\x92"
     "9.81]",
     {kError, 1, "gravity[2]", "U+2212, a minus sign", "decimal number"}},
    {"OrientationInDegrees",
     "operational_points: [{name: p, link: tool, rows: [x], origin: {rpy: [0, 90, 0]}}]",
     {kWarning, 1, "operational_points[0]/origin/rpy", "more than a whole turn", "degrees"}},
    {"InfiniteNumber", "gravity: [0, 0, inf]", {kError, 1, "gravity[2]", "finite number", ""}},
    {"YamlInfinity", "gravity: [0, 0, .inf]", {kError, 1, "gravity[2]", "finite number", ""}},
    {"UnknownKeyLikeNone",
     "colours: {hand: 2}",
     {kError, 1, "colours", "\"colours\" is unknown", "the keys here are name, base, gravity,"}},
    {"UnknownKeyOfOtherPrograms",
     "payload: {mass: 2}",
     {kError, 1, "payload", "\"payload\" is unknown", "inputs: {payload: LINK} makes"}},
    {"UnknownKeyForATool",
     "tcp: tool",
     {kError, 1, "tcp", "\"tcp\" is unknown", "operational_points: [{name: tool, link: LINK}]"}},
    {"UnknownKeyForGains",
     "kp: 100",
     {kError, 1, "kp", "\"kp\" is unknown", "controller: {laws: joint_impedance"}},
    {"UnknownKeyForLimits",
     "joint_limits: {joint1: 1}",
     {kError, 1, "joint_limits", "is unknown", "torque_limits and controller:"}},
    {"KeyOfAnEarlierRelease",
     "prefetch: true",
     {kError, 1, "prefetch", "\"prefetch\" is unknown", "called once while the program waits"}},
    {"OtherWordsWhereTheKeyIsNotKnown",
     "contacts: [{name: p, link: tool, payload: 2}]",
     {kError, 1, "contacts[0]/payload", "unknown", "the keys here are"}},
    {"BatchOfThree",
     "batch: 3",
     {kError, 1, "batch", "\"3\" is not known", "the choices are 2, 4, 8, 16"}},
    {"BatchOf32",
     "batch: 32",
     {kError, 1, "batch", "\"32\" is not known", "the choices are 2, 4, 8, 16"}},
    {"AllFunctions",
     "functions: all",
     {kError, 1, "functions", "not \"all\"", "leave out functions for all that the scene permits"}},
    {"AllFunctionsListed",
     "functions: [all]",
     {kError, 1, "functions[0]", "no function \"all\"", "inverse_dynamics_derivatives"}},
    {"FunctionLikeNone",
     "functions: [hessian_tensor]",
     {kError, 1, "functions[0]", "no function \"hessian_tensor\"",
      "the functions are forward_kinematics, jacobian,"}},
    {"FunctionOfAnotherName",
     "functions: [bias_forces]",
     {kError, 1, "functions[0]", "no function \"bias_forces\"", "\"nonlinear_effects\" is b + g"}},
    {"FunctionWithMore",
     "functions: [gravity_vector]",
     {kError, 1, "functions[0]", "\"gravity_vector\"", "did you mean \"gravity\"?"}},
    {"OriginAsList",
     "operational_points: [{name: a, link: tool, origin: [0, 0, 0.1]}]",
     {kError, 1, "operational_points[0]/origin", "a map is expected here, not a list",
      "write {xyz: [x, y, z], rpy: [roll, pitch, yaw]}"}},
    {"LinkLikeNone",
     "operational_points: [{name: a, link: gripper_xyz}]",
     {kError, 1, "operational_points[0]/link", "no link \"gripper_xyz\"",
      "each below the one that carries it:\n  "}},
    {"JointLikeNone",
     "locked: {wheel_7: 1}",
     {kError, 1, "locked/wheel_7", "no joint \"wheel_7\"", "its joints that move are "}},
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
     {kError, 1, "functions", "no operational point", "operational_points"}},
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
     {kWarning, 1, "",
      "\"a\" has 3 rows, but its link \"tool\" moves with 2 coordinates only: x y z", "yield"}},
    {"MoreRowsThanLinkMovesExactly",
     "singular: exact\noperational_points: [{name: a, link: tool, rows: [x, y, z]}]",
     {kError, 1, "", "\"a\" has 3 rows, but its link \"tool\" moves with 2 coordinates",
      "fewer rows"}},
    {"MoreRowsTogether",
     "operational_points: [{name: a, link: tool, rows: [x, y]}, {name: b, link: fore, rows: [x]}]",
     {kWarning, 1, "", "3 rows together, but 2 coordinates move them: a: x y, b: x", "yield"}},
    {"MoreRowsTogetherExactly",
     "singular: exact\n"
     "operational_points: [{name: a, link: tool, rows: [x, y]}, {name: b, link: fore, rows: [x]}]",
     {kError, 1, "", "3 rows together, but 2 coordinates", "fewer rows"}},
    {"PointOnTheGround",
     "operational_points: [{name: a, link: base, rows: [x]}]",
     {kWarning, 1, "", "moves with 0 coordinates", "yield"}},
    {"UnknownSingular", "singular: damped", {kError, 1, "singular", "\"damped\"", "exact"}},
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
     {kError, 1, "functions", "effective_mass is listed, but there is no contact", "contacts"}},
    {"UnusedContact",
     "contacts: [{name: a, link: tool}]\nfunctions: [gravity]",
     {kWarning, 1, "", "no function takes them", "add"}},
    {"DampedNeedsFunctions",
     "damped: {mass: 1, inertia: 1}\noperational_points: [{name: a, link: tool, rows: [x]}]\n"
     "functions: [jacobian, bias_acceleration, inverse_dynamics]",
     {kError, 3, "functions", "damped needs lambda_inverse", "add it to functions"}},
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
                   {kError, 1, "functions",
                    "nothing beyond joints \"shoulder\", \"elbow\", \"slide\" has mass", "lock"});
}

// Would catch: faults of a list on the command line that are told of a line in the scene.
TEST(BadSceneRobot, LacksWhatAnOptionListsFunctionsOf) {
  for (const char* text : {"name: a\nfunctions: [gravity]", "name: a", ""}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_scene(text, "s.yaml", make_robot(), diagnostics,
                             {Function::gravity, Function::jacobian}));
    expect_diagnosed(diagnostics, "",
                     {kError, 0, "--functions", "jacobian is listed", "operational_points"});
  }
}

// Would catch: a centre of mass that is 0/0.
TEST(BadSceneRobot, HasNoMassToHaveACentre) {
  Robot robot = make_robot("massless", "");
  for (Link& link : robot.links) link.inertial.reset();
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_scene("functions: [center_of_mass]", "s.yaml", robot, diagnostics));
  expect_diagnosed(diagnostics, "s.yaml",
                   {kError, 1, "functions", "no link has mass", "robot's file"});
}

}  // namespace
}  // namespace treeline
