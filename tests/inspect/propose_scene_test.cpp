// Would catch: a proposal that misses the hand, asks for rows that the joints cannot move, gives an
// arm a floating base or a dog a fixed one, or is not a readable scene.
#include "inspect/propose_scene.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "inspect/end_names.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

Robot read(const std::string& text) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(text, "r.urdf", diagnostics);
  EXPECT_TRUE(robot);
  return robot.value();
}

Robot read_own(const std::string& name) {
  Diagnostics diagnostics;
  return read_urdf(std::string(TREELINE_ROBOTS_DIR) + "/" + name + "/" + name + ".urdf",
                   diagnostics)
      .value();
}

Scene read_back(const Robot& robot, const SceneProposal& proposal) {
  Diagnostics diagnostics;
  const std::string text = print_scene(robot, proposal, "r.urdf", {Function::gravity});
  const auto scene = parse_scene(text, "scene.yaml", robot, diagnostics);
  EXPECT_TRUE(scene) << text;
  for (const Diagnostic& d : diagnostics.list()) {
    EXPECT_NE(d.severity, Severity::error) << to_string(d) << '\n' << text;
  }
  return scene.value_or(Scene{});
}

std::string rows_of(const ScenePoint& point) {
  const std::array<const char*, 6> names = {"x", "y", "z", "rx", "ry", "rz"};
  std::string list;
  for (std::size_t i = 0; i < 6; ++i) list += point.rows[i] ? std::string(names[i]) + " " : "";
  return list;
}

std::string list_points(const SceneProposal& proposal) {
  std::string list;
  for (const ScenePoint& point : proposal.points) list += point.link + ": " + rows_of(point) + "; ";
  return list;
}

const std::string kBody =
    "<inertial><mass value='1'/><origin xyz='0.1 0 -0.1'/>"
    "<inertia ixx='.1' ixy='0' ixz='0' iyy='.1' iyz='0' izz='.1'/></inertial>";

/// Joins links parent - child pairwise by joints that rotate about the axis.
std::string joined(const std::string& parent, const std::string& child, const std::string& axis,
                   const std::string& type = "continuous") {
  return "<link name='" + child + "'>" + kBody + "</link><joint name='" + child + "_joint' type='" +
         type + "'><origin xyz='0.2 0.1 -0.3'/><parent link='" + parent + "'/><child link='" +
         child + "'/><axis xyz='" + axis + "'/></joint>";
}

std::string robot_text(const std::string& root, const std::string& inside) {
  return "<robot name='r'><link name='" + root + "'>" + kBody + "</link>" + inside + "</robot>";
}

std::string leg(const std::string& name) {
  return joined("trunk", name + "_hip", "1 0 0") + joined(name + "_hip", name + "_thigh", "0 1 0") +
         joined(name + "_thigh", name + "_calf", "0 1 0") +
         joined(name + "_calf", name + "_foot", "", "fixed");
}

TEST(EndNames, AreToldByTheirLastWord) {
  const auto kind = [](const std::string& name) { return end_name(name).kind; };
  for (const char* name : {"tool0", "fr3_hand_tcp", "iiwa_link_ee", "ee_link", "tool_frame"}) {
    EXPECT_EQ(kind(name), EndKind::tool) << name;
  }
  for (const char* name : {"left_hand", "RSoftHand", "l_hand_palm", "gripper_link", "leftPalm"}) {
    EXPECT_EQ(kind(name), EndKind::hand) << name;
  }
  for (const char* name : {"FL_foot", "leftfoot", "LFoot", "l_sole", "LF_FOOT"}) {
    EXPECT_EQ(kind(name), EndKind::foot) << name;
  }
  EXPECT_EQ(kind("link_3.0_tip"), EndKind::tip);
  EXPECT_EQ(kind("wheel_left_link"), EndKind::wheel);
  EXPECT_EQ(kind("prop0_link"), EndKind::propeller);
  EXPECT_EQ(kind("head_camera_link"), EndKind::watching);
  for (const char* name : {"left_hand_force_torque", "l_hand_index_1", "knee", "", "link_7", "_"}) {
    EXPECT_EQ(kind(name), EndKind::other) << name;
  }
  EXPECT_TRUE(is_ground("world"));
  EXPECT_TRUE(is_ground("world_link"));
  EXPECT_FALSE(is_ground("base_link"));
}

