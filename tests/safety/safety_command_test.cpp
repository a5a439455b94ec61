// Would catch: notes for a review that differ from run to run, name other bytes than those written,
// call an unproven bound proven, or pass a failed report off as evidence.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "cli/run_program.hpp"
#include "compilation/temporary_folder.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

const std::string kPuma = "'" TREELINE_ROBOTS_DIR "/puma560/puma560.urdf' '" TREELINE_ROBOTS_DIR
                          "/puma560/scene.yaml' --functions gravity,forward_dynamics ";

class SafetyNotes : public testing::Test {
 protected:
  test::Outcome generate(const std::string& options) const {
    return test::run_program(folder_.path(),
                             "generate " + kPuma + "--output code --safety SAFETY.md " + options);
  }
  std::string notes() const { return test::read_file(folder_.path() / "SAFETY.md"); }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_.path() / file) << text;
  }

  TemporaryFolder folder_;
};

TEST_F(SafetyNotes, NameTheBytesThatAreWritten) {
  ASSERT_EQ(generate("").exit_code, 0);
  const std::string text = notes();
  const std::regex row(R"(\| `(\S+)` \| (input|output) \| `([0-9a-f]{64})` \|)");
  int outputs = 0;
  std::ofstream sums(folder_.path() / "sums");
  for (std::sregex_iterator at(text.begin(), text.end(), row), end; at != end; ++at) {
    const bool is_output = (*at)[2] == "output";
    outputs += is_output ? 1 : 0;
    sums << (*at)[3] << "  " << (is_output ? "code/" : TREELINE_ROBOTS_DIR "/puma560/") << (*at)[1]
         << "\n";
  }
  sums.close();
  const fs::path code = folder_.path() / "code";
  EXPECT_EQ(outputs, std::distance(fs::directory_iterator(code), fs::directory_iterator()));
  const std::string command = "cd '" + folder_.path().string() + "' && sha256sum --quiet -c sums";
  EXPECT_EQ(std::system(command.c_str()), 0);
  fs::remove(folder_.path() / "SAFETY.md");
  ASSERT_EQ(generate("").exit_code, 0);
  EXPECT_EQ(notes(), text);
}

TEST_F(SafetyNotes, TellProvenBoundsFromOthers) {
  ASSERT_EQ(generate("").exit_code, 0);
  std::smatch row;
  const std::string text = notes();
  ASSERT_TRUE(std::regex_search(text, row, std::regex("\\| `gravity` .*\\| (.*) \\|\n")));
  EXPECT_EQ(row[1], "proven");
  ASSERT_TRUE(std::regex_search(text, row, std::regex("\\| `forward_dynamics` .*\\| (.*) \\|\n")));
  EXPECT_EQ(row[1], "searched, not proven");
}

