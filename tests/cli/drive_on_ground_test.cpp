// Robots that stand on a ground while they are driven.
#include <array>
#include <cmath>

#include "drive_fixture.hpp"

namespace treeline {
namespace {

using DriveOnGround = DriveTest;

/// A humanoid on a ground, with a hand to move.
const char* const kOnGround =
    "base: floating\nground: {friction: 0.8}\n"
    "operational_points: [{name: hand, link: left_hand, origin: {xyz: [0, 0, -0.086]}}]\n"
    "constraints: [{name: feet, between: [foot, world]}]\n";

// On a ground that only pushes a humanoid stands, by its motors alone, and moves a hand. At rest
// they bear what a robot with fixed feet bears, by the interpreter. Would catch feet that slip or
// tip, a base that something holds, and a start from which it falls.
TEST_F(DriveOnGround, AHumanoidStandsOnAGround) {
  const std::string urdf = kRobots + "/humanoid24/humanoid24.urdf";
  write("scene.yaml", kOnGround);
  const Outcome outcome =
      drive(urdf + " scene.yaml", "start\nmove hand by 0.05 0 0.05 in 1 s\nwait\nwait 2 s\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json end = json::parse(outcome.out);
  const auto q = end["q"].get<std::vector<double>>();
  const auto tau = end["tau"].get<std::vector<double>>();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(q[i], 0.0, 1e-4) << i;  // m, half a rad
    EXPECT_EQ(tau[i], 0.0) << i;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(end["points"][0]["at"][axis].get<double>(),
                end["points"][0]["goal"][axis].get<double>(), 1e-3);
  }
  Diagnostics diagnostics;
  const auto robot = read_urdf(urdf, diagnostics);
  const auto scene = parse_scene("base: fixed\n", "fixed", *robot, diagnostics);
  const auto model = model_from_robot<double>(*robot, *scene);
  const interpreter::Vector<double> joints =
      interpreter::Vector<double>::Map(q.data() + 7, model.nq);
  const interpreter::Vector<double> none = interpreter::Vector<double>::Zero(model.nv);
  const auto weight = interpreter::inverse_dynamics<double>(model, joints, none, none);
  for (Eigen::Index i = 0; i < model.nv; ++i) {
    EXPECT_NEAR(tau[static_cast<std::size_t>(6 + i)], weight[i], 0.02 * weight.norm()) << i;
  }
}

// At rest the ground carries the weight, below the centre of mass, and pushes nowhere else. Would
// catch forces that are those of one step in another unit, left out, or drawn elsewhere. What still
// moves after two seconds takes a thousandth.
TEST_F(DriveOnGround, TheGroundCarriesTheWeight) {
  const std::string urdf = kRobots + "/humanoid24/humanoid24.urdf";
  write("scene.yaml", kOnGround);
  const Outcome outcome = drive(urdf + " scene.yaml", "start\nwait 2 s\n");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  Diagnostics diagnostics;
  const auto robot = read_urdf(urdf, diagnostics);
  double weight = 0;
  for (const Link& link : robot->links) {
    weight += 9.81 * (link.inertial ? link.inertial->mass : 0);
  }
  const json end = json::parse(outcome.out);
  std::array<double, 3> force{};
  std::array<double, 2> pressed{};
  for (const json& each : end["forces"]) {
    EXPECT_EQ(each["of"], "ground");
    EXPECT_NEAR(each["at"][2].get<double>(), 0, 1e-3);  // a step flies so deep, by far
    for (std::size_t i = 0; i < 3; ++i) force[i] += each["force"][i].get<double>();
    for (std::size_t i = 0; i < 2; ++i) {
      pressed[i] += each["force"][2].get<double>() * each["at"][i].get<double>();
    }
  }
  EXPECT_NEAR(force[0], 0, 1e-3 * weight);
  EXPECT_NEAR(force[1], 0, 1e-3 * weight);
  EXPECT_NEAR(force[2], weight, 1e-3 * weight);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(pressed[i] / force[2], end["center_of_mass"][i].get<double>(), 1e-3);
  }
}

// A hand pulls a quadruped over: it yields, tips and lies, its motors drag, and that is said.
// Would catch a pull that motors exert and the ground does not feel, and a fall that nobody
// notices.
TEST_F(DriveOnGround, AQuadrupedIsPulledOver) {
  write("scene.yaml",
        "base: floating\nground: {friction: 0.8}\nsnap_angles: 1e-9\nconstraints:\n"
        "  - {name: a, between: [LF_FOOT, world], contact: point}\n"
        "  - {name: b, between: [RF_FOOT, world], contact: point}\n"
        "  - {name: c, between: [LH_FOOT, world], contact: point}\n"
        "  - {name: d, between: [RH_FOOT, world], contact: point}\n");
  const std::string urdf = kRobots + "/../tests/data/golden/anymal.urdf";
  std::string script = "start\nwait 0.3 s\n";
  for (int i = 0; i < 12; ++i) script += "pull base at 0 0 0 to 0 3 0.5\nwait 0.1 s\n";
  const Outcome fallen = drive(urdf + " scene.yaml", script + "wait 1 s\n");
  ASSERT_EQ(fallen.exit_code, 3) << fallen.err;
  EXPECT_NE(fallen.err.find("the robot has fallen"), std::string::npos) << fallen.err;
  const json lies = json::parse(fallen.out);
  EXPECT_LT(lies["q"][2].get<double>(), 0.3);
  for (const json& tau : lies["tau"]) EXPECT_LT(std::fabs(tau.get<double>()), 1.0);
}

// Would catch a scene that is compiled for minutes before it is refused.
TEST_F(DriveOnGround, ToldWhatAGroundDoesNotHave) {
  const std::string urdf = kRobots + "/humanoid24/humanoid24.urdf";
  write("scene.yaml", "base: floating\n");
  EXPECT_NE(drive(urdf + " scene.yaml", "start\n", "--ground").err.find("list its feet"),
            std::string::npos);
  write("scene.yaml", kOnGround);
  EXPECT_NE(drive(urdf + " scene.yaml", "start\n", "--backlash ankle=0.01 --rotor ankle=0.1")
                .err.find("gears have no play"),
            std::string::npos);
}

}  // namespace
}  // namespace treeline
