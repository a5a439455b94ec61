// Would catch: values of a correct file that are lost, rounded, reordered or read from a wrong
// place.
#include "description/read_urdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "diagnosed.hpp"

namespace treeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The order of joints and links is neither that of the tree nor alphabetical.
const char* const kRobot = R"(<?xml version="1.0"?>
<robot name="example" xmlns="http://www.ros.org" version="1.0">
  <joint name="wrist" type="prismatic">
    <parent link="upper"/> <child link="tool"/>
    <origin xyz=" 1e-1
2	3 " rpy="0.1 -0.2 1.5707963267948966"/>
    <axis xyz="3 0 -4"/>
    <limit lower="-0.5" upper="inf" effort="1" velocity="2"/>
    <mimic joint="shoulder" multiplier="2" offset="0.25"/>
  </joint>
  <link name="tool"/>
  <joint name="shoulder" type="continuous">
    <parent link="base"/> <child link="upper"/>
    <dynamics damping="0.5" friction="0.125"/>
    <mimic joint="slide" multiplier="-3" offset="1"/>
  </joint>
  <link name="upper">
    <inertial>
      <origin xyz="0.1 0.2 0.3" rpy="0 0 1"/>
      <mass value="2.5"/>
      <inertia ixx="0.3" ixy="0.01" ixz="0.02" iyy="0.4" iyz="0.03" izz="0.5"/>
    </inertial>
    <visual/> <collision><geometry><mesh filename="package://nowhere/a.stl"/></geometry></collision>
  </link>
  <link name="base"/>
  <joint name="slide" type="prismatic">
    <parent link="base"/> <child link="carriage"/>
    <limit upper="2" effort="1" velocity="2"/>
  </joint>
  <link name="carriage"><inertial><mass value="1"/></inertial></link>
</robot>
)";

class ReadUrdf : public testing::Test {
 protected:
  void SetUp() override {
    robot_ = parse_urdf(kRobot, "example.urdf", diagnostics_);
    ASSERT_TRUE(robot_) << to_string(diagnostics_);
  }
  Diagnostics diagnostics_;
  std::optional<Robot> robot_;
};

TEST_F(ReadUrdf, KeepsTheOrderOfTheFile) {
  EXPECT_EQ(robot_->name, "example");
  EXPECT_EQ(robot_->file, "example.urdf");
  ASSERT_EQ(robot_->links.size(), 4U);
  EXPECT_EQ(robot_->links[0].name, "tool");
  EXPECT_EQ(robot_->links[1].name, "upper");
  EXPECT_EQ(robot_->links[2].name, "base");
  EXPECT_EQ(robot_->root, 2);
  ASSERT_EQ(robot_->joints.size(), 3U);
  EXPECT_EQ(robot_->joints[0].name, "wrist");
  EXPECT_EQ(robot_->joints[0].parent, 1);
  EXPECT_EQ(robot_->joints[0].child, 0);
  EXPECT_EQ(robot_->joints[0].line, 3);
  EXPECT_EQ(robot_->joints[1].name, "shoulder");
}

TEST_F(ReadUrdf, ReadsNumbersExactly) {
  const Joint& wrist = robot_->joints[0];
  EXPECT_EQ(wrist.origin.xyz, (std::array{0.1, 2.0, 3.0}));
  EXPECT_EQ(wrist.origin.rpy, (std::array{0.1, -0.2, 1.5707963267948966}));
  const Inertial& inertial = *robot_->links[1].inertial;
  EXPECT_EQ(inertial.mass, 2.5);
  EXPECT_EQ(inertial.origin.xyz, (std::array{0.1, 0.2, 0.3}));
  EXPECT_EQ(inertial.origin.rpy, (std::array{0.0, 0.0, 1.0}));
  EXPECT_EQ(inertial.ixx, 0.3);
  EXPECT_EQ(inertial.ixy, 0.01);
  EXPECT_EQ(inertial.ixz, 0.02);
  EXPECT_EQ(inertial.iyy, 0.4);
  EXPECT_EQ(inertial.iyz, 0.03);
  EXPECT_EQ(inertial.izz, 0.5);
  EXPECT_EQ(robot_->joints[1].damping, 0.5);
  EXPECT_EQ(robot_->joints[1].friction, 0.125);
  EXPECT_FALSE(robot_->links[0].inertial);
}

TEST_F(ReadUrdf, NormalisesAxes) {
  const auto& axis = robot_->joints[0].axis;
  EXPECT_DOUBLE_EQ(axis[0], 0.6);
  EXPECT_EQ(axis[1], 0);
  EXPECT_DOUBLE_EQ(axis[2], -0.8);
  EXPECT_EQ(robot_->joints[1].axis, (std::array{1.0, 0.0, 0.0}));  // URDF's default
}

TEST_F(ReadUrdf, HasInfiniteLimitsWhereNoneAreSet) {
  EXPECT_EQ(robot_->joints[0].limits->lower, -0.5);
  EXPECT_EQ(robot_->joints[0].limits->upper, kInfinity);
  EXPECT_FALSE(robot_->joints[1].limits);
  // If only one limit is given, the other is 0, as the specification says.
  EXPECT_EQ(robot_->joints[2].limits->lower, 0);
  // Of 2 in the file: the wrist, which follows by -6 q + 2.25, keeps above -0.5.
  EXPECT_DOUBLE_EQ(robot_->joints[2].limits->upper, 2.75 / 6);
}

