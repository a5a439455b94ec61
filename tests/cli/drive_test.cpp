#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "program_test.hpp"

namespace treeline {
namespace {

using nlohmann::json;
using test::Outcome;

const std::string kRobots = TREELINE_ROBOTS;

/// The state at the end of a drive, and the interpreter's poses of the scene's points there.
struct Arrival {
  json state;
  std::vector<interpreter::PointPose<double>> poses;
};

class DriveTest : public test::OwnFolder {
 protected:
  [[nodiscard]] Outcome drive(const std::string& files, const std::string& script,
                              const std::string& options = "") const {
    write("script.txt", script);
    return test::run_program(root_,
                             "drive " + files + " --headless --script script.txt " + options);
  }

  [[nodiscard]] Outcome run_drive(const std::string& options) const {
    return test::run_program(root_, "drive " + kRobots + "/planar3r/planar3r.urdf " + options);
  }

  /// Drives a robot and finds where its points are, by the interpreter and the final coordinates.
  [[nodiscard]] Arrival arrive(const std::string& urdf, const std::string& scene,
                               const std::string& script) const {
    const Outcome outcome = drive(urdf + " " + scene, script);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    Arrival arrival{json::parse(outcome.out), {}};
    Diagnostics diagnostics;
    const auto robot = read_urdf(urdf, diagnostics);
    const auto read = read_scene(scene, *robot, diagnostics);
    const auto model = model_from_robot<double>(*robot, *read);
    const auto q = arrival.state["q"].get<std::vector<double>>();
    arrival.poses = interpreter::forward_kinematics<double>(
        model, points_from_scene(model, read->operational_points),
        interpreter::Vector<double>::Map(q.data(), static_cast<Eigen::Index>(q.size())));
    return arrival;
  }
};

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

// No command turns a ball joint yet: its four coordinates must not be taken for four angles.
TEST_F(DriveTest, RefusesBallJoints) {
  write("ball.urdf", R"(<robot name="pendulum"><link name="world"/>
<link name="bob"><inertial><mass value="1"/><origin xyz="0 0 -0.3"/>
<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
<joint name="swivel" type="ball"><parent link="world"/><child link="bob"/></joint></robot>)");
  const Outcome outcome = drive("ball.urdf", "start\n");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("robot/joint[swivel]: ball joints cannot be driven yet"),
            std::string::npos)
      << outcome.err;
}

// In real time one second lasts one second, a record has what happened, and a signal ends it.
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
  write("script.txt", "start\nwait 1000 s\n");
  const std::string command =
      "cd " + root_.string() + " && { '" + std::string(TREELINE_PROGRAM) + "' drive " + robot +
      " --headless --real-time --script script.txt --warnings none >end.json 2>end.txt & } && "
      "i=0; until grep -qs begins end.txt || [ $i -gt 600 ]; do sleep 0.1; i=$((i+1)); done; "
      "kill -TERM $!; wait $!";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(test::read_file(root_ / "end.txt").find("fault"), std::string::npos);
  EXPECT_EQ(json::parse(test::read_file(root_ / "end.json"))["mode"], "idle");
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

// The wrist of a PUMA 560 is sent past a ball that is in its way. By the interpreter it goes round,
// and never comes nearer than the clearance.
TEST_F(DriveTest, ThePointGoesRoundAnObstacle) {
  const std::string urdf = kRobots + "/puma560/puma560.urdf";
  const std::string point = "operational_points: [{name: wrist, link: link6, rows: [x, y, z]}]\n";
  write("scene.yaml",
        point +
            "obstacles: [{name: ball, sphere: {radius: 0.06}, origin: {xyz: [0.18, 0.24, "
            "1.35]}}]\n");
  const Outcome outcome = drive(urdf + " scene.yaml", "start\nmove wrist by 0 0.3 0 in 3 s\nwait\n",
                                "--q -0.4,-0.785,0.4,0,0.8,0 --record record.jsonl");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  Diagnostics diagnostics;
  const auto robot = read_urdf(urdf, diagnostics);
  const auto scene = parse_scene(point, "wrist", *robot, diagnostics);
  const auto model = model_from_robot<double>(*robot, *scene);
  const auto points = points_from_scene(model, scene->operational_points);
  std::istringstream lines(test::read_file(root_ / "record.jsonl"));
  double nearest = 1;
  std::vector<Eigen::Vector3d> path;
  for (std::string line; std::getline(lines, line);) {
    const json entry = json::parse(line);
    if (entry["type"] == "hello") {
      EXPECT_EQ(entry["obstacles"][0]["name"], "ball");
    }
    if (entry["type"] != "state") continue;
    const auto q = entry["q"].get<std::vector<double>>();
    path.push_back(interpreter::forward_kinematics<double>(
                       model, points, interpreter::Vector<double>::Map(q.data(), 6))
                       .at(0)
                       .position);
    const double distance = (path.back() - Eigen::Vector3d(0.18, 0.24, 1.35)).norm() - 0.06;
    nearest = std::min(nearest, distance);
    if (entry["mode"] == "running") {
      EXPECT_NEAR(entry["points"][0]["nearest"].get<double>(), distance, 1e-9);
    }
  }
  EXPECT_GT(nearest, 0.02);
  EXPECT_LT(nearest, 0.1);  // its straight way led through the ball
  EXPECT_LT((path.back() - path.front() - Eigen::Vector3d(0, 0.3, 0)).norm(), 5e-3);
}

// A rehearsal moves the twin and not the robot; then the robot does the same, to the last digits.
TEST_F(DriveTest, RehearsesThenGoes) {
  write("script.txt",
        "start\nwait\nrehearse\njoint joint1 to 0.5 in 1 s\njoint joint3 by -0.4 in 0.7 s\nwait\n"
        "go\nwait\n");
  const Outcome outcome =
      test::run_program(root_, "drive " + kRobots +
                                   "/puma560/puma560.urdf --headless --script script.txt --record "
                                   "record.jsonl --q 0,-0.8,0.8,0,0.6,0");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("the robot has done what was rehearsed"), std::string::npos);
  std::istringstream lines(test::read_file(root_ / "record.jsonl"));
  std::vector<std::vector<double>> twin, robot;
  for (std::string line; std::getline(lines, line);) {
    const json entry = json::parse(line);
    if (entry["type"] != "state" || entry["twin"].is_null()) continue;
    if (entry["twin"]["moving"]) {
      EXPECT_NEAR(entry["q"][0].get<double>(), 0.0, 1e-6);
      twin.push_back(entry["twin"]["q"].get<std::vector<double>>());
    } else {
      robot.push_back(entry["q"].get<std::vector<double>>());
    }
  }
  ASSERT_GT(twin.size(), 100U);
  ASSERT_GT(robot.size(), 100U);
  EXPECT_NEAR(twin.back()[0], 0.5, 1e-4);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(robot.back()[i], twin.back()[i], 1e-6);
}