TEST(EndNames, TellRolesOfLimbs) {
  const std::vector<std::pair<const char*, LimbRole>> expected = {
      {"left_knee_pitch", LimbRole::leg},
      {"legl_ank2", LimbRole::leg},
      {"FR_hip_rotor", LimbRole::leg},
      {"RightShoulderRollLink", LimbRole::arm},
      {"lforearm", LimbRole::arm},
      {"left_hand_index_1", LimbRole::finger},
      {"head_pitch_link", LimbRole::watching},
      {"caster_front_left_2_link", LimbRole::wheel},
      {"iris__rotor_3", LimbRole::propeller},
      {"leftheelspring", LimbRole::unknown},
      {"larm", LimbRole::arm},
      {"link_7", LimbRole::unknown}};
  for (const auto& [name, role] : expected) EXPECT_EQ(limb_word(name), role) << name;
  EXPECT_TRUE(is_sensor("wrist_left_ft_tool_link"));
  EXPECT_FALSE(is_sensor("left_hand"));
}

/// What an engineer who knows the robot writes: judged by hand, robot by robot.
struct KnownRobot {
  const char* file;  ///< in tests/data
  const char* kind;
  Base base;
  std::vector<std::string> points;
};

constexpr Base kHeld = Base::fixed, kFloats = Base::floating;
const std::vector<KnownRobot> kKnownRobots = {
    {"golden/anymal.urdf", "a quadruped", kFloats, {"LF_FOOT", "RF_FOOT", "LH_FOOT", "RH_FOOT"}},
    {"golden/panda.urdf", "an arm", kHeld, {"panda_hand_tcp"}},
    {"golden/solo12.urdf", "a quadruped", kFloats, {"FL_FOOT", "FR_FOOT", "HL_FOOT", "HR_FOOT"}},
    {"hands/shadow_hand.urdf", "a hand", kHeld, {"fftip", "mftip", "rftip", "lftip", "thtip"}},
    {"mjcf/aloha.xml", "a robot of 2 arms", kHeld, {"left/gripper", "right/gripper"}},
    {"mjcf/go1.xml", "a quadruped", kFloats, {"FR", "FL", "RR", "RL"}},
    {"mjcf/humanoid.xml",
     "a humanoid",
     kFloats,
     {"right_foot", "left_foot", "right_lower_arm", "left_lower_arm"}},
    {"published/abb_irb4600_ct.urdf", "an arm", kHeld, {"link6"}},
    {"published/allegro_hand_dots.urdf",
     "a hand",
     kHeld,
     {"link_3.0_tip", "link_7.0_tip", "link_11.0_tip", "link_15.0_tip"}},
    {"published/anymal_c.urdf",
     "a quadruped",
     kFloats,
     {"LF_FOOT", "RF_FOOT", "LH_FOOT", "RH_FOOT"}},
    {"published/as2_floating.urdf",
     "a quadruped",
     kHeld,
     {"FL_foot", "FR_foot", "RL_foot", "RR_foot"}},
    {"published/atlas_drake.urdf", "a humanoid", kFloats, {"l_hand", "r_hand", "l_foot", "r_foot"}},
    {"published/barrett_hand.urdf",
     "a hand",
     kHeld,
     {"finger_1_dist_link", "finger_2_dist_link", "finger_3_dist_link"}},
    {"published/baxter.urdf", "a robot of 2 arms", kHeld, {"right_hand_link", "left_hand_link"}},
    {"published/berkeley_humanoid.urdf", "a biped", kFloats, {"LL_FOOT", "LR_FOOT"}},
    {"published/bigman.urdf",
     "a humanoid",
     kFloats,
     {"RSoftHand", "LSoftHand", "r_sole", "l_sole"}},
    {"published/cassie_v4.urdf", "a biped", kFloats, {"leftfoot", "rightfoot"}},
    {"published/crazyflie_cf2x.urdf", "a drone", kFloats, {"base_link"}},
    {"published/dclaw.urdf", "a hand", kHeld, {"link_f1_head", "link_f2_head", "link_f3_head"}},
    {"published/dual_iiwa14.urdf",
     "a robot of 2 arms",
     kHeld,
     {"left_iiwa_link_ee", "right_iiwa_link_ee"}},
    {"published/ergocub.urdf",
     "a humanoid",
     kFloats,
     {"l_sole", "r_sole", "l_hand_palm", "r_hand_palm"}},
    {"published/fetch.urdf", "an arm", kHeld, {"gripper_link"}},
    {"published/fr3.urdf", "an arm", kHeld, {"fr3_hand_tcp"}},
    {"published/kinova_gen3_2f85.urdf", "an arm", kHeld, {"gen3_end_effector_link"}},
    {"published/nextage.urdf",
     "a robot of 2 arms",
     kHeld,
     {"LARM_JOINT5_Link", "RARM_JOINT5_Link"}},
    {"published/phantomx.urdf",
     "a robot of 6 legs",
     kFloats,
     {"tibia_rf", "tibia_rm", "tibia_rr", "tibia_lf", "tibia_lm", "tibia_lr"}},
    {"published/skydio_x2.urdf", "a drone", kHeld, {"x2"}},
    {"published/turtlebot3_waffle.urdf", "a wheeled base", kFloats, {"${namespace}base_footprint"}},
    {"published/ur5.urdf", "an arm", kHeld, {"tool0"}},
};

