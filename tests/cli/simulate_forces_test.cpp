// Would catch: springs that some joints do not have, or that cut dampers unasked; losses by
// friction, joint forces, stops and the ground that are told as the integrator's error; and what of
// a scene holds or loads a robot and is dropped without a word.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <vector>

#include "program_test.hpp"

namespace treeline {
namespace {

using test::Outcome;

constexpr double kMass = 0.1, kInertia = 0.001, kStiffness = 20, kSeconds = 0.05;

std::string inertial(const std::string& mass, const std::string& moment,
                     const std::string& center = "0 0 0") {
  return "<inertial><origin xyz=\"" + center + "\"/><mass value=\"" + mass + "\"/><inertia ixx=\"" +
         moment + "\" iyy=\"" + moment + "\" izz=\"" + moment +
         "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& more = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + more + "</joint>";
}

/// A body whose centre of mass is on its joint.
std::string one_joint(const std::string& type) {
  return "<robot name=\"one\"><link name=\"base\"/><link name=\"body\">" +
         inertial("0.1", "0.001") + "</link>" +
         joint("free", type, "base", "body", type == "planar" ? "<axis xyz=\"0 0 1\"/>" : "") +
         "</robot>";
}

/// A double pendulum that swings about y.
std::string pendulum(const std::string& more = "") {
  const std::string axis =
      "<axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\" effort=\"50\" "
      "velocity=\"10\"/>";
  return "<robot name=\"pendulum\"><link name=\"base\"/><link name=\"upper\">" +
         inertial("2", "0.1", "0 0 -0.5") + "</link><link name=\"lower\">" +
         inertial("1", "0.05", "0 0 -0.4") + "</link>" +
         joint("shoulder", "revolute", "base", "upper", "<origin xyz=\"0 0 2\"/>" + axis) +
         joint("elbow", "revolute", "upper", "lower", "<origin xyz=\"0 0 -1\"/>" + axis) + more +
         "</robot>";
}

class SimulateForces : public test::ProgramTest {
 protected:
  [[nodiscard]] nlohmann::json run_json(const std::string& arguments) const {
    const Outcome outcome = run("simulate " + arguments + " --json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }

  /// The last row of the table of a body on a joint, which starts at 0 with velocities.
  [[nodiscard]] std::vector<double> last_row(const std::string& type, const std::string& options) {
    write("one.urdf", one_joint(type));
    const Outcome outcome = run("simulate one.urdf --seconds 0.05 --step 0.01 --csv - " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string table = outcome.out.substr(0, outcome.out.size() - 1);
    std::istringstream cells(table.substr(table.rfind('\n') + 1));
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    return row;
  }
};

/// Where a spring has led what started with speed 1.
double swung(double inertia) {
  const double frequency = std::sqrt(kStiffness / inertia);
  return std::sin(frequency * kSeconds) / frequency;
}

const std::string kSprings = "--hold --stiffness 20 --integrator adaptive ";

TEST_F(SimulateForces, SpringsActAlongAndAboutAllAxesOfAPlane) {
  const auto row = last_row("planar", kSprings + "--qd 1,-1,1");
  EXPECT_NEAR(row[1], swung(kMass), 1e-8);
  EXPECT_NEAR(row[2], -swung(kMass), 1e-8);
  EXPECT_NEAR(row[3], swung(kInertia), 1e-8);
}

// The moment is along the rotation vector from the start, so that the axis stays.
TEST_F(SimulateForces, SpringsOfBallAndFloatingJointsTurnBack) {
  const auto ball = last_row("ball", kSprings + "--q 0.6,0,0,0.8 --qd 0,0.6,0.8");
  const double half = swung(kInertia) / 2;
  // (0.6, 0, 0, 0.8) times the quaternion of the turn by 2 half about (0, 0.6, 0.8)
  const std::array turn = {0.6 * std::sin(half), 0.8 * std::sin(half), std::cos(half)};
  EXPECT_NEAR(ball[1], 0.6 * turn[2], 1e-8);
  EXPECT_NEAR(ball[2], 0.8 * turn[0] - 0.6 * turn[1], 1e-8);
  EXPECT_NEAR(ball[3], 0.8 * turn[1] + 0.6 * turn[0], 1e-8);
  EXPECT_NEAR(ball[4], 0.8 * turn[2], 1e-8);
  const auto floating = last_row("floating", kSprings + "--qd 1,0,-1,0,0,1");
  EXPECT_NEAR(floating[1], swung(kMass), 1e-8);
  EXPECT_NEAR(floating[3], -swung(kMass), 1e-8);
  EXPECT_NEAR(floating[6], std::sin(half), 1e-8);
}

// I a + 0.7 w + 20 x = 0 is overdamped: x = (e^(r t) - e^(s t)) / (r - s).
TEST_F(SimulateForces, SpringsLeaveDampersAsTheyAre) {
  const auto yaw = last_row("planar", kSprings + "--damping 0.7 --qd 0,0,1")[3];
  const double root = std::sqrt(0.7 * 0.7 - 4 * kInertia * kStiffness);
  const double slow = (-0.7 + root) / (2 * kInertia), fast = (-0.7 - root) / (2 * kInertia);
  EXPECT_NEAR(yaw, (std::exp(slow * kSeconds) - std::exp(fast * kSeconds)) / (slow - fast), 1e-9);
}

TEST_F(SimulateForces, NamesJointsThatAreTooLightForTheStep) {
  write("one.urdf", one_joint("planar"));
  const std::string weak = "simulate one.urdf --stiffness 20 --seconds 0.05 --step ";
  const Outcome coarse = run(weak + "0.01");
  EXPECT_NE(coarse.err.find("weaker springs or dampers: free"), std::string::npos) << coarse.err;
  EXPECT_EQ(run(weak + "0.001").err.find("weaker springs"), std::string::npos);
}

// Work is counted to the order of the integrator: what is left is its error, which halves with the
// step by its order.
TEST_F(SimulateForces, WhatIsLeftOfTheEnergyIsTheIntegratorsError) {
  write("pendulum.urdf", pendulum());
  write("rubbing.yaml",
        "joint_friction: {model: viscous, joints: {shoulder: {damping: 0.5}, "
        "elbow: {damping: 0.1}}}\n");
  const std::string start = "pendulum.urdf rubbing.yaml --q 0.5,0.1 --seconds 1 ";
  for (const std::string options : {"", "--damping 0.3 --stiffness 5", "--hold"}) {
    const auto at = [&](const std::string& how) {
      return run_json(start + options + how + (options == "--hold" ? " --qd 1,-1" : ""));
    };
    const auto exact = at(" --integrator adaptive --tolerance 1e-12");
    EXPECT_GT(std::abs(exact.at("joint_work").get<double>()), 0.1) << options;
    EXPECT_LT(std::abs(exact.at("integrator_error").get<double>()), 1e-9) << options;
    const auto error = [&](const std::string& step) {
      return at(" --integrator rk4 --step " + step).at("integrator_error").get<double>();
    };
    EXPECT_NEAR(error("0.02") / error("0.01"), 16, 5) << options;
  }
  const Outcome told = run("simulate " + start);
  EXPECT_NE(told.out.find("J: joint forces and friction -"), std::string::npos) << told.out;
  EXPECT_NE(told.out.find("the integrator's error"), std::string::npos) << told.out;
}

TEST_F(SimulateForces, StopsAndGroundTakeEnergyTheIntegratorDoesNot) {
  write("pendulum.urdf", pendulum());
  const auto stopped = run_json("pendulum.urdf --stops --q 0.9,0.5 --qd 0,3 --seconds 0.5");
  EXPECT_LT(stopped.at("contact_energy").get<double>(), -0.1);
  EXPECT_EQ(stopped.at("joint_work").get<double>(), 0);
  EXPECT_LT(std::abs(stopped.at("integrator_error").get<double>()), 1e-8);
  write("box.urdf", "<robot name=\"box\"><link name=\"box\">" + inertial("2", "0.01") +
                        "<collision><geometry><box size=\"0.4 0.3 0.2\"/></geometry></collision>"
                        "</link></robot>");
  write("loose.yaml", "base: floating\nground: {friction: 0.3}\n");
  const auto slid = run_json("box.urdf loose.yaml --seconds 1 --qd 1,0,0,0,0,0");
  EXPECT_NEAR(slid.at("contact_energy").get<double>(), -1, 1e-6);  // 2 kg at 1 m/s
  EXPECT_LT(std::abs(slid.at("integrator_error").get<double>()), 1e-9);
}

TEST_F(SimulateForces, RefuseWhatIsNotHeldThroughTime) {
  write("pendulum.urdf", pendulum());
  write("looped.urdf", pendulum("<loop_joint name=\"closing\" type=\"spherical\"><link1 "
                                "link=\"lower\"/><link2 link=\"base\"/></loop_joint>"));
  const std::string hand = "operational_points: [{name: hand, link: lower}]\n";
  const std::pair<std::string, std::string> held[] = {
      {"couplings: [{name: belt, joints: {shoulder: 1, elbow: -1}}]", "couplings[belt]: "},
      {"constraints: [{name: foot, between: [lower, world], rows: [x]}, {name: bar, between: "
       "[lower, base], rows: [x]}]",
       "constraints[foot, bar]: "},
      {hand + "objects: [{name: box, mass: 4, inertia: {ixx: 0.1, iyy: 0.1, izz: 0.1}, grasps: "
              "[{point: hand}]}]",
       "objects[box]: "}};
  for (const auto& [text, named] : held) {
    write("scene.yaml", text + "\n");
    const Outcome outcome = run("simulate pendulum.urdf scene.yaml --seconds 0.1");
    EXPECT_EQ(outcome.exit_code, 1) << text;
    EXPECT_NE(outcome.err.find("scene.yaml: error: " + named), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("leave it out"), std::string::npos) << outcome.err;
  }
  const Outcome looped = run("simulate looped.urdf --seconds 0.1");
  EXPECT_EQ(looped.exit_code, 1);
  EXPECT_NE(looped.err.find("looped.urdf: error: loop_joint[closing]: "), std::string::npos)
      << looped.err;
}

TEST_F(SimulateForces, NoteWhatOfASceneHasNoPartInIt) {
  write("pendulum.urdf", pendulum());
  write("scene.yaml",
        "operational_points: [{name: tip, link: lower, rows: [x]}]\n"
        "passive: [elbow]\ntorque_limits: urdf\n"
        "obstacles: [{name: post, sphere: {radius: 0.1}, origin: {xyz: [1, 0, 1]}}]\n");
  const Outcome held = run("simulate pendulum.urdf scene.yaml --seconds 0.1 --hold");
  EXPECT_EQ(held.exit_code, 0) << held.err;
  for (const char* key : {"note: passive: ", "note: torque_limits: ", "note: obstacles: "}) {
    EXPECT_NE(held.err.find(key), std::string::npos) << key << held.err;
  }
  const Outcome free = run("simulate pendulum.urdf scene.yaml --seconds 0.1");
  EXPECT_EQ(free.err.find("passive"), std::string::npos) << free.err;
}

}  // namespace
}  // namespace treeline