TEST_F(DriveTest, RefusesARehearsalThatCannotBe) {
  const auto refused = [&](const std::string& script, const std::string& why) {
    write("script.txt", script);
    const Outcome outcome = run_drive("--headless --script script.txt");
    EXPECT_EQ(outcome.exit_code, 1) << script;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
  };
  refused("start\nwait\ngo\n", "`rehearse` first");
  refused("start\nwait\ndiscard\n", "there is no rehearsal");
  refused("start\njoint joint1 to 1\nrehearse\n", "the robot moves");
  refused("start\nwait\nrehearse\njoint joint1 to 1\ngo\n", "the twin has not ended");
  refused("start\nfollow\n", "--reference FILE");
}

// A record is a reference: the robot goes to where it begins and then the same way.
TEST_F(DriveTest, FollowsARecord) {
  write("script.txt", "start\njoint joint1 to 0.7 in 1 s\njoint joint3 to -0.5 in 1 s\nwait\n");
  ASSERT_EQ(run_drive("--headless --script script.txt --record record.jsonl").exit_code, 0);
  write("script.txt", "start\njoint joint2 to 0.3 in 0.5 s\nwait\nfollow in 0.5 s\nwait\n");
  const Outcome outcome = run_drive("--headless --script script.txt --reference record.jsonl");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto q = json::parse(outcome.out)["q"].get<std::vector<double>>();
  EXPECT_NEAR(q[0], 0.7, 1e-3);
  EXPECT_NEAR(q[1], 0.0, 1e-3);
  EXPECT_NEAR(q[2], -0.5, 1e-3);
  write("bad.csv", "time,q0,q1,q2\n0,0,0,0\n1,9,0,0\n");
  EXPECT_NE(
      run_drive("--headless --script script.txt --reference bad.csv").err.find("beyond its limits"),
      std::string::npos);
  const Outcome other =
      test::run_program(root_, "drive " + kRobots + "/puma560/puma560.urdf --replay record.jsonl");
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find("another URDF or scene"), std::string::npos) << other.err;
}

