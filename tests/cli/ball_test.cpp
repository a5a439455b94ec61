#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "program_test.hpp"

// A robot with ball joints goes through every subcommand as any other. Would catch: coordinates
// that are counted or drawn as if there were one per freedom, a quaternion that starts as zero, and
// one that does not stay a unit one.

namespace treeline {
namespace {

const std::string kRobots = TREELINE_ROBOTS;
const std::string kHumanoid = kRobots + "/../tests/data/written/ball_humanoid.urdf";

class BallProgram : public test::ProgramTest {
 protected:
  [[nodiscard]] nlohmann::json run_json(const std::string& arguments) const {
    const auto outcome = run(arguments + " --json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
};

TEST_F(BallProgram, IsInspected) {
  const auto json = run_json("inspect " + kHumanoid);
  EXPECT_EQ(json.at("coordinates"), 4 * 4 + 7);
  EXPECT_EQ(json.at("velocities"), 4 * 3 + 7);
  EXPECT_EQ(json.at("joints").at(1).at("type"), "ball");
}

TEST_F(BallProgram, IsTheSameAsItself) {
  EXPECT_EQ(run("diff " + kHumanoid + " " + kHumanoid).exit_code, 0);
}

TEST_F(BallProgram, KeepsItsEnergyAndItsQuaternions) {
  const auto json = run_json("simulate " + kHumanoid + " --seconds 0.3 --integrator adaptive");
  EXPECT_LT(json.at("largest_change").get<double>(), 1e-9 * 47 * 9.81);
  EXPECT_LT(json.at("quaternion_error").get<double>(), 1e-14);
}

TEST_F(BallProgram, HasAProposedSceneThatIsGenerated) {
  const auto proposed = run("init-scene " + kHumanoid);
  ASSERT_EQ(proposed.exit_code, 0) << proposed.err;
  std::ofstream(root_ / "scene.yaml") << proposed.out;
  const auto outcome = run("generate " + kHumanoid + " scene.yaml --output code");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string header = test::read_file(root_ / "code" / "ball_humanoid.hpp");
  EXPECT_NE(header.find("left_hip (ball)"), std::string::npos);
  EXPECT_NE(header.find("Of a ball joint q is a quaternion"), std::string::npos);
  for (std::size_t at = 0; at < header.size();) {
    const std::size_t end = header.find('\n', at);
    EXPECT_LE(end - at, 100U) << header.substr(at, end - at);
    at = end + 1;
  }
}

TEST_F(BallProgram, CannotBeLocked) {
  std::ofstream(root_ / "scene.yaml") << "locked: {left_hip: 0.3}\n";
  const auto outcome = run("generate " + kHumanoid + " scene.yaml --output code");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("one degree of freedom"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace treeline
