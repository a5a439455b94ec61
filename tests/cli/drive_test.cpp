#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "../own_environment.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "drive_fixture.hpp"
#include "interpreter/instances.hpp"
#include "launch/split_ball_joints.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

/// How far the interpreter's point is from where it was commanded, m.
double distance(const interpreter::PointPose<double>& pose, const Eigen::Vector3d& wanted) {
  return (pose.position - wanted).norm();
}

// Would catch: a command that moves the tool elsewhere or turns it otherwise.
TEST_F(DriveTest, PumaArrives) {
  const std::string urdf = kRobots + "/puma560/puma560.urdf";
  const std::string scene = kRobots + "/puma560/scene.yaml";
  const std::string ready =
      "start\njoint joint2 to -45 deg in 1 s\njoint joint3 to 90 deg in 1 s\n"
      "joint joint5 to 0.8 in 1 s\nwait\n";
  const Arrival before = arrive(urdf, scene, ready);
  const Arrival after = arrive(urdf, scene,
                               ready +
                                   "move tool by -0.05 0.1 -0.1 in 1.5 s\n"
                                   "turn tool by 0 0 20 deg in 1.5 s\nwait\n");
  ASSERT_EQ(after.poses.size(), 1U);
  const Eigen::Vector3d wanted = before.poses[0].position + Eigen::Vector3d(-0.05, 0.1, -0.1);
  EXPECT_LT(distance(after.poses[0], wanted), 1e-3);
  const double angle = 20 * std::numbers::pi / 180;
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * before.poses[0].rotation;
  EXPECT_LT((after.poses[0].rotation - turned).norm(), 1e-3);
  EXPECT_EQ(after.state["mode"], "idle");
  EXPECT_EQ(after.state["fault"], "");
  EXPECT_NEAR(before.state["q"][1].get<double>(), -std::numbers::pi / 4, 1e-4);
}

TEST_F(DriveTest, SammArrives) {
  const Arrival before =
      arrive(kRobots + "/samm/samm.urdf", kRobots + "/samm/scene.yaml", "start\n");
  const auto& p = before.poses.at(0).position;
  const Arrival after = arrive(kRobots + "/samm/samm.urdf", kRobots + "/samm/scene.yaml",
                               "start\nmove tool by 0.3 -0.2 -0.1 in 2 s\nwait\n");
  EXPECT_LT(distance(after.poses.at(0), p + Eigen::Vector3d(0.3, -0.2, -0.1)), 1e-3);
}

// A floating base stays while a hand moves, and moves while the hands stay.
TEST_F(DriveTest, TheFloatingHumanoidArrives) {
  const std::string urdf = kRobots + "/humanoid24/humanoid24.urdf";
  const std::string scene = kRobots + "/humanoid24/scene_floating.yaml";
  const Arrival before = arrive(urdf, scene, "start\n");
  const Arrival after = arrive(urdf, scene,
                               "start\nmove left_hand by 0.1 0 0.1 in 1 s\nwait\n"
                               "mode joint\nmove base by 0 0 0.05 in 1 s\nwait\n");
  const auto& left = before.poses.at(0).position;
  const auto& right = before.poses.at(1).position;
  EXPECT_LT(distance(after.poses.at(0), left + Eigen::Vector3d(0.1, 0, 0.15)), 3e-2);
  EXPECT_LT(distance(after.poses.at(1), right + Eigen::Vector3d(0, 0, 0.05)), 3e-2);
}