// Would catch: a robot of which the base, the tool, a foot or a hand is guessed wrong, or that gets
// points on wheels, heads or fingers of a hand.
TEST(ProposeScene, KnowsPublishedRobots) {
  for (const KnownRobot& expected : kKnownRobots) {
    Diagnostics diagnostics;
    const auto robot = read_urdf(tests::data_file(expected.file), diagnostics);
    ASSERT_TRUE(robot) << expected.file;
    const SceneProposal proposal = propose_scene(*robot, std::nullopt);
    EXPECT_EQ(proposal.kind, expected.kind) << expected.file;
    EXPECT_EQ(proposal.base, expected.base) << expected.file;
    std::vector<std::string> links;
    for (const ScenePoint& point : proposal.points) links.push_back(point.link);
    EXPECT_EQ(links, expected.points) << expected.file;
    read_back(*robot, proposal);
  }
}

// Would catch: a dog that is known by its names alone. The same legs on the ground are an unclear
// case, which stays held.
TEST(ProposeScene, KnowsLegsByTheirShape) {
  const auto nameless = [](const std::string& name, const std::string& hip) {
    return "<link name='" + name + "'>" + kBody + "</link><joint name='j" + name +
           "' type='continuous'><origin xyz='" + hip + "'/><parent link='a'/><child link='" + name +
           "'/><axis xyz='1 0 0'/></joint>" + joined(name, name + "b", "0 1 0") +
           joined(name + "b", name + "c", "0 1 0");
  };
  const std::string legs = nameless("p", "0.3 0.1 0") + nameless("q", "0.3 -0.1 0") +
                           nameless("s", "-0.3 0.1 0") + nameless("t", "-0.3 -0.1 0");
  const SceneProposal dog = propose_scene(read(robot_text("a", legs)), std::nullopt);
  EXPECT_EQ(dog.kind, "a quadruped");
  EXPECT_EQ(dog.base, Base::floating);
  const std::string held =
      "<link name='world'/><joint name='w' type='fixed'>"
      "<parent link='world'/><child link='a'/></joint>";
  EXPECT_EQ(propose_scene(read(robot_text("a", legs + held)), std::nullopt).base, Base::fixed);
}

// Would catch: fingers taken for ends of an arm whose links have no telling names, and wheels
// without such names taken for ends.
TEST(ProposeScene, KnowsHandsAndWheelsByTheirShape) {
  const auto short_one = [](const std::string& parent, const std::string& name,
                            const std::string& origin, const std::string& axis) {
    return "<link name='" + name +
           "'><inertial><mass value='.1'/><inertia ixx='.01' ixy='0' ixz='0' iyy='.01' iyz='0' "
           "izz='.01'/></inertial></link><joint name='j" +
           name + "' type='continuous'><origin xyz='" + origin + "'/><parent link='" + parent +
           "'/><child link='" + name + "'/><axis xyz='" + axis + "'/></joint>";
  };
  const std::string arm = joined("a", "b", "0 0 1") + joined("b", "c", "0 1 0") +
                          joined("c", "d", "0 1 0") + joined("d", "e", "1 0 0");
  const SceneProposal held =
      propose_scene(read(robot_text("a", arm + short_one("e", "x", "0 .02 -.1", "0 0 1") +
                                             short_one("e", "y", "0 -.02 -.1", "0 0 1"))),
                    std::nullopt);
  EXPECT_EQ(held.kind, "an arm");
  EXPECT_EQ(held.base, Base::fixed);
  ASSERT_EQ(held.points.size(), 1U) << list_points(held);
  EXPECT_EQ(held.points[0].link, "e");
  EXPECT_EQ(held.beyond.size(), 2U);
  const SceneProposal rolling =
      propose_scene(read(robot_text("a", arm + short_one("a", "x", "0 .2 0", "0 1 0") +
                                             short_one("a", "y", "0 -.2 0", "0 1 0"))),
                    std::nullopt);
  EXPECT_EQ(rolling.kind, "a mobile manipulator");
  EXPECT_EQ(rolling.base, Base::floating);
  ASSERT_EQ(rolling.points.size(), 1U) << list_points(rolling);
  EXPECT_EQ(rolling.points[0].link, "e");
}

