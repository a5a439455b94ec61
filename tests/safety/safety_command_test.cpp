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