// Friction leaves an error, a delay and coarse encoders leave the robot where it was sent.
TEST_F(DriveTest, ARobotThatIsNotIdealArrivesLessExactly) {
  const std::string script = "start\njoint joint1 to 0.5 in 1 s\nwait\nwait 1 s\n";
  const auto error_with = [&](const std::string& options) {
    write("script.txt", script);
    const Outcome outcome = run_drive("--headless --script script.txt " + options);
    EXPECT_EQ(outcome.exit_code, 0) << options << outcome.err;
    return std::fabs(json::parse(outcome.out)["q"][0].get<double>() - 0.5);
  };
  const double ideal = error_with("");
  EXPECT_LT(ideal, 1e-6);
  const double rubbed = error_with("--friction 2");
  EXPECT_GT(rubbed, 10 * ideal);
  EXPECT_LT(rubbed, 0.05);
  EXPECT_LT(error_with("--delay 0.003 --quantisation 1e-4 --sensor-noise 1e-5"), 1e-3);
  EXPECT_LT(error_with("--backlash 0.002 --rotor joint1=0.5,joint2=0.3,joint3=0.1"), 2e-2);
}

TEST_F(DriveTest, RefusesWhatIsNoFaultOfARobot) {
  write("script.txt", "start\n");
  const std::string run = "--headless --script script.txt ";
  EXPECT_NE(run_drive(run + "--friction joint9=1").err.find("no joint \"joint9\""),
            std::string::npos);
  EXPECT_NE(run_drive(run + "--backlash 0.01").err.find("--rotor joint1=INERTIA"),
            std::string::npos);
  EXPECT_NE(run_drive(run + "--delay 0.5").err.find("0.063 s"), std::string::npos);
  EXPECT_NE(run_drive(run + "--sensor-noise -1").err.find("no number from 0 on"),
            std::string::npos);
  EXPECT_NE(run_drive(run + "--backlash 1 --rotor 1e-9 --gear-stiffness 1e9").err.find("too fast"),
            std::string::npos);
  EXPECT_NE(run_drive(run + "--robot udp:127.0.0.1:9 --friction 1").err.find("--act-as-robot"),
            std::string::npos);
}

/// A four-bar: crank of 0.2 m with the motor, coupler of 0.4 m on it, rocker of 0.3 m, 0.4 m apart.
std::string four_bar() {
  const auto link = [](const std::string& name, double length) {
    return "<link name='" + name + "'><inertial><origin xyz='" + std::to_string(length / 2) +
           " 0 0'/><mass value='1'/><inertia ixx='0.001' ixy='0' ixz='0' iyy='0.01' iyz='0' "
           "izz='0.01'/></inertial></link>";
  };
  const auto joint = [](const std::string& name, const std::string& parent,
                        const std::string& child, double x) {
    return "<joint name='" + name + "' type='revolute'><parent link='" + parent +
           "'/><child link='" + child + "'/><origin xyz='" + std::to_string(x) +
           " 0 0'/><axis xyz='0 0 1'/><limit lower='-3' upper='3' effort='50' "
           "velocity='10'/></joint>";
  };
  return "<robot name='fourbar'><link name='base'/>" + link("crank", 0.2) + link("coupler", 0.4) +
         link("rocker", 0.3) + joint("motor", "base", "crank", 0) +
         joint("knee", "crank", "coupler", 0.2) + joint("pivot", "base", "rocker", 0.4) +
         "</robot>";
}
const std::string kFourBarScene =
    "gravity: [0, -9.81, 0]\npassive: [knee, pivot]\n"
    "constraints:\n  - {name: closing, between: [rocker, coupler], origin: {xyz: [0.3, 0, 0]},\n"
    "     other_origin: {xyz: [0.4, 0, 0]}, rows: [x, y]}\n";

