// Would catch: a proposal that misses the hand, asks for rows that the joints cannot move, gives an
// arm a floating base or a dog a fixed one, or is not a readable scene.
#include "inspect/propose_scene.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>

#include "description/group_bodies.hpp"
#include "inspect/scene_proposals.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

using test::joined, test::kBody, test::leg, test::list_points, test::read, test::read_back,
    test::read_own, test::robot_text, test::rows_of;

/// What is proposed in comments from `begin` on is a valid scene, too.
Scene read_with(const Robot& robot, const SceneProposal& proposal, const std::string& begin) {
  std::string text = print_scene(robot, proposal, "r.urdf", {});
  const auto at = text.find(begin);
  EXPECT_NE(at, std::string::npos) << text;
  for (auto line = at; line < text.size() && text[line] == '#'; line = text.find('\n', line) + 1) {
    text.replace(line, 2, "");
  }
  Diagnostics diagnostics;
  const auto scene = parse_scene(text, "scene.yaml", robot, diagnostics);
  EXPECT_TRUE(scene) << text;
  return scene.value_or(Scene{});
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
  EXPECT_EQ(read_with(robot, proposal, "# ground:").constraints.size(), 4U);
}

// Would catch: a contact in the middle of a ball, a radius above where the ground pushes.
TEST(ProposeScene, PutsContactsUnderBalls) {
  std::vector<TouchShape> shapes;
  const auto touch = [&](const std::string& link, const Eigen::Vector3d& middle) {
    TouchShape ball{link};
    ball.pose.translation() = middle;
    ball.radius = 0.03;
    shapes.push_back(ball);
  };
  for (const char* link : {"FL_foot", "FR_foot", "RL_foot", "RR_foot"}) touch(link, {0, 0, 0.01});
  const SceneProposal dog = propose_scene(
      read(robot_text("trunk", leg("FL") + leg("FR") + leg("RL") + leg("RR"))), {}, shapes);
  ASSERT_EQ(dog.feet.size(), 4U);
  EXPECT_EQ(dog.points[0].origin.xyz, (std::array<double, 3>{}));  // the file's frame
  EXPECT_EQ(dog.feet[0].origin.xyz, (std::array{0.0, 0.0, -0.02}));

  const Robot robot = read_own("tumbler");  // no frames at feet; the shanks lean
  const BodyTree tree = group_bodies(robot);
  shapes.clear();
  for (const Link& link : robot.links) {
    if (link.name.ends_with("shank")) touch(link.name, {0, 0, -0.18});
  }
  const SceneProposal tumbler = propose_scene(robot, {}, shapes);
  ASSERT_EQ(tumbler.feet.size(), 4U);
  for (const ScenePoint& foot : tumbler.feet) {
    const auto& xyz = foot.origin.xyz;
    const Eigen::Vector3d from_middle(xyz[0], xyz[1], xyz[2] + 0.18);
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      if (robot.links[i].name != foot.link) continue;
      const Eigen::Vector3d down = tree.frames[i].linear() * from_middle;
      EXPECT_LT((down - Eigen::Vector3d(0, 0, -0.03)).norm(), 2e-5) << foot.link;
    }
    EXPECT_NE(tumbler.remarks.at(foot.link).find("ball touches the ground"), std::string::npos);
  }
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
  EXPECT_EQ(read_with(robot, proposal, "# locked:").locked.size(), 2U);
}

/// A frame without mass, fixed to a link.
std::string frame_on(const std::string& parent, const std::string& name) {
  return "<link name='" + name + "'/><joint name='" + name +
         "_at' type='fixed'><origin xyz='0 0 "
         "0.1'/><parent link='" +
         parent + "'/><child link='" + name + "'/></joint>";
}

// Would catch: a word with "frame", "target" or "site" glued to it that is not known, so that the
// point lies at a joint though the file has a frame at the tip.
TEST(ProposeScene, TakesTheFrameThatIsNamedAfterGrasping) {
  for (const std::string frame : {"arm_grasptarget", "gripperframe", "ee_site", "pinchsite"}) {
    const Robot robot = read(robot_text(
        "base", joined("base", "a", "0 0 1") + joined("a", "b", "0 1 0") +
                    joined("b", "c", "0 1 0") + joined("c", "my_gripper", "1 0 0") +
                    frame_on("my_gripper", frame) + joined("my_gripper", "moving_jaw", "0 1 0")));
    EXPECT_EQ(propose_scene(robot, std::nullopt).points.at(0).link, frame);
  }
}

// Would catch: points at the frames of an export from Onshape that are only to meet, as on the legs
// of a platform, in place of one on what the legs carry.
TEST(ProposeScene, GivesNoPointToWhereLoopsClose) {
  const auto leg = [](const std::string& n) {
    return joined("base", "crank" + n, "0 1 0") + joined("crank" + n, "rod" + n, "0 1 0");
  };
  const Robot robot = read(robot_text(
      "base", leg("1") + frame_on("rod1", "closing_1_1") + leg("2") +
                  frame_on("rod2", "closing_2_1") + leg("3") + joined("rod3", "plate", "0 1 0") +
                  frame_on("plate", "closing_1_2") + frame_on("plate", "closing_2_2")));
  const SceneProposal proposal = propose_scene(robot, std::nullopt);
  EXPECT_EQ(list_points(proposal), "plate: x z ry ; ");
  EXPECT_TRUE(proposal.left_out.empty());
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
