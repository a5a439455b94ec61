// Would catch: an SDF file that is read as another robot than its author means: frames of links
// that are not at their joints, axes given in other frames, joints that lead towards the root,
// loops, nested models, joints of two axes, limits that stand for none; and a fault that is not
// told. The same robots are written by hand as URDF, whose frames and numbers follow from the
// definitions of SDF.
#include "description/sdf/read_sdf.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "comparison/difference.hpp"
#include "description/read_robot_text.hpp"
#include "description/read_urdf.hpp"

namespace treeline {
namespace {

bool reads_sdf() {
  Diagnostics diagnostics;
  return read_sdf("<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>", "m.sdf",
                  diagnostics)
      .has_value();
}

class Sdf : public testing::Test {
 protected:
  void SetUp() override {
    if (!reads_sdf()) GTEST_SKIP() << "skipped: built without libsdformat (libsdformat-dev)";
  }
};

std::string told(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& each : diagnostics.list()) text += to_string(each) + "\n";
  return text;
}

/// The robot of a model's elements; nothing is to be told but that it is read as a URDF.
Robot read_model(const std::string& elements) {
  Diagnostics diagnostics;
  const auto text = as_robot_text(
      "<sdf version='1.9'>\n<model name='m'>" + elements + "</model></sdf>", "m.sdf", diagnostics);
  const auto robot = text ? parse_urdf(text->urdf, text->shown, diagnostics) : std::nullopt;
  EXPECT_TRUE(robot) << told(diagnostics);
  EXPECT_EQ(diagnostics.list().size(), 1U) << told(diagnostics);
  return robot.value_or(Robot{});
}

Robot read_twin(const std::string& elements) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf("<robot name='m'>" + elements + "</robot>", "m.urdf", diagnostics);
  EXPECT_TRUE(robot) << told(diagnostics);
  return robot.value_or(Robot{});
}

/// Expects both to have the same links, joints, poses, masses, limits and dynamics. Poses are
/// composed in double from a few rotations and offsets of less than a metre.
void expect_same(const Robot& read, const Robot& twin, Base base) {
  const RobotDifference difference = compare_robots(read, twin, base, 1e-14);
  EXPECT_FALSE(difference.differs()) << print_text(difference);
  EXPECT_LT(difference.dynamics.inverse_dynamics.relative, 1e-13);
  EXPECT_GT(difference.dynamics.coordinates, 0);
}

std::string sdf_link(const std::string& name, const std::string& pose, double mass) {
  return "<link name='" + name + "'>" + pose + "<inertial><mass>" + std::to_string(mass) +
         "</mass><pose>0.1 0.02 0 0 0 0.4</pose><inertia><ixx>0.02</ixx><iyy>0.03</iyy>"
         "<izz>0.04</izz><ixy>0.001</ixy><iyz>0.002</iyz></inertia></inertial></link>";
}

std::string urdf_link(const std::string& name, double mass) {
  return "<link name='" + name +
         "'><inertial><origin xyz='0.1 0.02 0' rpy='0 0 0.4'/><mass value='" +
         std::to_string(mass) +
         "'/><inertia ixx='0.02' iyy='0.03' izz='0.04' ixy='0.001' ixz='0' iyz='0.002'/>"
         "</inertial></link>";
}

std::string urdf_joint(const std::string& name, const std::string& type, const std::string& parent,
                       const std::string& child, const std::string& more) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + more + "</joint>";
}

const std::string kAboutZ = "<axis xyz='0 0 1'/>";
const std::string kFree = "<limit effort='inf' velocity='inf'/>";

const std::string kBase = sdf_link("base", "<pose>0 0 0.1 0 0 0</pose>", 3);
const std::string kUpper =
    sdf_link("upper", "<pose relative_to='base'>0 0 0.3 1.5707963267948966 0 0</pose>", 2);