// Under gravity compensation a pull adds J^T f to the torque, for the force that is reported and
// the place of the link where the hand is. The forearm is heavy enough that the pull reaches no
// limit of acceleration. Would catch: a force on another link or with another lever.
TEST_F(DriveTest, APullIsAForceOnTheLink) {
  const std::string urdf = kRobots + "/puma560/puma560.urdf";
  Diagnostics diagnostics;
  const auto robot = read_urdf(urdf, diagnostics);
  const auto scene =
      parse_scene("operational_points: [{name: hand, link: link3, origin: {xyz: [0.05, 0, 0.1]}}]",
                  "hand", *robot, diagnostics);
  const auto model = model_from_robot<double>(*robot, *scene);
  const auto points = points_from_scene(model, scene->operational_points);
  interpreter::Vector<double> start(6);
  start << 0.2, -0.8, 1.5, 0.3, 0.7, 0.1;
  const auto hand = interpreter::forward_kinematics<double>(model, points, start).at(0).position;
  const Outcome outcome =
      drive(urdf + " " + kRobots + "/puma560/scene.yaml",
            "start\nmode gravity\nwait 0.5 s\npull link3 at 0.05 0 0.1 to " +
                std::to_string(hand[0] + 0.004) + " " + std::to_string(hand[1] - 0.002) + " " +
                std::to_string(hand[2] + 0.002) + "\nwait 0.1 s\nbrake\nwait\n",
            "--q 0.2,-0.8,1.5,0.3,0.7,0.1 --record record.jsonl");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto vector = [](const json& numbers) {
    const auto list = numbers.get<std::vector<double>>();
    return interpreter::Vector<double>(
        interpreter::Vector<double>::Map(list.data(), static_cast<Eigen::Index>(list.size())));
  };
  std::istringstream lines(test::read_file(root_ / "record.jsonl"));
  int pulled = 0;
  for (std::string line; std::getline(lines, line);) {
    const json entry = json::parse(line);
    if (entry["type"] != "state" || entry["forces"].empty()) continue;
    ++pulled;
    const auto q = vector(entry["q"]);
    const auto qd = vector(entry["qd"]);
    const auto force = vector(entry["forces"][0]["force"]);
    const auto J = interpreter::jacobian<double>(model, points, q);
    const interpreter::Vector<double> tau =
        interpreter::inverse_dynamics<double>(model, q, qd, -2.0 * qd) +
        J.topRows(3).transpose() * force;
    EXPECT_LT((vector(entry["tau"]) - tau).norm(), 1e-6) << line;
    EXPECT_GT(force.norm(), 0.0);
  }
  EXPECT_GT(pulled, 5);
}