// The motor leads the crank to 1.2 rad under gravity; the loop stays closed by plane trigonometry,
// and joints without motors get no force. Would catch: a loop that opens, a motor that does not
// carry the coupler and the rocker.
TEST_F(DriveTest, AFourBarIsDrivenByItsMotor) {
  write("fourbar.urdf", four_bar());
  write("scene.yaml", kFourBarScene);
  const Outcome outcome =
      drive("fourbar.urdf scene.yaml", "start\njoint motor to 1.2 in 1 s\nwait\nwait 1 s\n",
            "--q 0.5,0.5,1 --record record.jsonl");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(test::read_file(root_ / "record.jsonl"));
  double widest = 0;
  std::vector<double> q;
  for (std::string line; std::getline(lines, line);) {
    const json entry = json::parse(line);
    if (entry["type"] != "state") continue;
    q = entry["q"].get<std::vector<double>>();
    const double x = 0.2 * std::cos(q[0]) + 0.4 * std::cos(q[0] + q[1]) - 0.3 * std::cos(q[2]);
    const double y = 0.2 * std::sin(q[0]) + 0.4 * std::sin(q[0] + q[1]) - 0.3 * std::sin(q[2]);
    widest = std::max(widest, std::hypot(x - 0.4, y));
    EXPECT_EQ(entry["tau"][1], 0.0);
    EXPECT_EQ(entry["tau"][2], 0.0);
  }
  EXPECT_LT(widest, 1e-5);  // of Runge-Kutta steps, led back
  ASSERT_EQ(q.size(), 3U);
  EXPECT_NEAR(q[0], 1.2, 1e-4);
}

TEST_F(DriveTest, SaysWhichLoopsItDoesNotDrive) {
  write("fourbar.urdf", four_bar());
  write("scene.yaml", kFourBarScene);
  EXPECT_NE(drive("fourbar.urdf scene.yaml", "start\njoint knee to 0\n", "--q 0.5,0.5,1")
                .err.find("no joint `knee`"),
            std::string::npos);
  std::string too_far = kFourBarScene;
  write("scene.yaml", too_far.replace(too_far.find("0.3"), 3, "9.0"));
  EXPECT_NE(drive("fourbar.urdf scene.yaml", "start\n").err.find("cannot be closed"),
            std::string::npos);
  write("scene.yaml", "base: floating\nconstraints: [{name: held, between: [base, world]}]\n");
  EXPECT_NE(drive("fourbar.urdf scene.yaml", "start\n").err.find("held to the world"),
            std::string::npos);
}

// How long cycles take is not asked; that all are counted is.
TEST_F(DriveTest, MeasuresItsTiming) {
  const Outcome outcome = run_drive("--latency --seconds 1 --load 1 --report timing");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("jitter"), std::string::npos);
  const json report = json::parse(test::read_file(root_ / "timing.json"));
  const auto cycles = report["cycles"].get<long>();
  EXPECT_GT(cycles, 0);
  for (const char* series : {"period_us", "jitter_us", "control_us"}) {
    long sum = 0;
    for (const json& count : report[series]["bins"]) sum += count.get<long>();
    EXPECT_EQ(sum, cycles) << series;
    EXPECT_LE(report[series]["median"], report[series]["largest"]) << series;
  }
  const std::string svg = test::read_file(root_ / "timing.svg");
  EXPECT_EQ(svg.rfind("<svg", 0), 0U);
  EXPECT_NE(svg.find("and more"), std::string::npos);
  EXPECT_NE(run_drive("--seconds 5").err.find("--latency"), std::string::npos);
}

}  // namespace
}  // namespace treeline
