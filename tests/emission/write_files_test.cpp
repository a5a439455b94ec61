#include "emission/write_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <future>
#include <iterator>

#include "emission/compare_files.hpp"
#include "emission/sample.hpp"
#include "interruption/folder_guard.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class WriteFilesTest : public testing::Test {
 protected:
  WriteFilesTest() { fs::remove_all(root_); }
  ~WriteFilesTest() override { fs::remove_all(root_); }

  [[nodiscard]] int entries_of_root() const {
    return static_cast<int>(std::distance(fs::directory_iterator(root_), {}));
  }

  std::vector<GeneratedFile> emit_programs(std::vector<Program> programs) {
    return emit(test::sample_context("arm", false), programs, diagnostics_);
  }

  fs::path root_ =
      fs::temp_directory_path() /
      ("treeline_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  fs::path folder_ = root_ / "deep" / "arm";
  Diagnostics diagnostics_;
};

// Would catch: missing parents, left-over temporary folders, lost bytes.
TEST_F(WriteFilesTest, MakesTheFolderAndNothingElse) {
  const auto files = emit_programs(test::sample_programs());
  ASSERT_TRUE(write_files(folder_ / "", files, diagnostics_));
  for (const GeneratedFile& file : files) {
    EXPECT_EQ(read(folder_ / file.name), file.text);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(root_ / "deep"), fs::directory_iterator()), 1);
  EXPECT_TRUE(compare_files(folder_, files).empty());
}

// Would catch: complete rebuilds because time stamps changed.
TEST_F(WriteFilesTest, LeavesEqualFilesUntouched) {
  const auto files = emit_programs(test::sample_programs());
  ASSERT_TRUE(write_files(folder_, files, diagnostics_));
  const fs::file_time_type old = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder_ / "arm.hpp", old);
  fs::last_write_time(folder_ / "sin_cos.hpp", old);
  std::ofstream(folder_ / "arm.hpp") << "edited";
  ASSERT_TRUE(write_files(folder_, files, diagnostics_));
  EXPECT_EQ(fs::last_write_time(folder_ / "sin_cos.hpp"), old);
  EXPECT_TRUE(compare_files(folder_, files).empty());
}

// Would catch: stale functions that stay in the folder, and the user's files that disappear.
TEST_F(WriteFilesTest, RemovesItsOwnStaleFilesOnly) {
  ASSERT_TRUE(write_files(folder_, emit_programs(test::sample_programs()), diagnostics_));
  std::ofstream(folder_ / "notes.txt") << "mine";
  const auto fewer = emit_programs({test::sample_programs()[0]});
  const auto differences = compare_files(folder_, fewer);
  EXPECT_TRUE(std::any_of(differences.begin(), differences.end(), [](const FileDifference& d) {
    return d.name == "corner_cases.cpp" && d.difference == Difference::left_over;
  }));
  ASSERT_TRUE(write_files(folder_, fewer, diagnostics_));
  EXPECT_FALSE(fs::exists(folder_ / "corner_cases.cpp"));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
}

// Would catch: a staleness check that does not detect an edit, a lost file or a missing folder.
TEST_F(WriteFilesTest, CompareSeesEveryDifference) {
  const auto files = emit_programs(test::sample_programs());
  EXPECT_EQ(compare_files(folder_, files).size(), files.size());
  ASSERT_TRUE(write_files(folder_, files, diagnostics_));
  std::ofstream(folder_ / "inverse_dynamics.cpp", std::ios::app) << " ";
  fs::remove(folder_ / "arm.hpp");
  const auto differences = compare_files(folder_, files);
  ASSERT_EQ(differences.size(), 2u);
  EXPECT_EQ(differences[0].name, "arm.hpp");
  EXPECT_EQ(differences[0].difference, Difference::missing);
  EXPECT_EQ(differences[1].name, "inverse_dynamics.cpp");
  EXPECT_EQ(differences[1].difference, Difference::changed);
}