const std::string kFore = sdf_link("fore", "<pose relative_to='upper'>0.4 0 0 0 0 0.3</pose>", 1);
const std::string kShoulder =
    "<joint name='shoulder' type='revolute'><parent>base</parent><child>upper</child><axis>"
    "<xyz expressed_in='__model__'>0 0 1</xyz><limit><lower>-2</lower><upper>2</upper>"
    "<effort>50</effort><velocity>3</velocity></limit><dynamics><damping>0.1</damping>"
    "<friction>0.2</friction></dynamics></axis></joint>";
const std::string kTwinShoulder =
    urdf_joint("shoulder", "revolute", "base", "upper",
               "<origin xyz='0 0 0.3' rpy='1.5707963267948966 0 0'/><axis xyz='0 1 0'/>"
               "<limit lower='-2' upper='2' effort='50' velocity='3'/><dynamics damping='0.1' "
               "friction='0.2'/>");
const std::string kTwinLinks = urdf_link("base", 3) + urdf_link("upper", 2) + urdf_link("fore", 1);

TEST_F(Sdf, KeepsTheFramesOfLinksWhoseJointsAreElsewhere) {
  const std::string elbow =
      "<joint name='elbow' type='revolute'><pose>-0.1 0 0 0 0 0</pose><parent>upper</parent>"
      "<child>fore</child><axis><xyz>0 0 1</xyz></axis></joint>";
  const std::string frame =
      "<frame name='tip' attached_to='fore'><pose>0.3 0 0 0 0 0</pose></frame>";
  const std::string place = fmt::format("<origin xyz='{} {} 0' rpy='0 0 0.3'/>",
                                        0.4 - 0.1 * std::cos(0.3), -0.1 * std::sin(0.3));
  const std::string twin =
      kTwinLinks + "<link name='elbow_frame'/><link name='tip'/>" + kTwinShoulder +
      urdf_joint("elbow", "continuous", "upper", "elbow_frame", place + kAboutZ + kFree) +
      urdf_joint("elbow_to_fore", "fixed", "elbow_frame", "fore", "<origin xyz='0.1 0 0'/>") +
      urdf_joint("at::tip", "fixed", "fore", "tip", "<origin xyz='0.3 0 0'/>");
  const Robot robot = read_model(kBase + kUpper + kFore + kShoulder + elbow + frame);
  expect_same(robot, read_twin(twin), Base::fixed);
  expect_same(robot, read_twin(twin), Base::floating);
}

// The quarter turn and the zeros beside it stay exact: they save operations.
TEST_F(Sdf, KeepsQuarterTurnsExact) {
  const Robot robot = read_model(kBase + kUpper + kShoulder);
  ASSERT_EQ(robot.joints.size(), 1U);
  EXPECT_EQ(robot.joints[0].origin.rpy, (std::array{std::acos(0.0), 0.0, 0.0}));
  EXPECT_EQ(robot.joints[0].axis, (std::array{0.0, 1.0, 0.0}));
  EXPECT_EQ(robot.joints[0].origin.xyz[0], 0);
  EXPECT_EQ(robot.joints[0].origin.xyz[1], 0);
}

// The coordinate of a joint is that of its child on its parent, whichever stands nearer to the
// root.
TEST_F(Sdf, TurnsJointsThatLeadTowardsTheRoot) {
  const std::string reversed =
      "<joint name='elbow' type='prismatic'><parent>fore</parent><child>upper</child>"
      "<axis><xyz>0 0.6 0.8</xyz><limit><lower>-0.1</lower><upper>0.3</upper></limit></axis>"
      "</joint>";
  const std::string twin =
      kTwinLinks + "<link name='elbow_frame'/>" + kTwinShoulder +
      urdf_joint("elbow", "prismatic", "upper", "elbow_frame",
                 "<axis xyz='0 -0.6 -0.8'/><limit lower='-0.1' upper='0.3' effort='inf' "
                 "velocity='inf'/>") +
      urdf_joint("elbow_to_fore", "fixed", "elbow_frame", "fore",
                 "<origin xyz='0.4 0 0' rpy='0 0 0.3'/>");
  expect_same(read_model(kBase + kUpper + kFore + kShoulder + reversed), read_twin(twin),
              Base::fixed);
}

