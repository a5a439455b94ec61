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

const Case kXml[] = {
    {"Empty", "", {kError, 0, "", "holds no XML", "URDF"}},
    {"Text", "not xml\n", {kError, 1, "", "text", "XML"}},
    {"PointerOfGitLfs",
     "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n",
     {kError, 1, "", "pointer of Git LFS", "git lfs pull"}},
    {"LinkCopiedAsText",
     "../my arm/arm.URDF",
     {kError, 1, "", "only a path, ../my arm/arm.URDF", "name the file"}},
    {"TextThatEndsInAName", "<robot> see arm.urdf", {kError, 1, "", "text stands outside", "mend"}},
    {"WebPage", "\n<!DOCTYPE html>\n<html><meta></html>", {kError, 1, "", "a web page", "Raw"}},
    {"NotClosed",
     "<robot name='r'>\n<link name='a'>\n</robot>",
     {kError, 2, "",
      "<link> is not closed: <link name=\"a\"> is open since line 2, and line 3 has </robot>",
      "XML"}},
    {"NotClosedAtTheEnd",
     "<robot name='r'>\n<link name='a'/>\n<joint name='j' type='fixed'>\n<parent link='a'/>\n",
     {kError, 3, "",
      "<joint> is not closed: <joint name=\"j\"> is open since line 3, and the file ends in line 5",
      "mend"}},
    {"NotClosedBehindWhatLooksLikeTags",
     "<robot name='a > b'>\n<!-- <link> -->\n<![CDATA[</robot>]]>\n<link name='x/>y'>\n",
     {kError, 4, "", "<link name=\"x/>y\"> is open since line 4", "mend"}},
    {"EndWithoutBeginning",
     "<robot name='r'>\n</link>\n</robot>",
     {kError, 1, "", "<robot name=\"r\"> is open since line 1, and line 2 has </link>", "mend"}},
    {"BadAttributeInside",
     "<robot name='r'>\n<link name='a'>\n<inertial mass=3/></link></robot>",
     {kError, 3, "", "an attribute is not of the form", "mend"}},
    {"AttributeTwiceInATagOfTwoLines",
     "<robot name='r'>\n<link name='a'><inertial><mass value='1'\nvalue='2'/></inertial></link>"
     "</robot>",
     {kError, 3, "", "\"value\" is given twice in <mass>", "mend"}},
    {"OwnEntities",
     "<?xml version='1.0'?>\n<!-- m -->\n<!DOCTYPE robot [<!ENTITY m '3'>]>\n<robot name='r'><link "
     "name='a'><inertial><mass value='&m;'/></inertial></link></robot>",
     {kError, 3, "", "the DOCTYPE has declarations of its own", "xmllint --noent"}},
    {"UndefinedEntity",
     "<robot name='r'>\n<link name='a'/><link name='b&amp;&#65;'/>\n<joint name='&m;&n;' "
     "type='fixed'><parent link='a'/><child link='b&amp;&#65;'/></joint></robot>",
     {kWarning, 3, "",
      "\"name\" has &m;, which no one defines; it is read as these characters (and 1", "&amp;m;"}},
    {"ProcessingInstruction",
     "<robot name='r'>\n<?edit fold?><link name='a'/></robot>",
     {kError, 2, "", "a processing instruction, <?...?>, stands inside", "mend"}},
    {"BadAttributeSaysInWhat",
     "<robot name='r'>\n<link name='a'>\n<inertial mass=3/></link></robot>",
     {kError, 3, "", "inside <link name=\"a\"> of line 2", "mend"}},
    {"ZeroByte", std::string("<robot>\n\0</robot>", 18), {kError, 2, "", "zero byte", "UTF-8"}},
    {"TwoRoots",
     "<robot name='r'/>\n<robot name='s'/>",
     {kError, 2, "robot", "second element at the top", "one element <robot>"}},
    {"EndTagTooMany",
     "<robot name='r'><link name='a'/></robot>\n</link>\n<robot><link name='b'/></robot>",
     {kError, 2, "", "</link> closes nothing", "remove it"}},
    {"EndTagOfTwoSlashes",
     "<robot name='r'>\n<link name='a'/>\n</link name='b'/></robot>",
     {kError, 3, "", "</link/> has two slashes", "remove the slash"}},
    {"EndTagWithAttributes",
     "<robot name='r'>\n<link name='a'>\n</link name='b'></robot>",
     {kError, 3, "", "the end tag </link> has attributes", "what stands behind the name"}},
    {"NoElement", "<!-- only a comment -->", {kError, 0, "", "no XML element", "<robot>"}},
    {"OtherRoot", "<abcd/>", {kError, 1, "abcd", "the root element is <abcd>", "is <robot>"}},
    {"Sdf", "<sdf version='1.6'/>", {kError, 1, "sdf", "the root element is <sdf>", "SDF"}},
    {"AttributeTwice",
     "<robot name='r'>\n<link name='a' name='b'/></robot>",
     {kError, 2, "", "given twice", "mend"}},
    {"XacroElement",
     "<robot name='r'>\n<xacro:property name='x' value='1'/></robot>",
     {kError, 2, "xacro:property", "xacro text", "xacro bad.urdf > bad_expanded.urdf"}},
    {"XacroExpression",
     "<robot name='r'>\n<link name='${prefix}a'/></robot>",
     {kError, 2, "link", "name=\"${prefix}a\"", "xacro bad.urdf"}},
    {"XacroNumber",
     with_joint("continuous", "<origin xyz='0 0 ${length}'/>"),
     {kError, 5, "origin", "xyz=\"0 0 ${length}\"", "xacro bad.urdf"}},
    {"XacroNumberOfAProperty",
     "<robot name='r'><xacro:property name='m' value='1'/><link name='a'><inertial>\n<mass "
     "value='${m}'/></inertial></link></robot>",
     {kError, 2, "mass", "value=\"${m}\"", "xacro bad.urdf"}},
    {"XacroInsideALink",
     with_link("<xacro:inertia_of_box m='1'/>"),
     {kError, 3, "xacro:inertia_of_box", "<xacro:inertia_of_box> inside <link>", "xacro bad.urdf"}},
    {"XacroCondition",
     "<robot name='r'><link name='a'/>\n<xacro:if value='$(arg gripper)'><link "
     "name='b'/></xacro:if></robot>",
     {kError, 2, "xacro:if", "<xacro:if> would add links or joints", "xacro bad.urdf"}},
    {"XacroCallThatAddsLinks",
     "<robot name='r'><link name='a'/><xacro:macro name='arm'><link name='b'/></xacro:macro>\n"
     "<xacro:arm/></robot>",
     {kError, 2, "xacro:arm", "<xacro:arm> would add links or joints", "xacro bad.urdf"}},
    {"XacroWithoutATree",
     with_robot("<xacro:include filename='$(find arm)/joints.xacro'/>"),
     {kError, 3, "xacro:include", "this is xacro text, not yet a URDF: <xacro:include>",
      "xacro bad.urdf"}},
    {"XacroLeftOver",
     "<robot name='r'><link name='a'>" + kBody +
         "</link>\n<xacro:macro name='paint' params='c'><gazebo><link "
         "name='${c}'/></gazebo></xacro:macro>\n<xacro:paint c='a'/><xacro:paint "
         "c='b'/></robot>",
     {kWarning, 2, "xacro:macro", "passed over: <xacro:macro>, <xacro:paint> (2)",
      "xacro bad.urdf > bad_expanded.urdf"}},
    {"XacroInNamesThatTheFileDefines",
     "<robot name='r'>\n<xacro:arg name='ns' default=''/><link name='${ns}a'>" + kBody +
         "</link></robot>",
     {kWarning, 2, "xacro:arg", "names, which stay as they are written", "xacro bad.urdf"}},
    {"XacroInAShape",
     with_link(kBody + "<visual><origin xyz='${x} 0 0'/><xacro:box/></visual>\n<colour/>"),
     {kWarning, 4, "robot/link[a]", "<colour> is not part of URDF", "remove"}},
    {"LateDeclaration",
     "\n<?xml version='1.0'?><robot name='r'><link name='a'/></robot>",
     {kWarning, 2, "", "declaration is not at the start", "move it"}},
    {"DeclarationAfterComment",
     "<!-- a\nb -->\n<?xml version='1.0'?>\n<robot name='r'><link name='a'/></robot>",
     {kWarning, 3, "", "declaration is not at the start", "move it"}},
    {"DeclarationInside",
     "<robot name='r'>\n<?xml version='1.0'?><link name='a'/></robot>",
     {kError, 2, "", "declaration", "XML"}},
    {"Nested",
     [] {
       std::string deep;
       for (int i = 0; i < 100000; ++i) deep += "<a>";
       return deep;
     }(),
     {kError, 1, "", "nested too deeply", ""}},
};
INSTANTIATE_TEST_SUITE_P(Xml, BadUrdf, testing::ValuesIn(kXml), name_of);

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
     with_link(kBody + "<visual><geometry><box size='1 1 1'/></geometry>\n<material name='m'>"
                       "<color><rgba>1 0 0 1</rgba></color></material></visual>"),
     {kWarning, 4, "robot/link[a]/visual/material[m]/color", "<rgba> stands inside <color>",
      "write <color rgba="}},
    {"InsideColorOfAll",
     "<robot name='r'>\n<link name='a'/>\n<material name='m'><color rgba='1 0 0 1'><alpha/><alpha/>"
     "</color></material></robot>",
     {kWarning, 3, "robot/material[m]/color",
      "<alpha> stands inside <color>, where nothing reads it (and 1 more", "alpha="}},
    {"InsideShape",
     with_link(kBody + "<collision>\n<geometry><sphere><radius>1</radius></sphere></geometry>"
                       "</collision>"),
     {kWarning, 4, "robot/link[a]/collision/geometry/sphere", "<radius> stands inside <sphere>",
      "write <sphere radius="}},
    {"StrayText",
     "<robot name='r'>\n<link name='a'/>\n stray</robot>",
     {kWarning, 3, "robot", "text stands between", "remove it"}},
    {"HeavyWorld",
     "<robot name='r'>\n<link name='world'>" + kBody + "</link></robot>",
     {kWarning, 2, "robot/link[world]", "\"world\" has inertia", "move"}},
};
INSTANTIATE_TEST_SUITE_P(Robots, BadUrdf, testing::ValuesIn(kRobots), name_of);

