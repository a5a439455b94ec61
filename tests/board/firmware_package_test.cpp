// `treeline generate --package firmware`, compiled by its makefile and run in QEMU as its README
// says. Would catch: files that do not compile, an arm that never moves, a watchdog that is kicked
// by a late step or bites without one, frames that lose a sign, and scenes that it cannot be made
// of.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

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
  const std::regex away("1e-6 away from its goal: (-?[0-9]+)\n");
  int joints = 0;
  for (std::sregex_iterator at(log.begin(), log.end(), away); at != std::sregex_iterator(); ++at) {
    EXPECT_LT(std::abs(std::stoi((*at)[1])), 5000) << log;  // it is led over 200000
    ++joints;
  }
  EXPECT_EQ(joints, 6);

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

TEST_F(FirmwarePackage, TellsWhatItCannotBeMadeOf) {
  const std::pair<std::string, std::string> scenes[] = {
      {"real: float\nfunctions: [forward_dynamics]\n", "there is none"},
      {"functions: [gravity]\ncontroller: {laws: [joint_impedance]}\n", "forward_dynamics"}};
  for (const auto& [scene, fault] : scenes) {
    const Outcome outcome = generate_package(scene, "--target cortex-m7");
    EXPECT_EQ(outcome.exit_code, 1) << scene;
    EXPECT_NE(outcome.err.find(fault), std::string::npos) << outcome.err;
  }
  const Outcome outcome = generate_package(kScene, "--target rv32imfc");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("Cortex-M"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace treeline::tests