// A hand that pulls as hard as it can, for a long time, breaks no limit.
TEST_F(DriveTest, NoPullBreaksALimit) {
  std::string script = "start\nmode gravity\n";
  for (int i = 0; i < 30; ++i) {
    script += std::string("pull tool at 0 0 0.1 to ") + (i < 15 ? "3 2 -1" : "-3 -2 3") +
              "\nwait 0.1 s\n";
  }
  const Outcome outcome =
      drive(kRobots + "/puma560/puma560.urdf " + kRobots + "/puma560/scene.yaml", script);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// Without a scene the joints are driven.
TEST_F(DriveTest, ARobotWithoutASceneArrives) {
  const Outcome outcome = drive(kRobots + "/planar3r/planar3r.urdf",
                                "start\njoint joint2 to 30 deg in 1 s\nwait\nposture home\nwait\n"
                                "joint joint1 by -0.25\nwait\n");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json state = json::parse(outcome.out);
  EXPECT_NEAR(state["q"][0].get<double>(), -0.25, 1e-4);
  EXPECT_NEAR(state["q"][1].get<double>(), 0.0, 1e-4);
}

// The same script gives the same motion: without real time nothing depends on threads.
TEST_F(DriveTest, IsRepeatable) {
  const std::string robot = kRobots + "/planar3r/planar3r.urdf";
  const std::string script = "start\njoint joint1 to 1 in 1 s\nwait 0.3 s\nhold\nwait\n";
  const json first = json::parse(drive(robot, script).out);
  const json second = json::parse(drive(robot, script).out);
  EXPECT_EQ(first["q"], second["q"]);
  EXPECT_EQ(first["time"], second["time"]);
}

// Would catch: the advice to list functions, which `generate` has, beside what `drive` says itself;
// a centre of mass that is led like a frame on a link.
TEST_F(DriveTest, SaysOnceWhatItLeavesOfAScene) {
  write("passive.yaml",
        "passive: [joint2]\nexternal_forces: [{name: push, link: link3}]\n"
        "operational_points: [{name: com, center_of_mass: true, rows: [x]}]\n"
        "functions: [gravity]\n");
  const Outcome outcome = drive(kRobots + "/planar3r/planar3r.urdf passive.yaml", "start\n");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("left out while the robot is driven: external_forces, the centre of "
                             "mass, passive"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(outcome.err.find("no function takes them"), std::string::npos) << outcome.err;
}

TEST_F(DriveTest, SaysWhatWentWrong) {
  const std::string robot = kRobots + "/planar3r/planar3r.urdf";
  const Outcome unknown = drive(robot, "start\njoint elbow to 1\n");
  EXPECT_EQ(unknown.exit_code, 1);
  EXPECT_NE(unknown.err.find("line 2: there is no joint `elbow`"), std::string::npos);
  const Outcome idle = drive(robot, "joint joint1 to 1\n");
  EXPECT_EQ(idle.exit_code, 1);
  EXPECT_NE(idle.err.find("`start` first"), std::string::npos);
  const Outcome stopped = drive(robot, "start\nwait 0.1 s\nstop\nwait 0.1 s\n");
  EXPECT_EQ(stopped.exit_code, 3);
  EXPECT_NE(stopped.err.find("emergency stop"), std::string::npos);
  EXPECT_EQ(drive(robot, "start\n", "--q 1,2").exit_code, 1);
  EXPECT_EQ(drive(robot, "start\n", "--rate 1").exit_code, 2);
  EXPECT_EQ(drive(robot, "start\n", "--package arm").exit_code, 1);
}

// Would catch: an option that is refused only after seconds of compiling, or a measurement of ten
// minutes that cannot be written. There is no compiler here to wait for.
TEST_F(DriveTest, RefusesOptionsBeforeItCompiles) {
  test::OwnEnvironment environment;
  environment.set("CXX", "/no/compiler");
  environment.set("TREELINE_CACHE", "");
  const auto refused = [this](const std::string& options, int exit_code, const std::string& why) {
    const Outcome outcome = run_drive(options);
    EXPECT_EQ(outcome.exit_code, exit_code) << options;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << options << '\n' << outcome.err;
    EXPECT_EQ(outcome.err.find("compiler"), std::string::npos) << options << '\n' << outcome.err;
  };
  refused("--headless --q 1,2", 1, "2 numbers are given, the robot has 3");
  refused("--headless --friction nojoint=3", 1, "no joint \"nojoint\"");
  refused("--headless --sensor-noise -1", 1, "is no number from 0 on");
  refused("--headless --backlash 0.01", 1, "its rotor has no inertia");
  refused("--headless --reference none.jsonl", 1, "none.jsonl");
  refused("--headless --record none/motion.jsonl", 1,
          "none/motion.jsonl: error: cannot be written");
  refused("--latency --report none/latency", 1, "none/latency.json: error: cannot be written");
  refused("--headless --robot udp:7000", 2, "HOST:PORT");
  refused("--headless --act-as-robot here", 2, "HOST:PORT");
  EXPECT_NE(run_drive("--headless").err.find("/no/compiler"), std::string::npos);
}

// A published arm that is stretched at q = 0, where hardly any goal can be followed. Would catch: a
// start from there, a goal that a joint cannot follow, a task that misses it.
TEST_F(DriveTest, StretchedArmsStartBentAndArrive) {
  const std::string urdf = kRobots + "/../tests/data/published/ur5.urdf";
  write("scene.yaml", "operational_points: [{name: tip, link: tool0}]\n");
  const std::string scene = (root_ / "scene.yaml").string();
  const Outcome outcome = drive(
      urdf + " " + scene, "start\nmove tip by -0.1 0.05 0.1\nwait\nturn tip by 0 0 30 deg\nwait\n",
      "--record record.jsonl");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("it starts bent"), std::string::npos) << outcome.err;
  std::istringstream lines(test::read_file(root_ / "record.jsonl"));
  std::string first;
  while (std::getline(lines, first) && json::parse(first)["type"] != "state") {
  }
  const auto pose_at = [&](const json& state) { return poses_at(urdf, scene, state).at(0); };
  const auto before = pose_at(json::parse(first));
  const auto after = pose_at(json::parse(outcome.out));
  EXPECT_LT(distance(after, before.position + Eigen::Vector3d(-0.1, 0.05, 0.1)), 1e-3);
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(std::numbers::pi / 6, Eigen::Vector3d::UnitZ()) * before.rotation;
  EXPECT_LT((after.rotation - turned).norm(), 2e-3);
}

// A joint that is too weak is named before anything moves, with what it would need. It is as strong
// as that unless a place is stated.
TEST_F(DriveTest, NamesJointsThatAreTooWeak) {
  write("weak.urdf", R"(<robot name="weak"><link name="world"/>
<link name="rod"><inertial><mass value="2"/><origin xyz="0.5 0 0"/>
<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
<joint name="hinge" type="revolute"><parent link="world"/><child link="rod"/><axis xyz="0 1 0"/>
<limit lower="-0.2" upper="0.2" effort="3" velocity="1"/></joint></robot>)");
  const Outcome outcome = drive("weak.urdf", "start\nwait 1 s\n");
  // 2 kg at 0.5 m: 9.81 cos(0.18) = 9.65 N m where it starts, near its limit
  EXPECT_NE(outcome.err.find("was found: hinge needs 9.6"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("of 3 N m"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NEAR(json::parse(outcome.out)["qd"][0].get<double>(), 0.0, 1e-9);
  const Outcome measured =
      test::run_program(root_, "drive weak.urdf --latency --seconds 20 --load 0 --q 0");
  EXPECT_EQ(measured.exit_code, 3);
  EXPECT_NE(measured.out.find("ended in a fault: hinge moves at"), std::string::npos)
      << measured.out;
  // Near its limit it does not get so fast: it sinks to its end stop and rests there.
  const Outcome rests = drive("weak.urdf", "start\nwait 2 s\n", "--q 0.18");
  EXPECT_EQ(rests.exit_code, 0) << rests.err;
  EXPECT_NEAR(json::parse(rests.out)["q"][0].get<double>(), 0.2, 1e-4);
}

// Four coordinates must not be taken for four angles: a ball joint is three hinges. Its orientation
// is Rx(a) Ry(b) Rz(c), by hand.
TEST_F(DriveTest, ABallJointIsDrivenAsThreeHinges) {
  write("ball.urdf", R"(<robot name="pendulum"><link name="world"/>
<link name="bob"><inertial><mass value="1"/><origin xyz="0 0 -0.3"/>
<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
<joint name="swivel" type="ball"><origin xyz="0 0 1"/><parent link="world"/><child link="bob"/>
</joint></robot>)");
  write("scene.yaml",
        "operational_points: [{name: tip, link: bob, origin: {xyz: [0, 0, -0.5]}}]\n");
  const Outcome outcome = drive("ball.urdf scene.yaml",
                                "start\njoint swivel.x to 0.4\njoint swivel.y to -0.3\n"
                                "joint swivel.z to 0.7\nwait\n",
                                "--record record.jsonl");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("driven as hinges swivel.x, swivel.y and swivel.z"),
            std::string::npos);
  const json state = json::parse(outcome.out);
  EXPECT_EQ(state["fault"], "");
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()) *
                                Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()))
                                   .toRotationMatrix();
  const Eigen::Vector3d tip = Eigen::Vector3d(0, 0, 1) + turn * Eigen::Vector3d(0, 0, -0.5);
  const auto at = state["points"][0]["at"].get<std::vector<double>>();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(at[static_cast<std::size_t>(i)], tip[i], 1e-4) << i;
  const Outcome drawn =
      test::run_program(root_, "draw ball.urdf --motion record.jsonl --svg a.svg");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  // What the page shows has the same joints.
  write("shown.urdf", std::string(split_ball_joints(test::read_file(root_ / "ball.urdf"))));
  const Outcome again = drive("shown.urdf scene.yaml", "start\n");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["q"].size(), 3U);
}

