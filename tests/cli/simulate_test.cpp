#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "program_test.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;

const std::string kRobots = TREELINE_ROBOTS;
const std::string kPlanar = kRobots + "/planar3r/planar3r.urdf";

class SimulateTest : public test::OwnFolder {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return test::run_program(root_, "simulate " + arguments);
  }
  [[nodiscard]] nlohmann::json run_json(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
};

// Would catch: an integrator of another order than its name says, or two names for one integrator.
// The error of the energy is O(dt) with the first, O(dt^4) with the second, and the tolerance with
// the third.
TEST_F(SimulateTest, IntegratorsKeepEnergyAsWellAsTheirOrderSays) {
  const std::string robot = kRobots + "/puma560/puma560.urdf --seconds 0.5 ";
  const auto change = [&](const std::string& options) {
    return run_json(robot + options).at("largest_change").get<double>();
  };
  const auto gain = [&](const std::string& integrator) {
    return change("--step 0.004 " + integrator) / change("--step 0.002 " + integrator);
  };
  EXPECT_NEAR(gain("--integrator euler"), 2, 0.4);
  EXPECT_NEAR(gain("--integrator rk4"), 16, 5);
  const double start = 285.9;  // J
  EXPECT_LT(change("--step 0.01 --integrator adaptive --tolerance 1e-12"), 1e-9 * start);
}

// A floating base rotates freely. Would catch: quaternions that lose their length.
TEST_F(SimulateTest, QuaternionsStayUnit) {
  const auto json = run_json(kRobots + "/tumbler/tumbler.urdf " + kRobots +
                             "/tumbler/scene.yaml --seconds 0.3 --integrator euler");
  EXPECT_LT(json.at("quaternion_error").get<double>(), 1e-14);
  EXPECT_EQ(json.at("rows"), 301);
}

TEST_F(SimulateTest, WritesTheTableAndThePlot) {
  const Outcome outcome = run(kPlanar + " --q 0,1,0 --seconds 0.01 --csv - --svg swing.svg");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("time_s,q0,q1,q2,qd0,qd1,qd2,energy_J\n0,0,1,0,0,0,0,", 0), 0U)
      << outcome.out;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 12);
  EXPECT_NE(test::read_file(root_ / "swing.svg").find("</svg>"), std::string::npos);
}

// Would catch: a meaningless motion that is accepted.
TEST_F(SimulateTest, SaysWhatWentWrong) {
  const Outcome wrong_size = run(kPlanar + " --q 0,1");
  EXPECT_EQ(wrong_size.exit_code, 1);
  EXPECT_NE(wrong_size.err.find("2 numbers are given, the robot has 3"), std::string::npos);
  EXPECT_EQ(run(kPlanar + " --integrator leapfrog").exit_code, 2);
  const Outcome too_long = run(kPlanar + " --seconds 1e6 --step 1e-9");
  EXPECT_EQ(too_long.exit_code, 1) << too_long.err;
  EXPECT_NE(too_long.err.find("1e+15 rows of 8 numbers"), std::string::npos) << too_long.err;
  const Outcome one_step = run(kPlanar + " --seconds 1 --step 2");
  EXPECT_EQ(one_step.exit_code, 1) << one_step.err;
  EXPECT_NE(one_step.err.find("longer than the motion of 1 s"), std::string::npos) << one_step.err;
  const Outcome blown_up = run(kRobots + "/puma560/puma560.urdf --step 0.5 --integrator euler");
  EXPECT_EQ(blown_up.exit_code, 3) << blown_up.out;
  EXPECT_NE(blown_up.out.find("GIVEN UP"), std::string::npos);
}

// Would catch: an option whose file is forgotten, so that it takes the robot or the scene behind it
// to write over, and results that are lost at the end of a motion that would take hours.
TEST_F(SimulateTest, RefusesFilesThatItWouldNotWriteBeforeItRuns) {
  for (const char* option : {"simulate --csv", "simulate --svg", "draw -o", "bench --svg",
                             "drive --record", "generate --depfile"}) {
    for (const char* file : {"robot.urdf", "scene.yaml"}) {
      const Outcome outcome =
          test::run_program(root_, std::string(option) + " " + file + " " + kPlanar);
      EXPECT_EQ(outcome.exit_code, 2) << option;
      EXPECT_NE(outcome.err.find("is the name of a robot or a scene"), std::string::npos)
          << option << outcome.err;
    }
  }
  const std::string endless = " --seconds 1e6 --step 1e-5 --csv ";
  const Outcome nowhere = run(kPlanar + endless + "nowhere/table.csv");
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_NE(nowhere.err.find("cannot be written"), std::string::npos) << nowhere.err;
  fs::copy_file(kPlanar, root_ / "planar");
  const Outcome itself = run("planar" + endless + "planar");
  EXPECT_EQ(itself.exit_code, 1);
  EXPECT_NE(itself.err.find("is read, and is not written over"), std::string::npos) << itself.err;
}

}  // namespace
}  // namespace treeline