TEST_F(ReadUrdf, PutsChainsOfMimicsTogether) {
  // wrist = 2 shoulder + 0.25 = 2 (-3 slide + 1) + 0.25
  const Mimic& mimic = *robot_->joints[0].mimic;
  EXPECT_EQ(mimic.joint, 2);
  EXPECT_EQ(mimic.multiplier, -6);
  EXPECT_EQ(mimic.offset, 2.25);
  EXPECT_EQ(robot_->joints[1].mimic->joint, 2);
  EXPECT_FALSE(robot_->joints[2].mimic);
}

TEST(ReadUrdfAxis, SurvivesExtremeLengths) {
  for (const char* axis : {"0 0 1e-300", "0 0 1e300", "0 0 5e-324"}) {
    Diagnostics diagnostics;
    const auto robot =
        parse_urdf(std::string("<robot name='r'><link name='a'/><link name='b'/><joint name='j' "
                               "type='continuous'><parent link='a'/><child link='b'/><axis xyz='") +
                       axis + "'/></joint></robot>",
                   "r.urdf", diagnostics);
    ASSERT_TRUE(robot) << to_string(diagnostics);
    EXPECT_EQ(robot->joints[0].axis, (std::array{0.0, 0.0, 1.0}));
  }
}

TEST(ReadUrdfTypes, AreAllKnown) {
  for (const auto& [name, type] :
       {std::pair{"revolute", JointType::revolute}, std::pair{"continuous", JointType::continuous},
        std::pair{"prismatic", JointType::prismatic}, std::pair{"fixed", JointType::fixed},
        std::pair{"floating", JointType::floating}, std::pair{"planar", JointType::planar}}) {
    Diagnostics diagnostics;
    const auto robot = parse_urdf(
        std::string("<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='") +
            name + "'><parent link='a'/><child link='b'/><axis xyz='0 1 0'/></joint></robot>",
        "r.urdf", diagnostics);
    ASSERT_TRUE(robot) << name << '\n' << to_string(diagnostics);
    EXPECT_EQ(robot->joints[0].type, type);
  }
}

/// A robot of one joint that is written as `joint`, with `inside` in the element.
std::string with_ball(const std::string& element, const std::string& type,
                      const std::string& inside = {}) {
  return "<robot name='r'><link name='a'/><link name='b'/>\n<" + element + " name='j' type='" +
         type + "'><origin xyz='1 2 3' rpy='0 0 0.5'/><parent link='a'/>" + "<child link='b'/>" +
         inside + "</" + element + "></robot>";
}

// iDynTree reads both names, PyBullet the second; Drake has an element of its own.
TEST(ReadUrdfTypes, BallJointsHaveThreeSpellings) {
  for (const auto& [element, type] : {std::pair{"joint", "ball"}, std::pair{"joint", "spherical"},
                                      std::pair{"drake:joint", "ball"}}) {
    Diagnostics diagnostics;
    const auto robot = parse_urdf(with_ball(element, type), "r.urdf", diagnostics);
    ASSERT_TRUE(robot) << element << type << '\n' << to_string(diagnostics);
    EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics);
    EXPECT_EQ(robot->joints[0].type, JointType::ball);
    EXPECT_EQ(robot->joints[0].origin.xyz, (std::array{1.0, 2.0, 3.0}));
    EXPECT_FALSE(robot->joints[0].limits);
  }
}

TEST(ReadUrdfTypes, AxisAndLimitOfABallAreIgnoredWithAWarning) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      with_ball("joint", "ball",
                "<axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='3' velocity='1'/>"),
      "r.urdf", diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_FALSE(robot->joints[0].limits);
  EXPECT_EQ(robot->joints[0].axis, (std::array{1.0, 0.0, 0.0}));
  ASSERT_EQ(diagnostics.list().size(), 2U) << to_string(diagnostics);
  for (const auto& [at, element] : {std::pair{0U, "axis"}, std::pair{1U, "limit"}}) {
    EXPECT_EQ(diagnostics.list()[at].severity, Severity::warning);
    EXPECT_EQ(diagnostics.list()[at].element, std::string("robot/joint[j]/") + element);
  }
}

// Other elements of Drake still change the mechanism and are refused.
TEST(ReadUrdfTypes, OtherJointsOfDrakeAreRefused) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_urdf(with_ball("drake:joint", "screw"), "r.urdf", diagnostics));
}

TEST(ReadUrdfNames, MayBeInAnyScript) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='Zw\xC3\xB6lf &amp; &quot;x&quot;'><link name='\xE5\x85\xB3 1'/></robot>",
      "r.urdf", diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_EQ(robot->name, "Zw\xC3\xB6lf & \"x\"");
  EXPECT_EQ(robot->links[0].name, "\xE5\x85\xB3 1");
}

TEST(ReadUrdfFile, TellsWhatIsWrongWithThePath) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_urdf("/nowhere/robot.urdf", diagnostics));
  expect_diagnosed(diagnostics, "/nowhere/robot.urdf",
                   {Severity::error, 0, "", "cannot open the file: No such file", "path"});
  Diagnostics folder;
  EXPECT_FALSE(read_urdf("/", folder));
  expect_diagnosed(folder, "/", {Severity::error, 0, "", "this is a folder", "file inside"});
}

TEST(DiagnosticText, HasPlaceFaultAndRemedy) {
  EXPECT_EQ(
      to_string(Diagnostic{Severity::error, "a.urdf", 7, "robot/link[x]", "it is bad", "mend it"}),
      "a.urdf:7: error: robot/link[x]: it is bad\n  mend it");
  EXPECT_EQ(to_string(Diagnostic{Severity::note, "", 0, "", "so it is", ""}), "note: so it is");
}

}  // namespace
}  // namespace treeline
