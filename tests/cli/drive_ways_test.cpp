// Obstacles, rehearsals, records, robots that are not ideal, closed loops, timing.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "drive_fixture.hpp"

namespace treeline {
namespace {

using DriveWaysTest = DriveTest;

// The wrist of a PUMA 560 is sent past a ball that is in its way. By the interpreter it goes round,
// and never comes nearer than the clearance.
TEST_F(DriveWaysTest, ThePointGoesRoundAnObstacle) {
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
TEST_F(DriveWaysTest, RehearsesThenGoes) {
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

TEST_F(DriveWaysTest, RefusesARehearsalThatCannotBe) {
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
TEST_F(DriveWaysTest, FollowsARecord) {
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
TEST_F(DriveWaysTest, ARobotThatIsNotIdealArrivesLessExactly) {
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
  const std::string gears = "--backlash 0.002 --rotor joint1=0.5,joint2=0.3,joint3=0.1 ";
  EXPECT_LT(error_with(gears), 2e-2);
  EXPECT_LT(error_with(gears + "--gear-stiffness joint3=2000"), 2e-2);
}

TEST_F(DriveWaysTest, RefusesWhatIsNoFaultOfARobot) {
  write("script.txt", "start\n");
  const std::string run = "--headless --script script.txt ";
  EXPECT_NE(run_drive(run + "--friction joint9=1").err.find("no joint \"joint9\""),
            std::string::npos);
  EXPECT_NE(run_drive(run + "--backlash 0.01").err.find("--rotor joint1=INERTIA"),
            std::string::npos);
  EXPECT_NE(run_drive(run + "--backlash joint2=0.01 --rotor 1 --gear-stiffness joint2=0")
                .err.find("--gear-stiffness joint2=STIFFNESS"),
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
TEST_F(DriveWaysTest, AFourBarIsDrivenByItsMotor) {
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

TEST_F(DriveWaysTest, SaysWhichLoopsItDoesNotDrive) {
  write("fourbar.urdf", four_bar());
  write("scene.yaml", kFourBarScene);
  EXPECT_NE(drive("fourbar.urdf scene.yaml", "start\njoint knee to 0\n", "--q 0.5,0.5,1")
                .err.find("no joint `knee`"),
            std::string::npos);
  std::string too_far = kFourBarScene;
  write("scene.yaml", too_far.replace(too_far.find("0.3"), 3, "9.0"));
  EXPECT_NE(drive("fourbar.urdf scene.yaml", "start\n").err.find("cannot be closed"),
            std::string::npos);
  write("scene.yaml", "constraints: [{name: held, between: [base, world]}]\n");
  EXPECT_NE(drive("fourbar.urdf scene.yaml", "start\n").exit_code, 0);
}

// Would catch: a joint without a motor that is moved by one without a word.
TEST_F(DriveWaysTest, SaysThatPassiveJointsOfATreeAreMoved) {
  write("fourbar.urdf", four_bar());
  write("scene.yaml", "passive: [knee]\n");
  const Outcome outcome = drive("fourbar.urdf scene.yaml", "start\n");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("left out while the robot is driven: passive"), std::string::npos)
      << outcome.err;
}

/// The last state of a record, and the largest of what `measure` finds in one.
template <class Measure>
std::pair<json, double> look_through(const std::string& record, Measure&& measure) {
  std::istringstream lines(record);
  json last;
  double largest = 0;
  for (std::string line; std::getline(lines, line);) {
    json entry = json::parse(line);
    if (entry["type"] != "state") continue;
    largest = std::max(largest, measure(entry));
    last = std::move(entry);
  }
  return {last, largest};
}

// On a base that ideal forces hold, and on one that the world holds, the same motor does the same
// as on a fixed one: 1.2 rad, the loop closed by plane trigonometry. The weight is carried by the
// base's forces or by the constraint: then those of the base are 0. Would catch quaternions in the
// law of loops, a base without forces that falls, and forces of a base that has no motor.
TEST_F(DriveWaysTest, AFourBarOnAFloatingBaseIsDriven) {
  std::string urdf = four_bar();
  const std::string bare = "<link name='base'/>";
  urdf.replace(urdf.find(bare), bare.size(),
               "<link name='base'><inertial><mass value='2'/><inertia ixx='0.1' ixy='0' ixz='0' "
               "iyy='0.1' iyz='0' izz='0.1'/></inertial></link>");
  write("fourbar.urdf", urdf);
  for (const bool held : {false, true}) {
    write("scene.yaml", "base: floating\n" + kFourBarScene +
                            (held ? "  - {name: ground, between: [base, world]}\n" : ""));
    const Outcome outcome =
        drive("fourbar.urdf scene.yaml", "start\njoint motor to 1.2 in 1 s\nwait\nwait 1 s\n",
              "--q 0,0,0,0,0,0,1,0.5,0.5,1 --record record.jsonl");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto [last, widest] =
        look_through(test::read_file(root_ / "record.jsonl"), [](const json& entry) {
          const auto q = entry["q"].get<std::vector<double>>();
          const double x =
              0.2 * std::cos(q[7]) + 0.4 * std::cos(q[7] + q[8]) - 0.3 * std::cos(q[9]);
          const double y =
              0.2 * std::sin(q[7]) + 0.4 * std::sin(q[7] + q[8]) - 0.3 * std::sin(q[9]);
          return std::max(std::hypot(x - 0.4, y), std::hypot(q[0], q[1], q[2]));
        });
    EXPECT_LT(widest, 1e-5) << held;
    EXPECT_NEAR(last["q"][7].get<double>(), 1.2, 1e-4) << held;
    const double weight = (2.0 + 3.0) * 9.81;
    EXPECT_NEAR(last["tau"][1].get<double>(), held ? 0.0 : weight, 1e-3);
    if (held) {
      for (int i = 0; i < 6; ++i) EXPECT_EQ(last["tau"][static_cast<std::size_t>(i)], 0.0);
      EXPECT_NE(drive("fourbar.urdf scene.yaml", "start\nmove base by 0 0 0.1\n").exit_code, 0);
    }
  }
}

// A point of the coupler goes where it is told while the loop stays closed, by the motor alone.
TEST_F(DriveWaysTest, APointBeyondALoopIsDriven) {
  write("fourbar.urdf", four_bar());
  write("scene.yaml", kFourBarScene +
                          "operational_points: [{name: tip, link: coupler, origin: {xyz: [0.2, "
                          "0.1, 0]}, rows: [x]}]\n");
  const Outcome outcome =
      drive("fourbar.urdf scene.yaml", "start\nmove tip by -0.05 0 0 in 1 s\nwait\nwait 1 s\n",
            "--q 0.5,0.5,1 --record record.jsonl");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  double first = 0;
  const auto tip = [](const json& entry) {
    const auto q = entry["q"].get<std::vector<double>>();
    return 0.2 * std::cos(q[0]) + 0.2 * std::cos(q[0] + q[1]) - 0.1 * std::sin(q[0] + q[1]);
  };
  const auto [last, unpowered] =
      look_through(test::read_file(root_ / "record.jsonl"), [&](const json& entry) {
        first = first == 0 ? tip(entry) : first;
        return std::fabs(entry["tau"][1].get<double>()) + std::fabs(entry["tau"][2].get<double>());
      });
  EXPECT_EQ(unpowered, 0.0);
  EXPECT_NEAR(tip(last) - first, -0.05, 1e-6);
}

// The humanoid with its feet held to the world, its base without motors, moves a hand to where it
// does on a fixed base: the world's forces are those of the fixture. The joints differ, since with
// constraints the posture is held by accelerations, else by springs. Would catch a base that the
// law leans on, and constraints that give way.
TEST_F(DriveWaysTest, AStandingRobotMovesAsAFixedOne) {
  const std::string point =
      "operational_points: [{name: hand, link: left_hand, origin: {xyz: [0, 0, -0.086]}}]\n";
  const std::string feet =
      "base: floating\nconstraints:\n"
      "  - {name: left, between: [foot, world], origin: {xyz: [0.06, 0.09, 0]}, axes: local}\n"
      "  - {name: right, between: [foot, world], origin: {xyz: [0.06, -0.09, 0]}}\n";
  std::vector<json> ends;
  for (const std::string& scene : {point, point + feet}) {
    write("scene.yaml", scene);
    const Outcome outcome = drive(kRobots + "/humanoid24/humanoid24.urdf scene.yaml",
                                  "start\nmove hand by 0.03 0 0.03 in 1 s\nwait\nwait 1 s\n");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    ends.push_back(json::parse(outcome.out));
  }
  const auto standing = ends[1]["q"].get<std::vector<double>>();
  ASSERT_EQ(standing.size(), ends[0]["q"].size() + 7);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(standing[i], 0.0, 1e-9) << i;
    EXPECT_EQ(ends[1]["tau"][i], 0.0) << i;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto place = [&](const json& end, const char* which) {
      return end["points"][0][which][axis].get<double>();
    };
    EXPECT_NEAR(place(ends[1], "at"), place(ends[0], "at"), 1e-5) << axis;
    EXPECT_NEAR(place(ends[1], "at"), place(ends[1], "goal"), 1e-3) << axis;
  }
}

// How long cycles take is not asked; that all are counted is.
TEST_F(DriveWaysTest, MeasuresItsTiming) {
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