TEST_F(Sdf, MakesTwoJointsOfOneWithTwoAxes) {
  const std::string universal =
      "<joint name='elbow' type='universal'><parent>upper</parent><child>fore</child>"
      "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>";
  const std::string twin =
      kTwinLinks + "<link name='elbow_cross'/>" + kTwinShoulder +
      urdf_joint("elbow_1", "continuous", "upper", "elbow_cross",
                 "<origin xyz='0.4 0 0' rpy='0 0 0.3'/>" + kAboutZ + kFree) +
      urdf_joint("elbow_2", "continuous", "elbow_cross", "fore", "<axis xyz='0 1 0'/>" + kFree);
  expect_same(read_model(kBase + kUpper + kFore + kShoulder + universal), read_twin(twin),
              Base::fixed);
}

TEST_F(Sdf, PutsNestedModelsInAndHoldsToTheWorld) {
  const std::string nested =
      "<model name='arm'><pose>0 0 0.5 0 0 0.2</pose>" + kBase + kUpper + kShoulder +
      "</model><joint name='held' type='fixed'><parent>world</parent><child>arm::base</child>"
      "</joint>";
  std::string shoulder = kTwinShoulder;
  for (const char* name : {"'shoulder'", "'base'", "'upper'"}) {
    const auto at = shoulder.find(name);
    ASSERT_NE(at, std::string::npos);
    shoulder.insert(at + 1, "arm::");
  }
  // The axis is given in the frame of the nested model.
  const std::string twin =
      "<link name='world'/>" + urdf_link("arm::base", 3) + urdf_link("arm::upper", 2) +
      urdf_joint("held", "fixed", "world", "arm::base", "<origin xyz='0 0 0.6' rpy='0 0 0.2'/>") +
      shoulder;
  expect_same(read_model(nested), read_twin(twin), Base::fixed);
}

TEST_F(Sdf, ClosesALoopByTheLastOfItsJoints) {
  const std::string links = sdf_link("a", "", 1) + sdf_link("b", "<pose>0.2 0 0 0 0 0</pose>", 1) +
                            sdf_link("c", "<pose>0 0.3 0 0 0 0</pose>", 1);
  const auto hinge = [](const char* name, const char* parent, const char* child, const char* more) {
    return fmt::format(
        "<joint name='{}' type='revolute'>{}<parent>{}</parent><child>{}</child>"
        "<axis><xyz>0 0 1</xyz></axis></joint>",
        name, more, parent, child);
  };
  const Robot robot = read_model(links + hinge("ab", "a", "b", "") + hinge("ac", "a", "c", "") +
                                 hinge("closing", "b", "c", "<pose>0.2 0.1 0 0 0 0</pose>"));
  EXPECT_EQ(robot.joints.size(), 2U);
  ASSERT_EQ(robot.loops.size(), 1U);
  const RobotLoop& loop = robot.loops[0];
  EXPECT_EQ(loop.name, "closing");
  EXPECT_EQ(loop.first.link, "b");
  EXPECT_EQ(loop.second.link, "c");
  EXPECT_EQ(loop.rows, (std::array{true, true, true, true, true, false}));
  // At (0.2, 0.4) of the model, half an ulp of which either side may round.
  EXPECT_NEAR(loop.first.origin.xyz[0], 0, 1e-16);
  EXPECT_NEAR(loop.first.origin.xyz[1], 0.4, 1e-16);
  EXPECT_NEAR(loop.second.origin.xyz[0], 0.2, 1e-16);
  EXPECT_NEAR(loop.second.origin.xyz[1], 0.1, 1e-16);
}

