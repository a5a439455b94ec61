#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "check/fixture.hpp"
#include "oracle/leave_out_singular.hpp"

// Mechanisms whose mass matrix is singular for known reasons, and others that only look like it.
// Would catch: a direction that is not found, or named wrongly or without reason, a cure that does
// not work, and functions left out without a message or without need.

namespace treeline::tests {
namespace {

const std::string kBody =
    "<inertial><origin xyz='0.02 0.01 0.2'/><mass value='2'/>"
    "<inertia ixx='0.1' iyy='0.2' izz='0.15' ixy='0.01' ixz='0' iyz='0'/></inertial>";

std::string link(const std::string& name, const std::string& inertial = kBody) {
  return "<link name='" + name + "'>" + inertial + "</link>";
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& axis = "0 0 1", const std::string& type = "continuous") {
  return "<joint name='" + name + "' type='" + type + "'><origin xyz='0.1 0 0.3'/><parent link='" +
         parent + "'/><child link='" + child + "'/><axis xyz='" + axis + "'/></joint>";
}

struct Case {
  Robot robot;
  Scene scene;
};

Case read(const std::string& elements, const std::string& scene_text) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf("<robot name='r'>" + elements + "</robot>", "r.urdf", diagnostics);
  if (!robot) throw std::runtime_error("no robot");
  const auto scene = parse_scene(scene_text, "s.yaml", *robot, diagnostics);
  if (!scene) throw std::runtime_error("no scene: " + to_string(diagnostics.list().back()));
  return {*robot, *scene};
}

std::vector<MasslessDirections> find(const std::string& elements, const std::string& scene = "") {
  const Case made = read(elements, scene);
  return find_massless_directions(made.robot, made.scene);
}

const std::string kFloating = "base: floating\n";
/// Like most exported arms: a root without inertia below the first joint.
const std::string kArm = link("base", "") + link("upper") + link("fore") +
                         joint("shoulder", "base", "upper") +
                         joint("elbow", "upper", "fore", "0 1 0");

TEST(MasslessDirections, OfAMasslessRootOnAFloatingBase) {
  const auto found = find(kArm, kFloating);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "joint \"shoulder\" against rotation of the base about z");
  EXPECT_EQ(found[0].joint, "shoulder");
  EXPECT_TRUE(found[0].one_degree);
  EXPECT_TRUE(found[0].moves_base);
  EXPECT_EQ(found[0].links, (std::vector<std::string>{"base"}));
}

TEST(MasslessDirections, NamesAnObliqueAxis) {
  const auto found = find(
      link("base", "") + link("upper") + joint("shoulder", "base", "upper", "0 3 4"), kFloating);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].what.find("rotation of the base about (0, "), std::string::npos)
      << found[0].what;
  EXPECT_NE(found[0].what.find("0.6, "), std::string::npos) << found[0].what;
}

TEST(MasslessDirections, OfASliderOnAMasslessRoot) {
  const auto found = find(
      link("base", "") + link("cart") + joint("rail", "base", "cart", "1 0 0", "prismatic") + "",
      kFloating);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "joint \"rail\" against translation of the base along x");
}

TEST(MasslessDirections, NoneOnAFixedBase) {
  EXPECT_TRUE(find(kArm).empty());
}

TEST(MasslessDirections, OfALeaf) {
  const auto found = find(kArm + link("tip", "") + joint("wrist", "fore", "tip"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "joint \"wrist\"");
  EXPECT_FALSE(found[0].moves_base);
  EXPECT_EQ(found[0].links, (std::vector<std::string>{"tip"}));
}

TEST(MasslessDirections, CountWhatMimics) {
  const std::string leaf = kArm + link("tip", "") + joint("wrist", "fore", "tip");
  const std::string follower =
      "<joint name='grip' type='continuous'><parent link='fore'/><child link='jaw'/>"
      "<mimic joint='wrist'/></joint>";
  EXPECT_TRUE(find(leaf + link("jaw") + follower).empty());
  EXPECT_EQ(find(leaf + link("jaw", "") + follower).size(), 1U);
}

/// Three axes through one point, of which the first and the last agree where `nod` is 0, with
/// `ring` as inertial of the two links between them.
std::string head_on_rings(const std::string& ring) {
  const auto turn = [](const std::string& name, const std::string& parent, const std::string& child,
                       const std::string& axis) {
    return "<joint name='" + name + "' type='continuous'><parent link='" + parent +
           "'/><child link='" + child + "'/><axis xyz='" + axis + "'/></joint>";
  };
  return link("base") + link("outer", ring) + link("inner", ring) + link("head") +
         turn("yaw", "base", "outer", "0 0 1") + turn("nod", "outer", "inner", "1 0 0") +
         turn("turn", "inner", "head", "0 0 1");
}

// Would catch: a gimbal lock that is taken for a massless link, or one that nobody is told of.
TEST(MasslessDirections, OfAGimbalThatIsLockedAtZero) {
  const Case made = read(head_on_rings(""), kFloating);
  EXPECT_TRUE(find_massless_directions(made.robot, made.scene).empty());
  const auto found = find_massless_at_zero(made.robot, made.scene);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "joint \"turn\" against joint \"yaw\"");
  Scene scene = made.scene;
  Diagnostics diagnostics;
  leave_out_singular(made.robot, scene, "", diagnostics);
  EXPECT_EQ(scene.functions, made.scene.functions);
  ASSERT_EQ(diagnostics.list().size(), 1U);
  EXPECT_EQ(diagnostics.list()[0].severity, Severity::warning);
  EXPECT_NE(diagnostics.list()[0].fault.find("where all coordinates are 0"), std::string::npos);
}

