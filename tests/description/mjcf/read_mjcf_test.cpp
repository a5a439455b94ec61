// Would catch: what an MJCF file says that a scene decides and that is lost on the way; elements
// that are passed over in silence; faults without file, line and element; made names that differ
// from those of the reference page. What the bodies weigh and how they move is compared with MuJoCo
// in tests/judges.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "../../own_folder.hpp"
#include "../diagnosed.hpp"
#include "description/mjcf/read_bodies.hpp"
#include "description/read_robot_text.hpp"
#include "description/read_scene.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

std::optional<Robot> read(const std::string& inside, Diagnostics& diagnostics) {
  const auto text =
      as_robot_text("<mujoco model='m'>\n" + inside + "</mujoco>", "m.xml", diagnostics);
  return text ? parse_robot(*text, diagnostics) : std::nullopt;
}

/// One body with a hinge, which holds `inside`.
std::string arm(const std::string& inside) {
  return "<worldbody><body name='arm'><joint name='turn'/><geom size='0.1'/>\n" + inside +
         "</body></worldbody>\n";
}

double mass_of(const Robot& robot, const std::string& name) {
  const auto link = std::find_if(robot.links.begin(), robot.links.end(),
                                 [&](const Link& each) { return each.name == name; });
  return link != robot.links.end() && link->inertial ? link->inertial->mass : 0.0;
}

struct Told {
  const char* name;
  std::string inside;
  Expected expected;
};

void PrintTo(const Told& told, std::ostream* out) {
  *out << told.name;
}

class Mjcf : public testing::TestWithParam<Told> {};

TEST_P(Mjcf, TellsWhatItDoesNotRead) {
  Diagnostics diagnostics;
  const auto robot = read(GetParam().inside, diagnostics);
  EXPECT_EQ(robot.has_value(), GetParam().expected.severity != Severity::error);
  expect_diagnosed(diagnostics, "m.xml", GetParam().expected);
}

const std::string kArm = "mujoco/worldbody/body[arm]";

INSTANTIATE_TEST_SUITE_P(
    Elements, Mjcf,
    testing::Values(
        Told{"Composite",
             arm("<composite type='cable'/>"),
             {Severity::error, 3, kArm + "/composite", "<composite> is not read", "saveLastXML"}},
        Told{"Replicate",
             arm("<replicate count='3'><geom size='1'/></replicate>"),
             {Severity::error, 3, kArm + "/replicate", "<replicate> is not read", "saveLastXML"}},
        Told{"Class",
             arm("<geom class='none' size='1'/>"),
             {Severity::error, 3, kArm + "/geom", "no class \"none\"", "<default>"}},
        Told{"Numbers",
             arm("<geom size='1 x'/>"),
             {Severity::error, 3, kArm + "/geom", "size=\"1 x\" is not 1 to 3 numbers", "spaces"}},
        Told{
            "Mesh",
            "<asset><mesh name='w' file='none.obj'/></asset>" + arm("<geom type='mesh' mesh='w'/>"),
            {Severity::error, 3, kArm + "/geom", "none.obj cannot be read", "<inertial>"}},
        Told{"MeshOfWhatStandsStill",
             "<asset><mesh name='w' file='none.obj'/></asset><worldbody><body name='base'>"
             "<geom type='capsule' mesh='w'/></body></worldbody>" +
                 arm(""),
             {Severity::note, 2, "mujoco/worldbody/body[base]/geom",
              "fitted to a mesh is not computed, and need not be: nothing moves the body", ""}},
        Told{"Ellipsoid",
             arm("<geom type='ellipsoid' size='1 2 3' shellinertia='true'/>"),
             {Severity::error, 3, kArm + "/geom", "the surface of an ellipsoid", "<inertial>"}},
        Told{"Global",
             "<compiler coordinate='global'/>" + arm(""),
             {Severity::error, 2, "mujoco/compiler", "\"global\" is not read", "mj_saveLastXML"}},
        Told{"Include",
             "<include file='none.xml'/>" + arm(""),
             {Severity::error, 2, "mujoco/include", "\"none.xml\" cannot be read", "relative"}},
        Told{"ForcesOnAFreeRoot",
             "<default><joint armature='0.1'/></default>\n<worldbody><body name='arm'>"
             "<joint type='free'/><geom size='1'/></body></worldbody>",
             {Severity::warning, 3, kArm + "/joint", "armature of a joint", ""}},
        Told{"Muscle",
             arm("") + "<actuator><muscle name='biceps' tendon='t'/></actuator>",
             {Severity::warning, 4, "mujoco/actuator/muscle[biceps]", "does not drive one joint",
              "torque_limits"}},
        Told{"Tendon",
             arm("") + "<tendon><spatial name='t' stiffness='3'/></tendon>",
             {Severity::warning, 4, "mujoco/tendon/spatial[t]", "its stiffness acts on no joint",
              ""}},
        Told{"Polynomial",
             arm("<body><joint name='b'/><geom size='1'/></body>") +
                 "<equality><joint joint1='b' joint2='turn' polycoef='0 1 2 0 0'/></equality>",
             {Severity::warning, 4, "mujoco/equality/joint", "not linear", "couplings"}},
        Told{"Fluid",
             "<option density='1000'/>" + arm(""),
             {Severity::warning, 2, "mujoco/option", "forces of a fluid", "external_forces"}},
        Told{"Deformable",
             arm("") + "<deformable/>",
             {Severity::warning, 4, "mujoco/deformable", "<deformable> is not read", ""}}),
    [](const auto& told) { return told.param.name; });