// Would catch: code without the notes that were asked for.
TEST_F(SafetyNotes, NothingIsWrittenWithoutItsEvidence) {
  write("no_report.json", "{}");
  const test::Outcome outcome = generate("--evidence no_report.json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("is no report of check or certify"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_.path() / "code"));
}

// Would catch: a table of the other language or profile, which names rules that the code keeps or
// leaves out some that it does not.
TEST_F(SafetyNotes, NameTheRulesThatTheCodeDeviatesFrom) {
  struct Case {
    const char* options;
    const char* standard;
    std::vector<const char*> deviations, kept;
  };
  const std::vector<Case> cases = {
      {"--language c", "MISRA C:2012", {"| 2.3 ", "| 2.5 ", "| 19.2 "}, {"8.2.5"}},
      {"--language c --profile misra", "MISRA C:2012", {"| 2.3 ", "| 2.4 "}, {"| 2.5 ", "| 19.2 "}},
      {"", "MISRA C++:2023", {"| 11.3.1 ", "| 8.2.5 ", "| 19.0.2 "}, {"| 19.2 "}},
      {"--profile misra", "MISRA C++:2023", {"| 11.3.1 ", "| 11.6.1 "}, {"required)", "| 19."}}};
  for (const Case& each : cases) {
    ASSERT_EQ(generate(each.options).exit_code, 0) << each.options;
    const std::string text = notes();
    const std::string rules = text.substr(text.find("## Coding rules"));
    EXPECT_NE(rules.find(each.standard), std::string::npos) << each.options;
    for (const char* rule : each.deviations) {
      EXPECT_NE(rules.find(rule), std::string::npos) << each.options << ": " << rule;
    }
    for (const char* rule : each.kept) {
      EXPECT_EQ(rules.find(rule), std::string::npos) << each.options << ": " << rule;
    }
  }
}

TEST_F(SafetyNotes, TakeReportsAsTheyAre) {
  const auto check = test::run_program(folder_.path(), "check " + kPuma + "--states 20 --json");
  ASSERT_EQ(check.exit_code, 0) << check.err;
  write("check.json", check.out);
  auto report = nlohmann::json::parse(check.out);
  report["passed"] = false;
  write("failed.json", report.dump());
  ASSERT_EQ(generate("--evidence check.json --evidence failed.json").exit_code, 0);
  const std::string text = notes();
  const std::size_t passed = text.find("### check.json"), failed = text.find("### failed.json");
  ASSERT_LT(passed, failed);
  EXPECT_LT(text.find("**passed**", passed), failed);
  EXPECT_NE(text.find("**FAILED**", failed), std::string::npos);
  const auto& first = report["functions"][0];
  const std::string cells = "| " + first["code_bytes"].dump() + " | " + first["stack_bytes"].dump();
  EXPECT_NE(text.find(cells, passed), std::string::npos) << cells;
}

/// The notes' word about a report, and whether any of its figures are shown.
void expect_stale(const std::string& text, const std::string& file, const std::string& why) {
  const std::string part = text.substr(text.find("### " + file));
  EXPECT_NE(part.find("**stale**"), std::string::npos) << part;
  EXPECT_EQ(part.find("**passed**"), std::string::npos) << part;
  EXPECT_NE(part.find(why), std::string::npos) << part;
  EXPECT_EQ(part.find("| function |"), std::string::npos) << part;
}

// Would catch: a report of another number type, of other masses, of another version, or without a
// digest, passed off as evidence for these files.
TEST_F(SafetyNotes, TakeNoReportOfOtherFiles) {
  const auto in_float =
      test::run_program(folder_.path(), "check " + kPuma + "--states 20 --real float --json");
  ASSERT_EQ(in_float.exit_code, 0) << in_float.err;
  write("float.json", in_float.out);
  std::string urdf = test::read_file(TREELINE_ROBOTS_DIR "/puma560/puma560.urdf");
  const std::size_t mass = urdf.find("<mass value=\"");
  ASSERT_NE(mass, std::string::npos);
  write("heavier.urdf", urdf.insert(mass + 13, "1"));
  const auto heavier = test::run_program(
      folder_.path(),
      "check heavier.urdf '" TREELINE_ROBOTS_DIR
      "/puma560/scene.yaml' --functions gravity,forward_dynamics --states 20 --json");
  ASSERT_EQ(heavier.exit_code, 0) << heavier.err;
  write("heavier.json", heavier.out);
  auto report = nlohmann::json::parse(in_float.out);
  report["generator"] = "0.0.1";
  write("older.json", report.dump());
  report.erase("digest");
  write("bare.json", report.dump());
  ASSERT_EQ(generate("--evidence float.json --evidence heavier.json --evidence older.json "
                     "--evidence bare.json")
                .exit_code,
            0);
  const std::string text = notes();
  expect_stale(text, "float.json", "the inputs or the options differ");
  expect_stale(text, "heavier.json", "the inputs or the options differ");
  expect_stale(text, "older.json", "code of Treeline 0.0.1");
  expect_stale(text, "bare.json", "it has no digest");
  ASSERT_EQ(generate("--real float --evidence float.json").exit_code, 0);
  EXPECT_NE(notes().find("**passed**"), std::string::npos);
}

// Would catch: notes that say of a controller what holds for functions alone, that leave out a
// fault which the header has, or a protection that the scene takes away.
TEST_F(SafetyNotes, TellOfTheControllersStep) {
  write("scene.yaml",
        "name: arm\nfunctions: [gravity]\ncontroller:\n  laws: joint_impedance\n  stale_ticks: 0\n "
        " limits:\n"
        "    joint2: {torque: none}\n");
  const auto made = test::run_program(
      folder_.path(), "generate '" TREELINE_ROBOTS_DIR
                      "/puma560/puma560.urdf' scene.yaml --output code --safety SAFETY.md");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string text = notes();
  for (const char* is_false : {"- Straight-line code: no loop", "the code has none of",
                               "- Functions are reentrant and keep no state"}) {
    EXPECT_EQ(text.find(is_false), std::string::npos) << is_false;
  }
  const std::string header = test::read_file(folder_.path() / "code" / "arm_controller.h");
  const std::regex fault(R"(ARM_FAULT_(\w+) = (\d+))");
  int faults = 0;
  for (std::sregex_iterator at(header.begin(), header.end(), fault), end; at != end; ++at) {
    const std::string row = "| " + (*at)[2].str() + " | `" + (*at)[1].str() + "` |";
    EXPECT_NE(text.find(row), std::string::npos) << row;
    ++faults;
  }
  EXPECT_EQ(faults, 10);
  EXPECT_NE(text.find("| `stale_ticks` | 0 steps: **unsafe** |"), std::string::npos) << text;
  EXPECT_EQ(text.find("| `jump` | 0.05 rad, m: **unsafe** |"), std::string::npos) << text;
  EXPECT_NE(text.find("- `joint2`: torque (no spring"), std::string::npos) << text;
}

// Would catch: notes that speak of functions and bounds which a controller alone does not have, or
// of the headers of another language.
TEST_F(SafetyNotes, TellOfAControllerAlone) {
  write("scene.yaml",
        "name: arm\nlanguage: c\nfunctions: []\ncontroller: {laws: joint_impedance, brake_damping: "
        "0.1}\n");
  const auto made = test::run_program(
      folder_.path(), "generate '" TREELINE_ROBOTS_DIR
                      "/puma560/puma560.urdf' scene.yaml --output code --safety SAFETY.md");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string text = notes();
  for (const char* is_false : {"functions of `arm", "arm.hpp", "Bounds of errors hold"}) {
    EXPECT_EQ(text.find(is_false), std::string::npos) << is_false;
  }
  for (const char* is_true : {"No bound of errors is stated.", "- The functions `controller_*`",
                              "| `brake_damping` | 0.1 1/s: **unsafe** |"}) {
    EXPECT_NE(text.find(is_true), std::string::npos) << is_true;
  }
}

// Would catch: notes that call straight-line what ends in a routine with loops, or a step that
// branches on what touches.
TEST_F(SafetyNotes, TellOfRoutinesAndOfTheGround) {
  std::string chain = "<robot name='chain'><link name='l0'/>";
  for (int i = 1; i <= 40; ++i) {
    const std::string child = "'l" + std::to_string(i) + "'";
    chain += "<link name=" + child +
             "><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' "
             "iyz='0'/></inertial><collision><geometry><sphere radius='0.1'/></geometry>"
             "</collision></link><joint name='j" +
             std::to_string(i) + "' type='continuous'><parent link='l" + std::to_string(i - 1) +
             "'/><child link=" + child +
             "/><origin xyz='0.1 0.2 0.3' rpy='0.1 0.2 0.3'/><axis xyz='0.6 0 0.8'/></joint>";
  }
  write("chain.urdf", chain + "</robot>");
  write("scene.yaml", "functions: [mass_matrix]\nground: {step: true}\n");
  const auto made = test::run_program(
      folder_.path(), "generate chain.urdf scene.yaml --output code --safety SAFETY.md");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(notes().find("- Functions that end with the call of a routine are not straight-line"),
            std::string::npos);
  EXPECT_NE(notes().find("- `chain_ground_step` is for simulation"), std::string::npos);
  const std::string header = test::read_file(folder_.path() / "code" / "chain.hpp");
  EXPECT_NE(header.find("as straight-line code and loops of constant length"), std::string::npos);
  EXPECT_NE(header.find("no branch on data"), std::string::npos);
}

TEST_F(SafetyNotes, RefuseOtherFilesAsEvidence) {
  write("none.json", "{}");
  write("other.json", R"({"name": "ur10e", "passed": true, "states": 1, "seed": 1,
                          "compile": {"command": ""}, "functions": []})");
  for (const char* file : {"none.json", "other.json", "missing.json"}) {
    const auto run = generate(std::string("--evidence ") + file);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
  }
}

}  // namespace
}  // namespace treeline::tests
