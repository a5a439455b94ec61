// `treeline check --runner`: a command in place of QEMU, which is QEMU here too. Would catch: a
// second way in which results come from boards, options that are not taken, faults of a board or of
// the line to it that are told as differences of bits, cycles that are made up.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "check/fixture.hpp"
#include "cli/run_program.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;
using test::Outcome;

const std::string kPlanar =
    TREELINE_ROBOTS_DIR "/planar3r/planar3r.urdf " TREELINE_ROBOTS_DIR "/planar3r/scene.yaml";
const std::string kArm =
    "qemu-system-arm -M mps2-an386 -icount shift=0 -display none -monitor none ";
const std::string kSemihosting =
    "-chardev stdio,id=host -semihosting-config enable=on,target=native,chardev=host ";

class Runner : public testing::Test {
 protected:
  /// Checks a function of a small robot with that script as the board.
  Outcome check(const std::string& target, const std::string& script,
                const std::string& options = "") {
    const fs::path runner = folder_.path() / "runner";
    write_file(runner, "#!/bin/sh\n" + script + "\n");
    fs::permissions(runner, fs::perms::owner_all);
    return test::run_program(folder_.path(), "check " + kPlanar +
                                                 " --functions jacobian --real float --states 5 "
                                                 "--target " +
                                                 target + " --runner ./runner " + options);
  }

  TemporaryFolder folder_;
};

TEST_F(Runner, GivesWhatQemuGives) {
  const Outcome own =
      check("cortex-m4f", "exec " + kArm + kSemihosting + "-kernel \"$1\"", "--json");
  ASSERT_EQ(own.exit_code, 0) << own.err;
  const Outcome built_in =
      test::run_program(folder_.path(), "check " + kPlanar +
                                            " --functions jacobian --real float --states 5 "
                                            "--target cortex-m4f --json");
  ASSERT_EQ(built_in.exit_code, 0) << built_in.err;
  const auto a = nlohmann::json::parse(own.out), b = nlohmann::json::parse(built_in.out);
  EXPECT_EQ(a.at("functions"), b.at("functions"));
  EXPECT_EQ(a.at("simulator"), "./runner");
  EXPECT_FALSE(a.at("counts_cycles"));  // QEMU has no DWT
}

// The RISC-V counter counts there, as one instruction a cycle.
TEST_F(Runner, ReportsCyclesOfTheProcessor) {
  const Outcome outcome =
      check("rv32imfc",
            "exec qemu-system-riscv32 -M virt -bios none -icount shift=0 -display none -monitor "
            "none -serial none " +
                kSemihosting + "-kernel \"$1\"",
            "--json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json.at("counts_cycles"));
  const auto& function = json.at("functions")[0];
  const int instructions = function.at("most_instructions"), cycles = function.at("most_cycles");
  EXPECT_GT(cycles, instructions / 2);
  EXPECT_LT(cycles, 2 * instructions + 20);
}

// A serial line, and a counter of one's own: the clock of this board, which ticks every 40 ns.
TEST_F(Runner, TakesAPort) {
  write_file(folder_.path() / "port.c",
             "#include <stdint.h>\n"
             "static volatile uint32_t* const line = (volatile uint32_t*)0x40004000;\n"
             "static uint32_t begun = 7;\n"
             "void treeline_board_begin(void) { if (begun == 7) line[4] = 16; line[2] = 1; }\n"
             "void treeline_board_write(const char* text, uint32_t length) {\n"
             "  for (uint32_t i = 0; i < length; ++i) {\n"
             "    while (line[1] & 1) {}\n"
             "    line[0] = (uint32_t)text[i];\n"
             "  }\n"
             "}\n"
             "uint64_t treeline_board_cycles(void) {\n"
             "  return 0xffffff - *(volatile uint32_t*)0xe000e018;\n"
             "}\n");
  const Outcome outcome = check(
      "cortex-m4f",
      "exec " + kArm + "-serial stdio -semihosting-config enable=on,target=native -kernel \"$1\"",
      "--port port.c --memory 0,0x20000000,0x400000 --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json.at("counts_cycles"));
  EXPECT_LT(json.at("functions")[0].at("most_cycles"),
            json.at("functions")[0].at("most_instructions"));
}

TEST_F(Runner, TellsWhatTheBoardDoesWrong) {
  const std::string whole = kArm + kSemihosting + "-kernel \"$1\"";
  const std::pair<std::string, std::string> faults[] = {
      {"true", "no results are printed"},
      {"echo Hard fault; exit 3", "the program stops with a fault (exit status 3)"},
      {whole + " | head -c 300", "the results are cut off after"},
      {whole + " | sed '5d'", "results were lost on the way"},
      {whole + " | sed 's/begin ./begin x/'", "the results are those of another program"},
      {"exec timeout 1 sleep 20", "it does not end in time"}};
  for (const auto& [script, fault] : faults) {
    const Outcome outcome = check("cortex-m4f", script);
    EXPECT_EQ(outcome.exit_code, 1) << script;
    EXPECT_EQ(outcome.out, "") << script;
    EXPECT_NE(outcome.err.find(fault), std::string::npos) << script << "\n" << outcome.err;
  }
}

TEST_F(Runner, RefusesWhatItCannotRead) {
  Outcome outcome = check("cortex-m4f", "true", "--memory 0x08000000");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("three numbers"), std::string::npos) << outcome.err;
  outcome = test::run_program(folder_.path(), "check " + kPlanar + " --memory 0,0,0");
  EXPECT_EQ(outcome.exit_code, 2);
  outcome = test::run_program(folder_.path(),
                              "check " + kPlanar + " --functions jacobian --runner ./runner");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("--target"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace treeline::tests
