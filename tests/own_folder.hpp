#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace treeline::test {

/// A test with an empty folder of its own, which is removed at the end. The folder's name has those
/// of suite and test, so that tests may run at the same time.
class OwnFolder : public testing::Test {
 protected:
  OwnFolder() {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_);
  }
  ~OwnFolder() override { std::filesystem::remove_all(root_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name, std::ios::binary) << text;
  }

  static std::string name_of_test() {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    return std::string(test->test_suite_name()) + "_" + test->name();
  }

  std::filesystem::path root_ =
      std::filesystem::temp_directory_path() / ("treeline_" + name_of_test());
};

}  // namespace treeline::test