TEST(MasslessDirections, NoneAtZeroOfRingsWithInertia) {
  const Case made = read(head_on_rings(kBody), kFloating);
  EXPECT_TRUE(find_massless_at_zero(made.robot, made.scene).empty());
  const Case arm = read(kArm, "");
  EXPECT_TRUE(find_massless_at_zero(arm.robot, arm.scene).empty());
}

// Two joints about one axis with nothing between them.
TEST(MasslessDirections, OfTwins) {
  const std::string origin_free =
      "<joint name='second' type='continuous'><origin xyz='0 0 0.2'/><parent link='ring'/>"
      "<child link='fore'/><axis xyz='0 0 -1'/></joint>";
  const auto found = find(link("base") + link("ring", "") + link("fore") +
                          joint("first", "base", "ring") + origin_free);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "joint \"second\" against joint \"first\"");
  EXPECT_EQ(found[0].links, (std::vector<std::string>{"ring"}));
}

TEST(MasslessDirections, OfAFreeFrame) {
  const auto found = find(link("world", "") + link("body", "") +
                          joint("free", "world", "body", "0 0 1", "floating"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "joint \"free\"");
  EXPECT_FALSE(found[0].one_degree);
  // Beyond a floating base, too, nothing distinguishes the two joints, whatever the body weighs.
  const auto twice =
      find(link("world", "") + link("body") + joint("free", "world", "body", "0 0 1", "floating"),
           kFloating);
  ASSERT_EQ(twice.size(), 1U);
  EXPECT_EQ(twice[0].what, "joint \"free\" against the floating base");
  EXPECT_EQ(twice[0].links, (std::vector<std::string>{"world"}));
}

// A point mass resists translation but not rotation.
TEST(MasslessDirections, OfAPointMass) {
  const auto found = find(link("ball",
                               "<inertial><mass value='2'/><inertia ixx='0' ixy='0' ixz='0' "
                               "iyy='0' iyz='0' izz='0'/></inertial>"),
                          kFloating);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(
      found[0].what,
      "rotation of the base about z and rotation of the base about y and rotation of the base "
      "about x");
  EXPECT_EQ(found[0].joint, "");
}

TEST(MasslessDirections, NoneWhereInertiaIsSmallButThere) {
  const std::string speck =
      "<inertial><mass value='1e-9'/><inertia ixx='1e-12' ixy='0' ixz='0' iyy='1e-12' iyz='0' "
      "izz='1e-12'/></inertial>";
  EXPECT_TRUE(find(kArm + link("tip", speck) + joint("wrist", "fore", "tip")).empty());
}

TEST(MasslessDirections, NoneOfRobotsThatHaveInertia) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    RandomOptions options;
    options.floating_base = seed % 2 == 0;
    options.mimic = seed % 3 == 0 ? 0.3 : 0;
    options.massless = 1;
    const RandomMechanism drawn = random_mechanism(seed, options);
    EXPECT_TRUE(find_massless_directions(drawn.robot, drawn.scene).empty()) << "seed " << seed;
  }
}

/// Messages of `leave_out_singular` about a robot, and the scene that remains.
struct Said {
  Scene scene;
  std::vector<Diagnostic> list;
};

Said leave_out(const std::string& elements, const std::string& scene_text) {
  Case made = read(elements, scene_text);
  Diagnostics diagnostics;
  const bool lists = scene_text.find("functions:") != std::string::npos;
  leave_out_singular(made.robot, made.scene, lists ? "functions" : "", diagnostics);
  return {made.scene, diagnostics.list()};
}

bool has(const Scene& scene, Function function) {
  return std::count(scene.functions.begin(), scene.functions.end(), function) == 1;
}

const std::string kPoint = "operational_points: [{name: tip, link: fore, rows: [x]}]\n";