TEST_F(Sdf, HandsShapesOn) {
  const std::string shape =
      "<link name='l'><inertial><mass>1</mass></inertial><visual name='v'><pose>1 0 0 0 0 0</pose>"
      "<geometry><cylinder><radius>0.1</radius><length>2</length></cylinder></geometry><material>"
      "<diffuse>1 0 0.5 1</diffuse></material></visual><collision name='c'><geometry><mesh>"
      "<uri>model://arm/l.stl</uri></mesh></geometry></collision></link>";
  Diagnostics diagnostics;
  const auto text = as_robot_text("<sdf version='1.9'><model name='m'>" + shape + "</model></sdf>",
                                  "m.sdf", diagnostics);
  ASSERT_TRUE(text) << told(diagnostics);
  for (const char* part : {"<cylinder radius=\"0.1\" length=\"2\"/>", "rgba=\"1 0 0.5 1\"",
                           "xyz=\"1 0 0\"", "<mesh filename=\"package://arm/l.stl\""}) {
    EXPECT_NE(text->urdf.find(part), std::string::npos) << part << " in\n" << text->urdf;
  }
}

struct BadSdf {
  const char* name;
  std::string text;
  const char* told;   ///< part of what is said
  Severity severity;  ///< of the worst
};

void PrintTo(const BadSdf& tested, std::ostream* out) {
  *out << tested.name;
}

std::string model(const std::string& elements) {
  return "<sdf version='1.9'><model name='m'>" + elements + "</model></sdf>";
}

class Faults : public Sdf, public testing::WithParamInterface<BadSdf> {};

TEST_P(Faults, AreTold) {
  Diagnostics diagnostics;
  testing::internal::CaptureStderr();
  const auto text = as_robot_text(GetParam().text, "m.sdf", diagnostics);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");  // of libraries that say it themselves
  EXPECT_EQ(text.has_value(), GetParam().severity != Severity::error);
  EXPECT_EQ(diagnostics.has_errors(), GetParam().severity == Severity::error);
  EXPECT_NE(told(diagnostics).find(GetParam().told), std::string::npos) << told(diagnostics);
}

const std::string kTwo = sdf_link("a", "", 1) + sdf_link("b", "", 1);
const std::string kEnds = "<parent>a</parent><child>b</child>";

INSTANTIATE_TEST_SUITE_P(
    Sdf, Faults,
    testing::Values(
        BadSdf{"Xml", "<sdf version='1.9'>\n<model name='m'></sdf>", "m.sdf:2", Severity::error},
        BadSdf{"NoName", model("<link nae='a'/>"), "Required attribute[name]", Severity::error},
        BadSdf{"NoModel", "<sdf version='1.9'/>", "no model that moves", Severity::error},
        BadSdf{"Several",
               "<sdf version='1.9'><world name='w'><model name='m'>" + kTwo +
                   "</model><model name='n'>" + kTwo + "</model></world></sdf>",
               "several models: m, n", Severity::error},
        BadSdf{"World",
               "<sdf version='1.9'><world name='w'><gravity>0 0 -1.6</gravity>"
               "<model name='m'>" +
                   sdf_link("a", "", 1) + "</model></world></sdf>",
               "[0, 0, -1.6]", Severity::note},
        BadSdf{"Loose", model(kTwo), "no joint connects b", Severity::error},
        BadSdf{"Screw",
               model(kTwo + "<joint name='j' type='screw'>" + kEnds +
                     "<axis><xyz>0 0 1</xyz></axis></joint>"),
               "joint[j]: a joint of type screw", Severity::error},
        BadSdf{"NoLink",
               model(kTwo + "<joint name='j' type='ball'><parent>a</parent>"
                            "<child>nowhere</child></joint>"),
               "nowhere", Severity::error},
        BadSdf{"Unknown", model(sdf_link("a", "", 1) + "<tentacle/>"), "tentacle",
               Severity::warning},
        BadSdf{"NoInertial", model("<link name='a'/>"), "1 kg m^2 in SDF: a", Severity::warning},
        BadSdf{"Spring",
               model(kTwo + "<joint name='j' type='revolute'>" + kEnds +
                     "<axis><xyz>0 0 1</xyz><dynamics><spring_stiffness>7"
                     "</spring_stiffness></dynamics></axis></joint>"),
               "joint_springs", Severity::warning},
        BadSdf{"LoopOfTwoAxes",
               model(kTwo + "<joint name='i' type='ball'>" + kEnds + "</joint>" +
                     "<joint name='j' type='universal'>" + kEnds +
                     "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>"),
               "type universal closes a loop", Severity::error}),
    [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace treeline