TEST(ProposeScene, HoldsTheToolOfAnArm) {
  const Robot robot = read_own("puma560");
  const SceneProposal proposal = propose_scene(robot, std::nullopt);
  ASSERT_EQ(proposal.points.size(), 1U);
  EXPECT_EQ(rows_of(proposal.points[0]), "x y z rx ry rz ");
  EXPECT_EQ(proposal.base, Base::fixed);
  const Scene scene = read_back(robot, proposal);
  EXPECT_EQ(scene.operational_points[0].link, proposal.points[0].link);
  EXPECT_TRUE(std::count(scene.functions.begin(), scene.functions.end(), Function::control_torque));
}

TEST(ProposeScene, AsksOnlyForWhatThePlaneAllows) {
  const SceneProposal proposal = propose_scene(read_own("planar3r"), std::nullopt);
  ASSERT_EQ(proposal.points.size(), 1U);
  EXPECT_EQ(std::count(proposal.points[0].rows.begin(), proposal.points[0].rows.end(), true), 3);
}

TEST(ProposeScene, LetsADogFloatOnFeetThatPush) {
  const Robot robot = read(robot_text(
      "trunk", leg("FL") + leg("FR") + leg("RL") + leg("RR") + joined("trunk", "head", "0 0 1")));
  const SceneProposal proposal = propose_scene(robot, std::nullopt);
  EXPECT_EQ(proposal.base, Base::floating);
  EXPECT_EQ(list_points(proposal),
            "FL_foot: x y z ; FR_foot: x y z ; RL_foot: x y z ; RR_foot: x y z ; ");
  EXPECT_EQ(proposal.left_out, std::vector<std::string>{"head"});
  EXPECT_EQ(read_back(robot, proposal).base, Base::floating);
  EXPECT_EQ(propose_scene(robot, Base::fixed).base, Base::fixed);
}

// Would catch: points on fingers instead of on the hand that carries them.
TEST(ProposeScene, TakesTheHandNotItsFingers) {
  const Robot robot = read(robot_text(
      "base", joined("base", "a", "0 0 1") + joined("a", "b", "0 1 0") + joined("b", "c", "0 1 0") +
                  joined("c", "my_hand", "1 0 0") + joined("my_hand", "finger_left", "0 1 0") +
                  joined("my_hand", "finger: \"right\"", "0 1 0")));
  const SceneProposal proposal = propose_scene(robot, std::nullopt);
  ASSERT_EQ(proposal.points.size(), 1U) << list_points(proposal);
  EXPECT_EQ(proposal.points[0].link, "my_hand");
  EXPECT_EQ(proposal.beyond.size(), 2U);
  EXPECT_EQ(std::count(proposal.points[0].rows.begin(), proposal.points[0].rows.end(), true), 4);
  // What is proposed in comments is also a valid scene.
  std::string text = print_scene(robot, proposal, "r.urdf", {});
  const auto at = text.find("# locked:");
  ASSERT_NE(at, std::string::npos);
  for (auto line = at; line < text.size() && text[line] == '#'; line = text.find('\n', line) + 1) {
    text.replace(line, 2, "");
  }
  Diagnostics diagnostics;
  const auto scene = parse_scene(text, "scene.yaml", robot, diagnostics);
  ASSERT_TRUE(scene) << text;
  EXPECT_EQ(scene->locked.size(), 2U);
}

TEST(ProposeScene, TakesFingersWhereThereIsNothingElse) {
  const SceneProposal proposal = propose_scene(
      read(robot_text("palm", joined("palm", "f1", "0 1 0") + joined("f1", "f1_tip", "0 1 0") +
                                  joined("palm", "f2", "0 1 0") + joined("f2", "f2_tip", "0 1 0"))),
      std::nullopt);
  EXPECT_EQ(proposal.points.size(), 2U) << list_points(proposal);
  EXPECT_EQ(proposal.base, Base::fixed);
}

