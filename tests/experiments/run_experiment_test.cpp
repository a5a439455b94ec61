// What experiments' programs share. Would catch: a broken claim, bad input, a file that cannot be
// written or a wrong option that looks like success, and files that nobody asked for.
#include "command_line/run_experiment.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace treeline::experiments {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class RunExperiment : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("treeline_run_experiment_") + test->name());
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// The exit status of a program with the options --csv, --svg and --substeps.
  int run(std::vector<std::string> words, const Findings& found) {
    CommandLine command{"A test."};
    add_outputs(command, paths_);
    add_substeps(command, substeps_);
    words.insert(words.begin(), "/somewhere/program");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    return run_experiment(command, static_cast<int>(arguments.size()), arguments.data(), [&] {
      ++runs_;
      Findings findings = found;
      findings.files = {{paths_.csv, "numbers"}, {paths_.svg, "picture"}};
      return findings;
    });
  }
  std::string at(const char* name) const { return (folder_ / name).string(); }

  fs::path folder_;
  OutputPaths paths_;
  int substeps_ = 1;
  int runs_ = 0;
};

TEST_F(RunExperiment, ExitStatusSaysWhatHappened) {
  EXPECT_EQ(run({}, {"", {}, true}), 0);
  EXPECT_EQ(run({}, {"", {}, false}), 3);
  EXPECT_EQ(run({}, bad_input("no such robot")), 1);
  EXPECT_EQ(run({}, {"", {}, true, "stopped"}), 1);
  EXPECT_EQ(run({"--csv", at("absent/a.csv")}, {"", {}, true}), 1);
}

TEST_F(RunExperiment, DoesNotRunOnWrongOptions) {
  EXPECT_EQ(run({"--cvs", "x"}, {"", {}, true}), 2);
  EXPECT_EQ(run({"--substeps", "0"}, {"", {}, true}), 2);
  EXPECT_EQ(run({"--help"}, {"", {}, true}), 0);
  EXPECT_EQ(runs_, 0);
}

TEST_F(RunExperiment, WritesOnlyRequestedFiles) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(run({"--svg", at("a.svg")}, {"a line\n", {}, true}), 0);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "a line\n");
  EXPECT_EQ(content(at("a.svg")), "picture");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(RunExperiment, SaysWhoFailed) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(run({}, bad_input("no such robot")), 1);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "program: no such robot\n");
}

TEST_F(RunExperiment, NamesTheFileOfTheOtherRun) {
  report::Table table({"t"}, 1);
  const double zero = 0;
  table.append(&zero);
  EXPECT_EQ(files_of_both({}, table, ".without", table, {})[1].path, "");
  const auto files = files_of_both({"a.csv", "a.svg"}, table, ".without", table, {});
  EXPECT_EQ(files[1].path, "a.csv.without");
  EXPECT_EQ(files[1].text, "t\n0\n");
  EXPECT_EQ(file_in("", "a.csv"), "");
  EXPECT_EQ(file_in("f", "a.csv"), "f/a.csv");
}

}  // namespace
}  // namespace treeline::experiments