// Would catch: half a folder after a failure, and a failure without a message.
TEST_F(WriteFilesTest, FailureIsReportedAndLeavesNothing) {
  fs::create_directories(root_);
  std::ofstream(root_ / "deep") << "a file where a folder should be";
  EXPECT_FALSE(write_files(folder_, emit_programs(test::sample_programs()), diagnostics_));
  EXPECT_TRUE(diagnostics_.has_errors());
  EXPECT_EQ(entries_of_root(), 1);
}

// Would catch: a mixture of two runs that write at the same time, and a run that waits forever.
TEST_F(WriteFilesTest, WaitsForAnotherRunAndSaysSo) {
  fs::create_directories(folder_);
  std::string error;
  auto guard = FolderGuard::try_lock(folder_, error);
  ASSERT_TRUE(guard) << error;
  const auto files = emit_programs(test::sample_programs());
  EXPECT_FALSE(write_files(folder_, files, diagnostics_, std::chrono::milliseconds(0)));
  ASSERT_TRUE(diagnostics_.has_errors());
  EXPECT_NE(diagnostics_.list().back().fault.find("another run"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder_));
  auto other =
      std::async(std::launch::async, [&] { return write_files(folder_, files, diagnostics_); });
  guard.reset();
  EXPECT_TRUE(other.get());
  EXPECT_TRUE(compare_files(folder_, files).empty());
}

// Would catch: files of a killed run that block the next one or are never removed.
TEST_F(WriteFilesTest, RemovesWhatAKilledRunLeft) {
  fs::create_directories(folder_ / ".treeline-part");
  std::ofstream(folder_ / ".treeline-part" / "gravity.cpp") << "half";
  const auto files = emit_programs(test::sample_programs());
  ASSERT_TRUE(write_files(folder_, files, diagnostics_));
  EXPECT_FALSE(fs::exists(folder_ / ".treeline-part"));
}

// Would catch: a new folder that stays empty because nothing could be written.
TEST_F(WriteFilesTest, FailureTakesTheNewFolderAway) {
  fs::create_directories(root_);
  const std::vector<GeneratedFile> impossible = {{"no/such/folder.hpp", "text"}};
  EXPECT_FALSE(write_files(root_ / "arm", impossible, diagnostics_));
  EXPECT_TRUE(diagnostics_.has_errors());
  EXPECT_EQ(entries_of_root(), 0);
}

TEST_F(WriteFilesTest, NoNameIsAnError) {
  EXPECT_FALSE(write_files("", emit_programs(test::sample_programs()), diagnostics_));
  ASSERT_TRUE(diagnostics_.has_errors());
  EXPECT_FALSE(diagnostics_.list().back().remedy.empty());
}

// Would catch: a manifest that makes the generator delete the folder above.
TEST_F(WriteFilesTest, ManifestCannotNameFolders) {
  const auto files = emit_programs(test::sample_programs());
  ASSERT_TRUE(write_files(folder_, files, diagnostics_));
  std::ofstream(folder_ / "manifest.json") << "{\n  \"files\": [\n    \"..\",\n    \".\"\n  ]\n}\n";
  EXPECT_TRUE(write_files(folder_, files, diagnostics_)) << to_string(diagnostics_.list().back());
  EXPECT_TRUE(compare_files(folder_, files).empty());
}

// Would catch: a foreign manifest that makes the generator delete files outside its folder.
TEST_F(WriteFilesTest, ManifestCannotReachOutside) {
  const auto files = emit_programs(test::sample_programs());
  ASSERT_TRUE(write_files(folder_, files, diagnostics_));
  std::ofstream(root_ / "precious") << "mine";
  std::ofstream(folder_ / "manifest.json") << "{\n  \"files\": [\n    \"../../precious\"\n  ]\n}\n";
  ASSERT_TRUE(write_files(folder_, files, diagnostics_));
  EXPECT_TRUE(fs::exists(root_ / "precious"));
}

}  // namespace
}  // namespace treeline
