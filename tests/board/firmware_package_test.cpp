// `treeline generate --package firmware`, compiled by its makefile and run in QEMU as its README
// says. Would catch: files that do not compile, an arm that never moves, a watchdog that is kicked
// by a late step or bites without one, frames that lose a sign, and scenes that it cannot be made
// of.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "check/fixture.hpp"
#include "cli/run_program.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;
using test::Outcome;

const std::string kPuma = TREELINE_ROBOTS_DIR "/puma560/puma560.urdf ";

class FirmwarePackage : public testing::Test {
 protected:
  Outcome generate_package(const std::string& scene, const std::string& options) {
    write_file(folder_.path() / "scene.yaml", scene);
    return test::run_program(
        folder_.path(),
        "generate " + kPuma + "scene.yaml --package firmware " + options + " --output firmware");
  }

  /// How far the joints are from their goals at the end, 1e-6 rad.
  static std::vector<int> read_distances(const std::string& log) {
    const std::regex away("1e-6 away from its goal: (-?[0-9]+)\n");
    std::vector<int> distances;
    for (std::sregex_iterator at(log.begin(), log.end(), away), end; at != end; ++at) {
      distances.push_back(std::abs(std::stoi((*at)[1])));
    }
    return distances;
  }

  /// What `make run` prints.
  std::string run() {
    const fs::path log = folder_.path() / "log.txt";
    const std::string command = "cd '" + (folder_.path() / "firmware").string() +
                                "' && timeout 300 make --silent run >'" + log.string() + "' 2>&1";
    (void)std::system(command.c_str());
    return read_file(log);
  }

  void change(const std::string& file, const std::string& from, const std::string& to) {
    const fs::path path = folder_.path() / "firmware" / file;
    std::string text = read_file(path);
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_file(path, text.replace(at, from.size(), to));
  }

  TemporaryFolder folder_;
};

const std::string kScene =
    "name: arm\nreal: float\nfunctions: [forward_dynamics]\nselftest: 1\n"
    "controller: {laws: [joint_impedance]}\n";

TEST_F(FirmwarePackage, MovesAnArmInTime) {
  const Outcome made = generate_package(kScene, "--target cortex-m4f --warnings none");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string log = run();
  EXPECT_NE(log.find("mode: 1\nfaults: 0\n"), std::string::npos) << log;
  EXPECT_NE(log.find("steps: 1200\nof them in time: 1200\ndone\n"), std::string::npos) << log;
  const std::vector<int> distances = read_distances(log);
  EXPECT_EQ(distances.size(), 6U);
  for (const int distance : distances) EXPECT_LT(distance, 5000) << log;  // it is led over 200000

  // A self-test that fails lets nothing begin; a step that takes too long lets the watchdog bite.
  change("main.c", "arm_selftest() != 0", "arm_selftest() == 0");
  EXPECT_EQ(run().find("main has ended\n"), 0U);
  change("main.c", "arm_selftest() == 0", "arm_selftest() != 0");
  change("main.c", "  take_measurements();\n  arm_fetch",
         "  for (volatile int i = 0; i < 1000000; ++i) {}\n  take_measurements();\n  arm_fetch");
  const std::string late = run();
  EXPECT_NE(late.find("reset by the watchdog\n"), std::string::npos) << late;
  EXPECT_EQ(late.find("done"), std::string::npos) << late;
}

// Would catch: of two commands in one millisecond the first lost, a stop at that, and a motion to
// where a joint's goal was left at, since the frame of its goal did not come.
TEST_F(FirmwarePackage, LosesNoCommandAndMovesToNoGoalThatDidNotCome) {
  const Outcome made = generate_package(kScene, "--target cortex-m4f --warnings none");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  change("port_qemu.c", "leave_command(ARM_STOP, 0);",
         "leave_command(ARM_STOP, 0), leave_command(ARM_KEEP_ALIVE, 0);");
  const std::string stopped = run();
  EXPECT_NE(stopped.find("mode: 1\nfaults: 0\nmode: 0\n"), std::string::npos) << stopped;

  change("port_qemu.c", "for (uint32_t i = 0; i < ARM_JOINTS; ++i) leave_goal",
         "for (uint32_t i = 1; i < ARM_JOINTS; ++i) leave_goal");
  const std::string lacking = run();
  EXPECT_NE(lacking.find("steps: 1200\n"), std::string::npos) << lacking;
  for (const int distance : read_distances(lacking)) EXPECT_GT(distance, 100000) << lacking;
}

TEST_F(FirmwarePackage, TellsWhatItCannotBeMadeOf) {
  const std::pair<std::string, std::string> scenes[] = {
      {"real: float\nfunctions: [forward_dynamics]\n", "there is none"},
      {"functions: [gravity]\ncontroller: {laws: [joint_impedance]}\n", "forward_dynamics"}};
  for (const auto& [scene, fault] : scenes) {
    const Outcome outcome = generate_package(scene, "--target cortex-m7");
    EXPECT_EQ(outcome.exit_code, 1) << scene;
    EXPECT_NE(outcome.err.find(fault), std::string::npos) << outcome.err;
  }
  // Would catch: goals of joints in frames with the identifier of the status.
  std::string joints = "<robot name=\"snake\"><link name=\"l0\"/>";
  for (int i = 0; i < 113; ++i) {
    joints += fmt::format(
        "<link name=\"l{1}\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" "
        "izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link><joint name=\"j{1}\" "
        "type=\"continuous\"><parent link=\"l{0}\"/><child link=\"l{1}\"/><limit effort=\"9\" "
        "velocity=\"9\"/></joint>",
        i, i + 1);
  }
  write_file(folder_.path() / "snake.urdf", joints + "</robot>");
  write_file(folder_.path() / "scene.yaml", kScene);
  const Outcome many = test::run_program(
      folder_.path(), "generate snake.urdf scene.yaml --package firmware --target cortex-m7");
  EXPECT_EQ(many.exit_code, 1);
  EXPECT_NE(many.err.find("identifiers for 112 joints"), std::string::npos) << many.err;
  const Outcome outcome = generate_package(kScene, "--target rv32imfc");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("Cortex-M"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace treeline::tests
