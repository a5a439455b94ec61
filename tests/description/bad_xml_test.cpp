// Would catch: text that is no XML, or content that another reader would drop without a word, and
// that is accepted here without a message, or reported without its place or a remedy. Every case
// has one fault in an otherwise correct robot, in the reported line.
#include <gtest/gtest.h>

#include "bad_urdf.hpp"

namespace treeline::bad_urdf {
namespace {

class BadXml : public testing::TestWithParam<Case> {};

TEST_P(BadXml, IsDiagnosed) {
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
    {"ZeroByteAtTheEnd",
     std::string("<robot name='r'>\n<link name='a'/></robot>\n\0", 43),
     {kWarning, 2, "", "behind the end of the text", "remove it"}},
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
    {"PartOfMjcf",
     "<mujocoinclude/>",
     {kError, 1, "mujocoinclude", "the root element is <mujocoinclude>", "a part of an MJCF"}},
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
     "<robot name='r'><link name='a'>" + link_body() +
         "</link>\n<xacro:macro name='paint' params='c'><gazebo><link "
         "name='${c}'/></gazebo></xacro:macro>\n<xacro:paint c='a'/><xacro:paint "
         "c='b'/></robot>",
     {kWarning, 2, "xacro:macro", "passed over: <xacro:macro>, <xacro:paint> (2)",
      "xacro bad.urdf > bad_expanded.urdf"}},
    {"XacroInNamesThatTheFileDefines",
     "<robot name='r'>\n<xacro:arg name='ns' default=''/><link name='${ns}a'>" + link_body() +
         "</link></robot>",
     {kWarning, 2, "xacro:arg", "names, which stay as they are written", "xacro bad.urdf"}},
    {"XacroInAShape",
     with_link(link_body() + "<visual><origin xyz='${x} 0 0'/><xacro:box/></visual>\n<colour/>"),
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
INSTANTIATE_TEST_SUITE_P(Text, BadXml, testing::ValuesIn(kXml), name_of);

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
     with_link(link_body() + "\n<intertial/>"),
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
INSTANTIATE_TEST_SUITE_P(Content, BadXml, testing::ValuesIn(kContent), name_of);

/// What must pass without a word: a robot with `inside` in a joint of this type.
void expect_silent(const std::string& type, const std::string& inside) {
  Diagnostics diagnostics;
  EXPECT_TRUE(parse_urdf(with_joint(type, inside), "r.urdf", diagnostics)) << inside;
  EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics);
}

// Would catch: a warning of what is in order.
TEST(BadXmlText, SaysNothingOfWholeTurnsAndRangesWithoutEnd) {
  expect_silent("continuous", "<origin rpy='6.2832 -6.28319 0'/>");
  expect_silent("continuous", "<axis xyz='0 0 1'>\n<!-- up -->\n</axis>");
  expect_silent("continuous", "<origin xyz='0\t0\n1'/>");
  for (const char* range : {"lower='-12.566371' upper='12.566371'", "lower='-1e16' upper='1e16'"}) {
    expect_silent("revolute", std::string("<limit effort='1' velocity='1' ") + range + "/>");
  }
  expect_silent("prismatic", "<limit lower='-170' upper='170' effort='1' velocity='1'/>");
}

}  // namespace
}  // namespace treeline::bad_urdf