// In real time one second lasts one second, and a record has what happened.
TEST_F(DriveTest, RunsInRealTimeAndRecords) {
  const std::string robot = kRobots + "/planar3r/planar3r.urdf";
  const Outcome outcome = drive(robot, "start\njoint joint1 to 0.5 in 1 s\nwait\n",
                                "--real-time --record record.jsonl --warnings none");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NEAR(json::parse(outcome.out)["q"][0].get<double>(), 0.5, 1e-2);
  std::istringstream lines(test::read_file(root_ / "record.jsonl"));
  int states = 0;
  int commands = 0;
  for (std::string line; std::getline(lines, line);) {
    const json entry = json::parse(line);
    states += entry["type"] == "state" ? 1 : 0;
    commands += entry["type"] == "command" ? 1 : 0;
  }
  EXPECT_GT(states, 50);
  EXPECT_EQ(commands, 2);
}

// The loop and the simulated robot as two processes that talk over UDP.
TEST_F(DriveTest, DrivesARobotOverUdp) {
  const std::string robot = kRobots + "/planar3r/planar3r.urdf";
  const std::string address = "127.0.0.1:" + std::to_string(20000 + ::getpid() % 20000);
  write("script.txt", "start\njoint joint1 to 0.5 in 1 s\nwait\n");
  const std::string command =
      "cd " + root_.string() + " && { '" + std::string(TREELINE_PROGRAM) + "' drive " + robot +
      " --act-as-robot " + address +
      " --warnings none >robot.txt 2>&1 & } && "
      "i=0; until grep -qs listens robot.txt || [ $i -gt 600 ]; do sleep 0.1; i=$((i+1)); done; '" +
      std::string(TREELINE_PROGRAM) + "' drive " + robot + " --robot udp:" + address +
      " --headless --script script.txt >end.json 2>end.txt; code=$?; kill -TERM $!; wait $!; "
      "exit $code";
  EXPECT_EQ(std::system(command.c_str()), 0)
      << test::read_file(root_ / "end.txt") << test::read_file(root_ / "robot.txt");
  const json state = json::parse(test::read_file(root_ / "end.json"));
  EXPECT_NEAR(state["q"][0].get<double>(), 0.5, 2e-2);
  EXPECT_EQ(state["mode"], "idle");
}

TEST_F(DriveTest, SaysThatNoRobotAnswers) {
  write("script.txt", "start\n");
  const Outcome outcome = run_drive("--robot udp:127.0.0.1:9 --headless --script script.txt");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("no robot answers"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace treeline
