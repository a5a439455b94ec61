// `treeline check --target` as a shell runs it. Would catch: a missing compiler or simulator that
// is told without the package that holds it, exit codes that hide a failure, and programs or files
// that survive a signal.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "check/fixture.hpp"
#include "cli/run_program.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;
using test::Outcome;

const std::string kFiles =
    TREELINE_ROBOTS_DIR "/planar3r/planar3r.urdf " TREELINE_ROBOTS_DIR "/planar3r/scene.yaml";

class BoardCommand : public testing::Test {
 protected:
  Outcome run(const std::string& options) {
    return test::run_program(folder_.path(),
                             "check " + kFiles + " --functions jacobian " + options);
  }

  /// Writes an executable script to a folder that stands for PATH.
  void write_program(const std::string& name, const std::string& script) {
    fs::create_directories(folder_.path() / "bin");
    write_file(folder_.path() / "bin" / name, "#!/bin/sh\n" + script);
    fs::permissions(folder_.path() / "bin" / name, fs::perms::owner_all);
  }

  /// Runs with that folder as the only one in PATH.
  Outcome run_in_path(const std::string& options) {
    const std::string command = "cd '" + folder_.path().string() + "' && PATH='" +
                                (folder_.path() / "bin").string() +
                                "' '" TREELINE_PROGRAM "' check " + kFiles +
                                " --functions jacobian " + options + " >stdout.txt 2>stderr.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder_.path() / "stdout.txt"),
            read_file(folder_.path() / "stderr.txt")};
  }

  TemporaryFolder folder_;
};

TEST_F(BoardCommand, PrintsATable) {
  const Outcome outcome = run("--real float --target cortex-m4f --states 20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("passed: 1 functions equal to the host's to the bit, the same number "
                             "of instructions in every state"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("-mcpu=cortex-m4"), std::string::npos) << outcome.out;
}

TEST_F(BoardCommand, PrintsJson) {
  const Outcome outcome = run("--real float --target rv32imfc --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json.at("passed"));
  EXPECT_EQ(json.at("target"), "rv32imfc");
  EXPECT_EQ(json.at("states"), 300);
  const auto& function = json.at("functions")[0];
  EXPECT_EQ(function.at("name"), "jacobian");
  EXPECT_TRUE(function.at("constant_time"));
  EXPECT_EQ(function.at("undefined").size(), 0U);
  for (const char* key : {"text_bytes", "stack_bytes", "least_instructions", "cycles_estimate"}) {
    EXPECT_GT(function.at(key), 0) << key;
  }
}

TEST_F(BoardCommand, WarnsOfEmulation) {
  const Outcome outcome = run("--real double --target cortex-m4f --states 20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("cortex-m4f has no instructions for double"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("write real: float"), std::string::npos) << outcome.err;
}

TEST_F(BoardCommand, NamesMissingPackages) {
  const std::string gives_version = "echo 12.2\n";
  Outcome outcome = run_in_path("--target cortex-m7");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("apt-get install gcc-arm-none-eabi"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("apt-get install qemu-system-arm"), std::string::npos) << outcome.err;
  write_program("riscv64-unknown-elf-g++", gives_version);
  outcome = run_in_path("--target rv64gc");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err.find("gcc-riscv64-unknown-elf"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("apt-get install qemu-system-misc"), std::string::npos) << outcome.err;
}

TEST_F(BoardCommand, BadUsageIsTwo) {
  const Outcome outcome = run("--target cortex-m8");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("cortex-m7"), std::string::npos) << outcome.err;
}

TEST_F(BoardCommand, RefusesFastMath) {
  const Outcome outcome = run("--target cortex-m7 --flags '-O2 -ffast-math'");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("-ffast-math"), std::string::npos) << outcome.err;
}

// Would catch: a simulator, or a folder of its files, that outlives Ctrl-C.
TEST_F(BoardCommand, LeavesNothingBehindOnASignal) {
  write_program("qemu-system-arm", "[ \"$1\" = --version ] && { echo 7; exit 0; }\necho $$ >'" +
                                       (folder_.path() / "new").string() + "'\nmv '" +
                                       (folder_.path() / "new").string() + "' '" +
                                       (folder_.path() / "pid").string() + "'\nexec sleep 1000\n");
  const fs::path temporary = folder_.path() / "tmp";
  fs::create_directories(temporary);
  const pid_t program = fork();
  if (program == 0) {
    const std::string path = (folder_.path() / "bin").string() + ":" + std::getenv("PATH");
    setenv("PATH", path.c_str(), 1);
    setenv("TMPDIR", temporary.c_str(), 1);
    const std::string command = "exec '" TREELINE_PROGRAM "' check " + kFiles +
                                " --functions jacobian --target cortex-m7 --states 20 2>/dev/null";
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  for (int i = 0; i < 6000 && !fs::exists(folder_.path() / "pid"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(fs::exists(folder_.path() / "pid"));
  EXPECT_FALSE(fs::is_empty(temporary));
  kill(program, SIGTERM);
  int status = 0;
  waitpid(program, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
  EXPECT_TRUE(fs::is_empty(temporary));
  pid_t simulator = 0;
  std::ifstream(folder_.path() / "pid") >> simulator;
  ASSERT_GT(simulator, 0);
  const std::string state = read_file("/proc/" + std::to_string(simulator) + "/stat");
  EXPECT_TRUE(state.empty() || state.find(") Z ") != std::string::npos) << state;
}

}  // namespace
}  // namespace treeline::tests