const Case kTrees[] = {
    {"UnknownChild",
     with_robot("<joint name='j' type='fixed'><parent link='a'/><child link='bb'/></joint>"),
     {kError, 3, "robot/joint[j]", "the child link \"bb\" is not defined", "did you mean \"b\"?"}},
    {"UnknownWorld",
     with_robot("<joint name='j' type='fixed'><parent link='world'/><child link='a'/></joint>"),
     {kError, 3, "robot/joint[j]", "\"world\" is not defined", "add <link name=\"world\"/>"}},
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
     with_joint("revolut", kLimit),
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
    {"InvertedLimits",
     with_joint("revolute", "<limit lower='1' upper='-1' effort='1' velocity='1'/>"),
     {kWarning, 5, "robot/joint[j]/limit", "lower=1 is above upper=-1", "exchange"}},
    {"NegativeEffort",
     with_joint("revolute", "<limit lower='-1' upper='1' effort='-1' velocity='1'/>"),
     {kWarning, 5, "robot/joint[j]/limit", "effort=-1 is negative", "magnitude"}},
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

// What another reader would drop without a word, and what a person cannot see.
const Case kContent[] = {
    {"MimicsMultiplierAsAnElement",
     with_joint("continuous", "<mimic joint='j'>\n<multiplier>2</multiplier></mimic>"),
     {kError, 6, "robot/joint[j]/mimic/multiplier", "URDF has it as an attribute",
      "write <mimic multiplier="}},
    {"MimicsMultiplierAsText",
     with_joint("continuous", "<mimic joint='j'>2</mimic>"),
     {kError, 5, "robot/joint[j]/mimic", "2 stands inside <mimic>", "<mimic joint="}},
    {"MassInOtherCapitals",
     with_link("<inertial><mass value='1'>\n<Value>2</Value></mass></inertial>"),
     {kError, 4, "robot/link[a]/inertial/mass/Value", "as an attribute", "write <mass value="}},
    {"OriginAsText",
     with_joint("continuous", "<origin>0 0 1</origin>"),
     {kError, 5, "robot/joint[j]/origin", "0 0 1 stands inside <origin>", "<origin xyz="}},
    {"WordsInALimit",
     with_joint("revolute", "<limit lower='-1' upper='1' effort='1' velocity='1'>wide</limit>"),
     {kWarning, 5, "robot/joint[j]/limit", "text stands between", "remove"}},
    {"ElementInALimit",
     with_joint("revolute", "<limit lower='-1' upper='1' effort='1' velocity='1'><soft/></limit>"),
     {kWarning, 5, "robot/joint[j]/limit", "<soft> is not part of URDF", "remove"}},
    {"LimitInsideAxis",
     with_joint("continuous", "<axis xyz='0 0 1'><limit lower='1'/></axis>"),
     {kWarning, 5, "robot/joint[j]/axis", "<limit> has no place inside <axis>", "move it"}},
    {"JointInsideLink",
     with_link("<joint name='j' type='fixed'/>"),
     {kWarning, 3, "robot/link[a]", "<joint> has no place inside <link>", "move it"}},
    {"CapitalOfAnAttribute",
     with_joint("continuous", "<mimic joint='j' Multiplier='2'/>"),
     {kError, 5, "robot/joint[j]/mimic", "\"Multiplier\" is not the attribute \"multiplier\"",
      "write multiplier=\"2\""}},
    {"CapitalOfAnElement",
     with_joint("continuous", "<Origin xyz='0 0 1'/>"),
     {kError, 5, "robot/joint[j]", "<Origin> is not <origin>: capitals", "write <origin>"}},
    {"CapitalOfALink",
     "<robot name='r'><link name='a'/>\n<Link name='b'/></robot>",
     {kError, 2, "robot", "<Link> is not <link>: capitals", "write <link>"}},
    {"SlipInAnAttribute",
     with_joint("continuous", "<axis xyz='0 0 1' xzy='1 0 0'/>"),
     {kWarning, 5, "robot/joint[j]/axis", "\"xzy\" is not part of URDF", "did you mean \"xyz\"?"}},
    {"SlipInAnElement",
     with_link(kBody + "\n<intertial/>"),
     {kWarning, 4, "robot/link[a]", "<intertial> is not part of URDF",
      "did you mean \"inertial\"?"}},
    {"BlankInAName",
     with_robot("<joint name='j ' type='fixed'><parent link='a'/><child link='b'/></joint>"),
     {kWarning, 3, "robot/joint[j ]", "begins or ends with U+0020, a space", "remove it"}},
    {"NoBreakSpace",
     with_joint("continuous",
                "<origin xyz='0\xC2\xA0"
                "0 1'/>"),
     {kError, 5, "robot/joint[j]/origin", "it has U+00A0, a no-break space", "spaces"}},
    {"MinusSign",
     with_joint("revolute",
                "<limit lower='\xE2\x88\x92"
                "1' upper='1' effort='1' velocity='1'/>"),
     {kError, 5, "robot/joint[j]/limit", "it has U+2212, a minus sign", "decimal"}},
    {"FullWidth",
     with_link("<inertial><mass value='\xEF\xBC\x91'/></inertial>"),
     {kError, 3, "robot/link[a]/inertial/mass", "it has U+FF11, a character of full width",
      "decimal"}},
    {"LatinByte",
     with_link("<inertial><mass value='1\xA0'/></inertial>"),
     {kError, 3, "robot/link[a]/inertial/mass", "it has byte 0xA0, which is not UTF-8", "decimal"}},
    {"NumberNearZero",
     with_joint("continuous", "<origin xyz='1e-400 0 1'/>"),
     {kWarning, 5, "robot/joint[j]/origin", "1e-400 in \"xyz\" is nearer to 0", "write 0"}},
    {"MassNearZero",
     inertia("ixx='0' ixy='0' ixz='0' iyy='0' iyz='0' izz='-1e-400'"),
     {kWarning, 4, "robot/link[a]/inertial/inertia", "-1e-400 in \"izz\"", "write 0"}},
    {"MassTooSmall",
     with_link("<inertial><mass value='4e-320'/></inertial>"),
     {kWarning, 3, "robot/link[a]/inertial/mass", "too small to compute with and counts as 0",
      "1e-100"}},
    {"AnglesInDegrees",
     with_joint("continuous", "<origin rpy='0 90 0'/>"),
     {kWarning, 5, "robot/joint[j]/origin", "rpy=\"0 90 0\" is more than a whole turn", "degrees"}},
    {"LimitsInDegrees",
     with_joint("revolute", "<limit lower='-170' upper='170' effort='1' velocity='1'/>"),
     {kWarning, 5, "robot/joint[j]/limit", "-170 and 170 rad let the joint turn more than twice",
      "degrees"}},
};
INSTANTIATE_TEST_SUITE_P(Content, BadUrdf, testing::ValuesIn(kContent), name_of);

/// What must pass without a word: a robot with `inside` in a joint of this type.
void expect_silent(const std::string& type, const std::string& inside) {
  Diagnostics diagnostics;
  EXPECT_TRUE(parse_urdf(with_joint(type, inside), "r.urdf", diagnostics)) << inside;
  EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics);
}