TEST(MjcfMessages, CountWhatIsTheSame) {
  Diagnostics diagnostics;
  ASSERT_TRUE(
      read(arm("<body gravcomp='1'/><body gravcomp='1'/><body gravcomp='1'/>"), diagnostics));
  expect_diagnosed(
      diagnostics, "m.xml",
      {Severity::warning, 3, kArm + "/body", "gravcomp, which is not read (and so in 2 more)", ""});
}

TEST(MjcfNames, AreMadeOfThoseAround) {
  Diagnostics diagnostics;
  const auto robot =
      read(arm("<body><joint/><joint axis='1 0 0'/><geom size='1'/><site name='arm'/></body>"),
           diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  std::string names;
  for (const Link& link : robot->links) names += link.name + " ";
  for (const Joint& joint : robot->joints) names += joint.name + " ";
  EXPECT_EQ(names,
            "world arm arm_child_joint_link arm_child arm_site turn arm_child_joint "
            "arm_child_joint_2 arm_at ");
}

// Would catch names that differ in the file alone: joints of one name in emitted code are refused,
// and nobody could rename what the file does not name.
TEST(MjcfNames, DifferAsIdentifiers) {
  const std::string free = "<body><freejoint/><geom size='0.1'/></body>";
  for (const std::string& bodies :
       {std::string("<body name='b'><joint/><joint axis='0 1 0'/><joint axis='1 0 0'/>"
                    "<geom size='0.1' pos='0.1 0 0'/></body>"),
        free + free + free,
        std::string("<body name='b'><joint/><geom size='0.1' pos='0.1 0 0'/><body><joint "
                    "name='b-joint'/><geom size='0.1' pos='0.1 0 0'/><body><joint "
                    "name='b__joint_2'/><geom size='0.1'/></body></body></body>")}) {
    Diagnostics diagnostics;
    const auto robot = read("<worldbody>" + bodies + "</worldbody>", diagnostics);
    ASSERT_TRUE(robot) << to_string(diagnostics);
    std::set<std::string> links, joints;
    for (const Link& link : robot->links) links.insert(identifier_from(link.name));
    for (const Joint& joint : robot->joints) joints.insert(identifier_from(joint.name));
    EXPECT_EQ(links.size(), robot->links.size()) << bodies;
    EXPECT_EQ(joints.size(), robot->joints.size()) << bodies;
    EXPECT_TRUE(parse_scene("", "s.yaml", *robot, diagnostics)) << to_string(diagnostics);
  }
}

// Would catch bodies that lose what is stated of them where the geoms that count weigh nothing, and
// bounds that leave such bodies out.
TEST(MjcfMasses, OfBodiesThatNoGeomWeighs) {
  Diagnostics diagnostics;
  const auto robot =
      read("<compiler inertiafromgeom='true' inertiagrouprange='0 2' boundmass='0.5'/>" +
               arm("<body name='stated'><joint name='a'/><inertial pos='0 0 1' mass='2' "
                   "diaginertia='1 1 1'/><geom size='1' group='3'/></body>"
                   "<body name='empty'><joint name='b'/></body>"),
           diagnostics);
  ASSERT_TRUE(robot);
  EXPECT_EQ(mass_of(*robot, "stated"), 2.0);
  EXPECT_EQ(mass_of(*robot, "empty"), 0.5);
}

// Would catch totals of which bodies that are passed over, and what hangs on them, have no part.
// Half of 10 kg is asked for.
TEST(MjcfMasses, AddUpToTheTotalOfTheFile) {
  Diagnostics diagnostics;
  const auto robot = read(
      "<compiler settotalmass='5'/><worldbody><body name='table'><geom size='1' mass='5'/>"
      "<body name='lamp'><inertial pos='0 0 1' mass='1' diaginertia='1 1 1'/></body></body>"
      "<body name='dog'><freejoint/><geom size='1' mass='3'/>"
      "<body name='leg'><joint name='hip'/><geom size='1' mass='1'/></body></body></worldbody>",
      diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_EQ(mass_of(*robot, "dog"), 1.5);
  EXPECT_EQ(mass_of(*robot, "leg"), 0.5);
}

// Would catch: limits that readers by urdfdom refuse, and placeholders of our own that are warned
// of.
TEST(MjcfLimits, OfWhatHasNoneAreNumbers) {
  Diagnostics diagnostics;
  const std::string body = arm("<body><joint type='slide' range='-1 2'/><geom size='1'/></body>" +
                               std::string("<body><joint type='slide'/><geom size='1'/></body>"));
  const auto text =
      as_robot_text("<mujoco model='m'>\n" + body + "</mujoco>", "m.xml", diagnostics);
  ASSERT_TRUE(text);
  EXPECT_EQ(text->urdf.find("inf\""), std::string::npos) << text->urdf;
  const auto robot = parse_robot(*text, diagnostics);
  ASSERT_TRUE(robot);
  for (const Diagnostic& each : diagnostics.list()) {
    EXPECT_EQ(each.severity, Severity::note) << to_string(each);
  }
  for (const Joint& joint : robot->joints) {
    if (!info_of(joint.type).moves()) continue;
    ASSERT_TRUE(joint.limits) << joint.name;
    EXPECT_EQ(joint.limits->effort.state(), LimitState::absent) << joint.name;
    EXPECT_EQ(joint.limits->velocity.state(), LimitState::absent) << joint.name;
  }
}

TEST(MjcfHints, SayWhatASceneDecides) {
  Diagnostics diagnostics;
  const auto robot = read(
      "<option gravity='0 0 -1.62'/><worldbody><body name='table'/><body name='dog' pos='0 0 1'>"
      "<freejoint/><geom size='0.2'/><body name='leg'><joint name='hip' stiffness='20' "
      "springref='90'/><geom size='0.1' pos='0 0 1'/></body></body></worldbody>",
      diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_EQ(robot->links[static_cast<std::size_t>(robot->root)].name, "dog");
  expect_diagnosed(
      diagnostics, "m.xml",
      {Severity::note, 2, "mujoco/worldbody/body[table]", "not part of the robot", ""});
  EXPECT_TRUE(robot->hints.floats);
  EXPECT_EQ(robot->hints.gravity, (std::array{0.0, 0.0, -1.62}));
  ASSERT_TRUE(robot->hints.springs.contains("hip"));
  EXPECT_EQ(robot->hints.springs.at("hip").stiffness, 20);
  EXPECT_EQ(robot->hints.springs.at("hip").rest, std::acos(0.0));
}

class MjcfFiles : public test::OwnFolder {};

TEST_F(MjcfFiles, NameTheIncludedOne) {
  write("part.xml", "<mujocoinclude>\n<body name='b' pos='1'/></mujocoinclude>");
  write("m.xml", "<mujoco><worldbody><include file='part.xml'/></worldbody></mujoco>");
  Diagnostics diagnostics;
  EXPECT_FALSE(read_robot_text((root_ / "m.xml").string(), diagnostics));
  expect_diagnosed(diagnostics, (root_ / "part.xml").string(),
                   {Severity::error, 2, "mujocoinclude/body[b]", "pos=\"1\" is not 3 numbers", ""});
}

// Would catch: files of before MuJoCo 3.3, which say of a geom that its mesh is a surface, read as
// others than those that say it of the mesh.
TEST_F(MjcfFiles, SayOfAMeshOrItsGeomThatItIsASurface) {
  write("wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const auto as_urdf = [&](const std::string& of_mesh, const std::string& of_geom) {
    write("m.xml", "<mujoco><asset><mesh file='wedge.obj'" + of_mesh + "/></asset>" +
                       arm("<geom type='mesh' mesh='wedge'" + of_geom + "/>") + "</mujoco>");
    Diagnostics diagnostics;
    const auto text = read_robot_text((root_ / "m.xml").string(), diagnostics);
    return text ? text->urdf : to_string(diagnostics);
  };
  const std::string surface = as_urdf(" inertia='shell'", "");
  EXPECT_EQ(as_urdf("", " shellinertia='true'"), surface);
  EXPECT_NE(as_urdf("", ""), surface);
}

}  // namespace
}  // namespace treeline