// Would catch: a row of a pendulum that vanishes twice per turn.
TEST(ProposeScene, GivesAPendulumTheRowThatNeverVanishes) {
  const SceneProposal proposal =
      propose_scene(read(robot_text("base", joined("base", "bob", "0 0 1"))), std::nullopt);
  EXPECT_EQ(list_points(proposal), "bob: rz ; ");
}

TEST(ProposeScene, NamesInAnyScriptAreReadBack) {
  const Robot robot = read(robot_text(
      "base", joined("base", "yes", "0 0 1") + joined("base", "a#b: [c]", "0 1 0") +
                  joined("base", "\xE5\x85\xB3", "1 0 0") +
                  joined("base", "it&apos;s \"b\\\"", "0 0 1") + joined("base", "12", "0 0 1")));
  const SceneProposal proposal = propose_scene(robot, std::nullopt);
  const Scene scene = read_back(robot, proposal);
  ASSERT_EQ(scene.operational_points.size(), proposal.points.size());
  for (std::size_t i = 0; i < proposal.points.size(); ++i) {
    EXPECT_EQ(scene.operational_points[i].link, proposal.points[i].link);
  }
}

// Would catch: rows that are independent one by one but not together. The criterion is independent:
// singular values of the interpreter's Jacobian at states that the choice has not used.
TEST(ProposeScene, RowsAreIndependentTogether) {
  for (const char* name : {"puma560", "ur10e", "samm", "humanoid24", "planar3r", "tumbler"}) {
    const Robot robot = read_own(name);
    for (const Base base : {Base::fixed, Base::floating}) {
      const SceneProposal proposal = propose_scene(robot, base);
      EXPECT_FALSE(proposal.points.empty()) << name;
      const Scene scene = read_back(robot, proposal);
      const auto model = model_from_robot<double>(robot, scene);
      const auto points = points_from_scene(model, scene.operational_points);
      interpreter::Vector<double> q = interpreter::Vector<double>::Zero(model.nq);
      double best = 0;
      for (int state = 1; state <= 20; ++state) {
        for (int i = 0; i < model.nq; ++i) q[i] = std::sin(state * 1.3 + i * 2.1);
        for (const auto& body : model.bodies) {
          if (body.kind == interpreter::JointKind::floating) q.segment(body.q + 3, 4) << 0, 0, 0, 1;
        }
        const Eigen::MatrixXd J = interpreter::jacobian<double>(model, points, q);
        ASSERT_LE(J.rows(), J.cols()) << name;
        const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(J).singularValues();
        best = std::max(best, values[values.size() - 1] / values[0]);
      }
      EXPECT_GT(best, 1e-4) << name << ' ' << list_points(proposal);
    }
  }
}

// What a file says beside URDF: a reader of another format leaves it in the hints.
TEST(ProposeScene, TakesWhatTheFileSays) {
  Robot robot = read("<robot name='r'><link name='a'>" + kBody + "</link><link name='b'>" + kBody +
                     "</link><joint name='j' type='continuous'><parent link='a'/><child link='b'/>"
                     "</joint></robot>");
  robot.hints.floats = true;
  robot.hints.gravity = {0, 0, -1.62};
  robot.hints.springs["j"] = {20, 0.5};
  robot.hints.loops.push_back(
      {{"closing_bar", {"a", {{0, 0, 1}, {}}}, {"b", {}}, {true, false, true, false, false, false}},
       "links closing_bar_1 and closing_bar_2, which are to meet"});
  const SceneProposal proposal = propose_scene(robot, {});
  const Scene scene = read_back(robot, proposal);
  EXPECT_EQ(scene.base, Base::floating);
  EXPECT_EQ(scene.gravity, (std::array{0.0, 0.0, -1.62}));
  ASSERT_EQ(scene.loops.size(), 1U);
  EXPECT_EQ(scene.loops[0].first.origin.xyz, (std::array{0.0, 0.0, 1.0}));
  EXPECT_EQ(scene.loops[0].first.rows, (std::array{true, false, true, false, false, false}));
  const std::string text = print_scene(robot, proposal, "r.urdf", {});
  EXPECT_NE(text.find("because the file says so"), std::string::npos) << text;
  EXPECT_NE(text.find("#   j: {stiffness: 20, rest: 0.5}"), std::string::npos) << text;
  EXPECT_NE(text.find("# links closing_bar_1 and closing_bar_2, which are to meet"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace treeline
