// Would catch: a robot whose kind, base, feet, hands, tool, gripper or wheels are guessed wrong.
#include "inspect/recognise_robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "data/list_data.hpp"
#include "inspect/end_names.hpp"
#include "inspect/scene_proposals.hpp"

namespace treeline {
namespace {

using test::joined, test::kBody, test::list_points, test::read, test::read_back, test::robot_text;

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

TEST(EndNames, TellToolsAndFlightByAnyWord) {
  EXPECT_EQ(end_name("/ee_gripper_link").kind, EndKind::tool);
  EXPECT_EQ(end_name("knee").kind, EndKind::other);
  EXPECT_EQ(word_of_flight("flying_arm_2__link1"), "flying");
  EXPECT_EQ(word_of_flight("Thruster_TOP_FL"), "thruster");
  EXPECT_FALSE(word_of_flight("flywheel"));
  EXPECT_FALSE(word_of_flight("drover_link"));
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
    {"published/panda_hand.urdf", "an arm", kHeld, {"panda_hand_tcp"}},
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
  const auto with_two = [&](const std::string& on, const char* left, const char* right,
                            const char* axis) {
    const std::string two = short_one(on, "x", left, axis) + short_one(on, "y", right, axis);
    return propose_scene(read(robot_text("a", arm + two)), std::nullopt);
  };
  const SceneProposal held = with_two("e", "0 .02 -.1", "0 -.02 -.1", "0 0 1");
  EXPECT_EQ(held.kind, "an arm");
  EXPECT_EQ(held.base, Base::fixed);
  ASSERT_EQ(held.points.size(), 1U) << list_points(held);
  EXPECT_EQ(held.points[0].link, "e");
  EXPECT_EQ(held.beyond.size(), 2U);
  const SceneProposal rolling = with_two("a", "0 .2 0", "0 -.2 0", "0 1 0");
  EXPECT_EQ(rolling.kind, "a mobile manipulator");
  EXPECT_EQ(rolling.base, Base::floating);
  ASSERT_EQ(rolling.points.size(), 1U) << list_points(rolling);
  EXPECT_EQ(rolling.points[0].link, "e");
}

// Would catch: an arm on a vehicle in the air or the sea that is taken as held by the ground.
TEST(ProposeScene, LetsFloatWhatFlies) {
  const std::string arm = joined("a", "flying_arm_link1", "0 0 1") +
                          joined("flying_arm_link1", "flying_arm_link2", "0 1 0");
  const SceneProposal proposal = propose_scene(read(robot_text("a", arm)), std::nullopt);
  EXPECT_EQ(proposal.base, Base::floating);
  EXPECT_EQ(proposal.base_reason, "the file has the word \"flying\" in its names");
}

// Would catch: a gear or a rod beside a leg that counts as one more leg or gets a point, and a rod
// that hides the foot because it goes on for longer.
TEST(ProposeScene, PassesOverRodsBesideTheFoot) {
  std::string legs;
  for (const std::string side : {"left", "right"}) {
    legs += joined("pelvis", side + "_hip", "1 0 0") +
            joined(side + "_hip", side + "_knee", "0 1 0") +
            joined(side + "_knee", side + "_foot", "0 1 0") +
            joined(side + "_knee", side + "_foot_crank", "0 1 0") +
            joined(side + "_foot_crank", side + "_ankle_rod", "0 1 0");
  }
  const SceneProposal proposal = propose_scene(read(robot_text("pelvis", legs)), std::nullopt);
  EXPECT_EQ(proposal.kind, "a biped");
  ASSERT_EQ(proposal.points.size(), 2U) << list_points(proposal);
  EXPECT_EQ(proposal.points[0].link, "left_foot");
  EXPECT_EQ(proposal.points[1].link, "right_foot");
}

// Would catch: a point on the jaw of a gripper, whose joint alone tells it from the arm's next
// link.
TEST(ProposeScene, StopsBeforeTheJointOfAGripper) {
  const std::string arm = joined("a", "b", "0 0 1") + joined("b", "c", "0 1 0") +
                          joined("c", "d", "0 1 0") + "<link name='mover'>" + kBody +
                          "</link><joint name='jointGripper' "
                          "type='continuous'><parent link='d'/><child link='mover'/></joint>";
  const SceneProposal proposal = propose_scene(read(robot_text("a", arm)), std::nullopt);
  ASSERT_EQ(proposal.points.size(), 1U) << list_points(proposal);
  EXPECT_EQ(proposal.points[0].link, "d");
  EXPECT_EQ(proposal.beyond, std::vector<std::string>{"jointGripper"});
}

// Would catch: a point at the knee of a leg whose file has no frame at the foot but a ball there,
// or on the side of a shank that lies.
TEST(ProposeScene, PutsAFootWhereItTouches) {
  std::string legs;
  for (const std::string side : {"left", "right"}) {
    legs +=
        joined("trunk", side + "_hip", "1 0 0") + joined(side + "_hip", side + "_knee", "0 1 0");
  }
  const Robot robot = read(robot_text("trunk", legs));
  const auto at = [](double x, double y, double z) {
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
  };
  const std::vector<TouchShape> shapes = {
      {"left_knee", at(0, 0, -0.1), {0.02, 0.02, 0.2}},  // a shank, above its foot
      {"left_knee", at(0, 0, 0), {0, 0, 0}},
      {"left_knee", at(0.1, 0.02, -0.2), {0, 0, 0}},
      {"left_knee", at(-0.06, 0.02, -0.201), {0, 0, 0}},
      {"right_knee", at(0.2, 0, 0), {0.4, 0.02, 0.02}}};
  const SceneProposal proposal = propose_scene(robot, std::nullopt, shapes);
  ASSERT_EQ(proposal.points.size(), 2U) << list_points(proposal);
  EXPECT_EQ(proposal.points[0].origin.xyz, (std::array{0.02, 0.02, -0.201}));
  EXPECT_EQ(proposal.points[1].origin.xyz, (std::array{0.0, 0.0, 0.0}));
  EXPECT_EQ(read_back(robot, proposal).operational_points[0].origin.xyz,
            proposal.points[0].origin.xyz);
  const SceneProposal sole =
      propose_scene(robot, std::nullopt, {{"left_knee", at(0.03, 0, -0.04), {0.2, 0.1, 0.02}}});
  EXPECT_EQ(sole.points[0].origin.xyz, (std::array{0.03, 0.0, -0.05}));
}

// Would catch: rows that move only because a file rounds a right angle to 1.57.
TEST(ProposeScene, AsksForNoRowThatIsARoundedRightAngle) {
  const std::string text =
      "<link name='b'>" + kBody +
      "</link><joint name='j' type='prismatic'><parent link='a'/>"
      "<origin rpy='1.57 0 0'/><child link='b'/><axis xyz='0 1 0'/><limit lower='0' upper='1' "
      "effort='1' velocity='1'/></joint>" +
      joined("b", "c", "0 1 0");
  const SceneProposal proposal = propose_scene(read(robot_text("a", text)), std::nullopt);
  EXPECT_EQ(list_points(proposal), "c: z rz ; ");
}

// Would catch: a point at a frame of a sensor, or on a camera that turns, of a base that rolls.
TEST(ProposeScene, PutsThePointOfAVehicleAtItsBase) {
  const auto wheel = [](const std::string& name, const std::string& origin) {
    return "<link name='" + name +
           "'><inertial><mass value='1'/><inertia ixx='.1' ixy='0' ixz='0' iyy='.1' iyz='0' "
           "izz='.1'/></inertial></link><joint name='j" +
           name + "' type='continuous'><origin xyz='" + origin +
           "'/><parent link='base'/><child "
           "link='" +
           name + "'/><axis xyz='0 1 0'/></joint>";
  };
  const std::string text = wheel("left_wheel", "0 .2 0") + wheel("right_wheel", "0 -.2 0") +
                           joined("base", "camera", "0 0 1") + joined("base", "deck", "", "fixed");
  const SceneProposal proposal = propose_scene(read(robot_text("base", text)), std::nullopt);
  EXPECT_EQ(proposal.kind, "a wheeled base");
  EXPECT_EQ(list_points(proposal), "base: x y z rx ry rz ; ");
}

}  // namespace
}  // namespace treeline
