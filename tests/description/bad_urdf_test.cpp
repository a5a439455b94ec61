// Would catch: a kind of fault that is accepted without a message, or reported without its place or
// a remedy. Every case has one fault in an otherwise correct robot, in the reported line.
#include "bad_urdf.hpp"

#include <gtest/gtest.h>

namespace treeline::bad_urdf {
namespace {

class BadUrdf : public testing::TestWithParam<Case> {};

TEST_P(BadUrdf, IsDiagnosed) {
  expect_case(GetParam());
}

const Case kRobots[] = {
    {"NoName",
     "<robot><link name='a'/></robot>",
     {kError, 1, "robot", "\"name\" is missing", "<robot name="}},
    {"EmptyName",
     "<robot name=''><link name='a'/></robot>",
     {kWarning, 1, "robot", "name is empty", "<robot name="}},
    {"NoLink", "<robot name='r'/>", {kError, 1, "robot", "no <link>", "links"}},
    {"VersionTwo",
     "<robot name='r' version='2'><link name='a'/></robot>",
     {kError, 1, "robot", "version=\"2\"", "1.0"}},
    {"VersionJunk",
     "<robot name='r' version='1.0~pre6'><link name='a'/></robot>",
     {kError, 1, "robot", "1.0~pre6", "1.0"}},
    {"VersionEmpty",
     "<robot name='r' version=''><link name='a'/></robot>",
     {kError, 1, "robot", "version", "1.0"}},
    {"VersionOne",
     "<robot name='r' version='1'><link name='a'/></robot>",
     {kWarning, 1, "robot", "version=\"1\"", "1.0"}},
    {"VersionOld",
     "<robot name='r' version='0.99'><link name='a'/></robot>",
     {kWarning, 1, "robot", "0.99", "1.0"}},
    {"DuplicateLink",
     with_robot("<link name='a'/>"),
     {kError, 3, "robot/link[a]", "already in line 2", "name of its own"}},
    {"UnnamedLink",
     with_robot("<link/>"),
     {kError, 3, "robot/link", "\"name\" is missing", "name"}},
    {"LatinName",
     with_robot("<link name='J\xE4ger'/>"),
     {kError, 3, "robot/link[J\xE4ger]", "not UTF-8", "UTF-8"}},
    {"BrokenName",
     with_robot("<link name='a&#10;b'/>"),
     {kError, 3, "robot/link[a\nb]", "control character", "one word"}},
    {"LatinRobot",
     "<robot name='\xE4'><link name='a'/></robot>",
     {kError, 1, "robot", "not UTF-8", "UTF-8"}},
    {"TwoRootLinks",
     with_robot(""),
     {kError, 2, "robot/link[b]", "second root", "connect the two"}},
    {"LoopJoint",
     with_robot("<loop_joint/>"),
     {kError, 3, "robot/loop_joint", "changes the mechanism", "constraints in the scene"}},
    {"LoopJointOfAnotherKind",
     with_robot("<loop_joint name='l' type='planar'><link1 link='a'/><link2 link='b'/>"
                "</loop_joint>"),
     {kError, 3, "robot/loop_joint[l]", "\"planar\" of a joint that closes a loop is not known",
      "constraints in the scene"}},
    {"LoopJointWithALimit",
     with_robot("<loop_joint name='l' type='fixed'><link1 link='a'/><link2 link='b'/>"
                "<limit lower='0' upper='1'/></loop_joint>"
                "<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>"),
     {kWarning, 3, "robot/loop_joint[l]", "<limit> has no place inside <loop_joint>", "remove it"}},
    {"LoopJointWithoutAnEnd",
     with_robot("<loop_joint name='l' type='fixed'><link1 link='a'/></loop_joint>"),
     {kError, 3, "robot/loop_joint[l]", "<link2> is missing", "write <link1"}},
    {"LoopJointToNowhere",
     with_robot("<loop_joint name='l' type='fixed'><link1 link='a'/><link2 link='c'/>"
                "</loop_joint>"),
     {kError, 3, "robot/loop_joint[l]/link2", "no link \"c\"", ""}},
    {"ForeignJoint",
     with_robot("<drake:joint name='j'/>"),
     {kError, 3, "robot/drake:joint[j]", "changes the mechanism", "links and joints of URDF"}},
    {"UnknownElement",
     "<robot name='r'>\n<link name='a'/>\n<thruster/><thruster/></robot>",
     {kWarning, 3, "robot", "<thruster> is not part of URDF and is ignored (and 1 more",
      "remove it"}},
    {"GazeboJoint",
     "<robot name='r'>\n<link name='a'/>\n<gazebo><joint name='j'/></gazebo></robot>",
     {kWarning, 3, "robot/gazebo", "inside <gazebo> is ignored", "open tree"}},
    {"UnknownAttribute",
     "<robot name='r'>\n<link name='a' colour='red'/></robot>",
     {kWarning, 2, "robot/link[a]", "\"colour\" is not part of URDF", "remove it"}},
    {"InsideColor",
     with_link(link_body() + "<visual><geometry><box size='1 1 1'/></geometry>\n<material name='m'>"
                             "<color><rgba>1 0 0 1</rgba></color></material></visual>"),
     {kWarning, 4, "robot/link[a]/visual/material[m]/color", "<rgba> stands inside <color>",
      "write <color rgba="}},
    {"InsideColorOfAll",
     "<robot name='r'>\n<link name='a'/>\n<material name='m'><color rgba='1 0 0 1'><alpha/><alpha/>"
     "</color></material></robot>",
     {kWarning, 3, "robot/material[m]/color",
      "<alpha> stands inside <color>, where nothing reads it (and 1 more", "alpha="}},
    {"InsideShape",
     with_link(link_body() + "<collision>\n<geometry><sphere><radius>1</radius></sphere></geometry>"
                             "</collision>"),
     {kWarning, 4, "robot/link[a]/collision/geometry/sphere", "<radius> stands inside <sphere>",
      "write <sphere radius="}},
    {"SecondShape",
     with_link(link_body() +
               "<visual><geometry><box size='1 1 1'/>\n<sphere radius='1'/></geometry>"
               "</visual>"),
     {kWarning, 4, "robot/link[a]/visual/geometry", "<sphere> stands behind the shape",
      "a <visual> or <collision> of its own"}},
    {"StrayText",
     "<robot name='r'>\n<link name='a'/>\n stray</robot>",
     {kWarning, 3, "robot", "text stands between", "remove it"}},
    {"HeavyWorld",
     "<robot name='r'>\n<link name='world'>" + link_body() + "</link></robot>",
     {kWarning, 2, "robot/link[world]", "\"world\" has inertia", "move"}},
};
INSTANTIATE_TEST_SUITE_P(Robots, BadUrdf, testing::ValuesIn(kRobots), name_of);

const Case kTrees[] = {
    {"UnknownChild",
     with_robot("<joint name='j' type='fixed'><parent link='a'/><child link='bb'/></joint>"),
     {kError, 3, "robot/joint[j]", "the child link \"bb\" is not defined", "did you mean \"b\"?"}},
    {"TwoParents",
     with_robot("<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>\n<joint "
                "name='k' type='fixed'><parent link='a'/><child link='b'/></joint>"),
     {kError, 4, "robot/joint[k]",
      "\"b\" has two parents: it is already the child of joint \"j\" in line 3", "remove one"}},
    {"OwnParent",
     with_robot("<joint name='j' type='fixed'><parent link='a'/><child link='a'/></joint>"),
     {kError, 3, "robot/joint[j]", "its own parent", "two different links"}},
    {"Loop",
     with_robot("<joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>\n<joint "
                "name='k' type='fixed'><parent link='b'/><child link='a'/></joint>"),
     {kError, 2, "robot/link[a]", "loop: a - b - a", "tree"}},
    {"DetachedLoop",
     with_robot("<link name='root'/><joint name='j' type='fixed'><parent link='a'/><child "
                "link='b'/></joint>\n<joint name='k' type='fixed'><parent link='b'/><child "
                "link='a'/></joint>"),
     {kError, 2, "robot/link[a]", "loop", "tree"}},
    {"DuplicateJoint",
     with_robot("<link name='c'/><joint name='j' type='fixed'><parent link='a'/><child "
                "link='b'/></joint>\n<joint name='j' type='fixed'><parent link='b'/><child "
                "link='c'/></joint>"),
     {kError, 4, "robot/joint[j]", "already in line 3", "name of its own"}},
    {"NoParent",
     with_robot("<joint name='j' type='fixed'><child link='b'/></joint>"),
     {kError, 3, "robot/joint[j]", "no <parent>", "<parent link="}},
    {"NoParentLink",
     with_robot("<joint name='j' type='fixed'><parent lnk='a'/><child link='b'/></joint>"),
     {kError, 3, "robot/joint[j]/parent", "\"link\" is missing", "<parent link="}},
    {"TwoChildren",
     with_robot("<joint name='j' type='fixed'><parent link='a'/><child link='b'/><child "
                "link='a'/></joint>"),
     {kError, 3, "robot/joint[j]/child", "two <child>", "keep one"}},
    {"UnnamedJoint",
     with_robot("<joint type='fixed'><parent link='a'/><child link='b'/></joint>"),
     {kError, 3, "robot/joint", "\"name\" is missing", "name"}},
};
INSTANTIATE_TEST_SUITE_P(Trees, BadUrdf, testing::ValuesIn(kTrees), name_of);

const Case kJoints[] = {
    {"NoType",
     with_robot("<joint name='j'><parent link='a'/><child link='b'/></joint>"),
     {kError, 3, "robot/joint[j]", "\"type\" is missing", "revolute"}},
    {"MisspeltType",
     with_joint("revolut", joint_limit()),
     {kError, 4, "robot/joint[j]", "\"revolut\" is not a joint type",
      "did you mean \"revolute\"?"}},
    {"MisspeltBall",
     with_joint("sperical", ""),
     {kError, 4, "robot/joint[j]", "\"sperical\" is not a joint type", "the types are"}},
    {"BallThatMimics",
     with_joint("ball", "<mimic joint='k'/>"),
     {Severity::warning, 5, "robot/joint[j]/mimic", "a ball joint cannot mimic", "remove it"}},
    {"ZeroAxis",
     with_joint("continuous", "<axis xyz='0 0 0'/>"),
     {kError, 5, "robot/joint[j]/axis", "the axis is zero", "direction"}},
    {"EmptyAxis",
     with_joint("continuous", "<axis/>"),
     {kError, 5, "robot/joint[j]/axis", "\"xyz\" is missing", "<axis xyz="}},
    {"TwoOriginNumbers",
     with_joint("continuous", "<origin xyz='1 2'/>"),
     {kError, 5, "robot/joint[j]/origin", "xyz=\"1 2\" is not three finite numbers but 2",
      "spaces"}},
    {"FourOriginNumbers",
     with_joint("continuous", "<origin rpy='1 2 3 4'/>"),
     {kError, 5, "robot/joint[j]/origin", "but 4", "spaces"}},
    {"Commas",
     with_joint("continuous", "<origin xyz='1, 2, 3'/>"),
     {kError, 5, "robot/joint[j]/origin", "xyz=\"1, 2, 3\"", "spaces"}},
    {"NotANumber",
     with_joint("continuous", "<origin xyz='1 nan 3'/>"),
     {kError, 5, "robot/joint[j]/origin", "nan", "decimal"}},
    {"Quaternion",
     with_joint("continuous", "<origin wxyz='1 0 0 0'/>"),
     {kWarning, 5, "robot/joint[j]/origin", "\"wxyz\" is not part of URDF", "remove it"}},
    {"TwoOrigins",
     with_joint("continuous", "<origin/>\n<origin/>"),
     {kWarning, 6, "robot/joint[j]/origin", "the first, in line 5, is used", "keep one"}},
    {"NoLimit",
     with_joint("revolute", ""),
     {kWarning, 4, "robot/joint[j]", "no <limit>", "continuous"}},
    {"NoEffort",
     with_joint("revolute", "<limit lower='-1' upper='1' velocity='1'/>"),
     {kWarning, 5, "robot/joint[j]/limit", "\"effort\" is missing", "add it"}},
    {"NoRange",
     with_joint("revolute", "<limit effort='1' velocity='1'/>"),
     {kWarning, 5, "robot/joint[j]/limit", "neither \"lower\" nor \"upper\"", "continuous"}},
    {"LimitNoNumber",
     with_joint("revolute", "<limit lower='-1.57.' upper='1' effort='1' velocity='1'/>"),
     {kError, 5, "robot/joint[j]/limit", "lower=\"-1.57.\"", "decimal"}},
    {"TwoDampings",
     with_joint("continuous", "<dynamics damping='1 2'/>"),
     {kError, 5, "robot/joint[j]/dynamics", "damping=\"1 2\"", "one decimal number"}},
    {"EmptyDynamics",
     with_joint("continuous", "<dynamics/>"),
     {kWarning, 5, "robot/joint[j]/dynamics", "neither", "remove"}},
    {"UnknownChildElement",
     with_joint("continuous", "<gear_ratio value='3'/>"),
     {kWarning, 5, "robot/joint[j]", "<gear_ratio> is not part of URDF", "motion"}},
};
INSTANTIATE_TEST_SUITE_P(Joints, BadUrdf, testing::ValuesIn(kJoints), name_of);

const Case kMimics[] = {
    {"NoJoint",
     with_joint("continuous", "<mimic/>"),
     {kError, 5, "robot/joint[j]/mimic", "\"joint\" is missing", "<mimic joint="}},
    {"Itself",
     with_joint("continuous", "<mimic joint='j'/>"),
     {kError, 5, "robot/joint[j]/mimic", "mimics itself", "independent"}},
    {"Link",
     with_joint("continuous", "<mimic joint='a'/>"),
     {kError, 5, "robot/joint[j]/mimic", "\"a\" is not defined", "this is a link"}},
    {"Unknown",
     with_joint("continuous", "<mimic joint='jj'/>"),
     {kError, 5, "robot/joint[j]/mimic", "\"jj\" is not defined", "did you mean \"j\"?"}},
    {"OnFixed",
     with_joint("fixed", "<mimic joint='nowhere'/>"),
     {kWarning, 5, "robot/joint[j]/mimic", "a fixed joint cannot mimic", "remove"}},
    {"OnFloating",
     with_joint("floating", "<mimic joint='j'/>"),
     {kWarning, 5, "robot/joint[j]/mimic", "a floating joint cannot mimic", "remove"}},
    {"OnPlanar",
     with_joint("planar", "<mimic joint='j'/>"),
     {kError, 5, "robot/joint[j]/mimic", "one degree of freedom", "remove"}},
    {"Circle",
     with_robot("<link name='c'/><joint name='j' type='continuous'><parent link='a'/><child "
                "link='b'/><mimic joint='k'/></joint>\n<joint name='k' type='continuous'><parent "
                "link='b'/><child link='c'/><mimic joint='j'/></joint>"),
     {kError, 4, "robot/joint[k]/mimic", "circle", "independent"}},
    {"OfFixed",
     with_robot("<link name='c'/><joint name='j' type='fixed'><parent link='a'/><child "
                "link='b'/></joint>\n<joint name='k' type='continuous'><parent link='b'/><child "
                "link='c'/><mimic joint='j'/></joint>"),
     {kError, 4, "robot/joint[k]/mimic", "has not one degree of freedom", "revolute"}},
    {"MultiplierNoNumber",
     with_joint("continuous", "<mimic joint='j' multiplier='x'/>"),
     {kError, 5, "robot/joint[j]/mimic", "multiplier=\"x\"", "decimal"}},
};
INSTANTIATE_TEST_SUITE_P(Mimics, BadUrdf, testing::ValuesIn(kMimics), name_of);

// Would catch: reading that stops at the first fault.
TEST(BadUrdfText, ShowsAllFaultsAtOnce) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parse_urdf(with_joint("continuous", "<axis xyz='0 0 0'/><origin xyz='a'/>"),
                          "r.urdf", diagnostics));
  EXPECT_EQ(diagnostics.list().size(), 2U) << to_string(diagnostics);
}

}  // namespace
}  // namespace treeline::bad_urdf