TEST(LeaveOutSingular, WarnsOnceAndKeepsTheRest) {
  const Said said = leave_out(kArm, kFloating + kPoint);
  ASSERT_EQ(said.list.size(), 1U);
  const Diagnostic& warning = said.list.front();
  EXPECT_EQ(warning.severity, Severity::warning);
  EXPECT_NE(warning.fault.find("joint \"shoulder\" against rotation of the base about z"),
            std::string::npos)
      << warning.fault;
  EXPECT_NE(warning.fault.find("forward_dynamics, lambda_inverse, lambda, control_torque"),
            std::string::npos)
      << warning.fault;
  EXPECT_NE(warning.remedy.find("link \"base\""), std::string::npos) << warning.remedy;
  EXPECT_NE(warning.remedy.find("lock joint \"shoulder\""), std::string::npos);
  EXPECT_NE(warning.remedy.find("base: fixed"), std::string::npos);
  EXPECT_EQ(said.scene.functions,
            (std::vector{Function::forward_kinematics, Function::jacobian,
                         Function::bias_acceleration, Function::inverse_dynamics, Function::gravity,
                         Function::nonlinear_effects, Function::mass_matrix}));
}

// Each suggested cure by itself.
TEST(LeaveOutSingular, NamesWhatCures) {
  EXPECT_TRUE(leave_out(kArm, kPoint).list.empty());
  EXPECT_TRUE(leave_out(kArm, kFloating + kPoint + "locked: {shoulder: 0.5}\n").list.empty());
  const std::string heavy = link("base") + kArm.substr(link("base", "").size());
  const Said said = leave_out(heavy, kFloating + kPoint);
  EXPECT_TRUE(said.list.empty());
  EXPECT_TRUE(has(said.scene, Function::forward_dynamics));
}

TEST(LeaveOutSingular, NamesEveryMasslessLeaf) {
  const Said said = leave_out(kArm + link("left", "") + link("right", "") +
                                  joint("a", "fore", "left") + joint("b", "fore", "right"),
                              "");
  ASSERT_EQ(said.list.size(), 1U);
  EXPECT_NE(said.list[0].fault.find("joint \"a\", joint \"b\""), std::string::npos)
      << said.list[0].fault;
  EXPECT_NE(said.list[0].remedy.find("lock joints \"a\", \"b\""), std::string::npos)
      << said.list[0].remedy;
  EXPECT_FALSE(has(said.scene, Function::forward_dynamics));
}

TEST(LeaveOutSingular, RefusesWhatIsAskedForByName) {
  const Said said = leave_out(kArm, kFloating + kPoint + "functions: [gravity, control_torque]\n");
  ASSERT_EQ(said.list.size(), 1U);
  EXPECT_EQ(said.list[0].severity, Severity::error);
  EXPECT_EQ(said.list[0].file, "s.yaml");
  EXPECT_EQ(said.list[0].element, "functions");
  EXPECT_NE(said.list[0].fault.find("rotation of the base about z; there is no control_torque"),
            std::string::npos)
      << said.list[0].fault;
  const Said damped = leave_out(kArm, kFloating + kPoint + "damped: {mass: 10, inertia: 1}\n");
  ASSERT_EQ(damped.list.size(), 1U);
  EXPECT_EQ(damped.list[0].severity, Severity::error);
  EXPECT_NE(damped.list[0].fault.find("there is no damped"), std::string::npos);
}

// Would catch: a message without a file, and one of a scene's file where the fault is an option's.
TEST(LeaveOutSingular, NamesTheFileThatIsThere) {
  Case made = read(kArm, kFloating);
  made.scene.file.clear();
  const auto told_of = [&](const std::string& listed) {
    Scene scene = made.scene;
    Diagnostics diagnostics;
    leave_out_singular(made.robot, scene, listed, diagnostics);
    EXPECT_EQ(diagnostics.list().size(), 1U);
    return diagnostics.list().at(0).file;
  };
  EXPECT_EQ(told_of(""), "r.urdf");
  EXPECT_EQ(told_of("--functions"), "");
  Diagnostics diagnostics;
  EXPECT_FALSE(has_accelerations(made.robot, made.scene, diagnostics));
  EXPECT_EQ(diagnostics.list().at(0).file, "r.urdf");
}

TEST(LeaveOutSingular, IsSilentWhereNothingInverts) {
  EXPECT_TRUE(
      leave_out(kArm, kFloating + kPoint + "functions: [gravity, jacobian]\n").list.empty());
}

// The remaining functions compile to the same numbers as before.
TEST(LeaveOutSingular, LeavesFunctionsThatPass) {
  const Case made = read(kArm, kFloating + kPoint);
  Scene scene = made.scene;
  Diagnostics diagnostics;
  leave_out_singular(made.robot, scene, "", diagnostics);
  const Subjects subjects{made.robot, scene, generate(made.robot, scene)};
  const auto report = check_or_throw(subjects, quick_options());
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(report.functions.size(), 7U);
}

}  // namespace
}  // namespace treeline::tests