// Would catch: a warning of what is in order.
TEST(BadUrdfText, SaysNothingOfWholeTurnsAndRangesWithoutEnd) {
  expect_silent("continuous", "<origin rpy='6.2832 -6.28319 0'/>");
  expect_silent("continuous", "<axis xyz='0 0 1'>\n<!-- up -->\n</axis>");
  expect_silent("continuous", "<origin xyz='0\t0\n1'/>");
  for (const char* range : {"lower='-12.566371' upper='12.566371'", "lower='-1e16' upper='1e16'"}) {
    expect_silent("revolute", std::string("<limit effort='1' velocity='1' ") + range + "/>");
  }
  expect_silent("prismatic", "<limit lower='-170' upper='170' effort='1' velocity='1'/>");
}

const Case kMimics[] = {
    {"NoJoint",
     with_joint("continuous", "<mimic/>"),
     {kError, 5, "robot/joint[j]/mimic", "\"joint\" is missing", "<mimic joint="}},
    {"Itself",
     with_joint("continuous", "<mimic joint='j'/>"),
     {kError, 4, "robot/joint[j]", "mimics itself", "independent"}},
    {"Link",
     with_joint("continuous", "<mimic joint='a'/>"),
     {kError, 4, "robot/joint[j]", "\"a\" is not defined", "this is a link"}},
    {"Unknown",
     with_joint("continuous", "<mimic joint='jj'/>"),
     {kError, 4, "robot/joint[j]", "\"jj\" is not defined", "did you mean \"j\"?"}},
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
     {kError, 4, "robot/joint[k]", "circle", "independent"}},
    {"OfFixed",
     with_robot("<link name='c'/><joint name='j' type='fixed'><parent link='a'/><child "
                "link='b'/></joint>\n<joint name='k' type='continuous'><parent link='b'/><child "
                "link='c'/><mimic joint='j'/></joint>"),
     {kError, 4, "robot/joint[k]", "has not one degree of freedom", "revolute"}},
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
