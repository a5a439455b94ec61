#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "program_test.hpp"

namespace treeline::test {

inline const std::string kArm = std::string(TREELINE_ROBOTS) + "/puma560/puma560.urdf";

class PackageTest : public OwnFolder {
 protected:
  [[nodiscard]] Outcome generate(const std::string& options) const {
    return run_program(root_, "generate " + kArm +
                                  " --functions gravity,inverse_dynamics --name arm "
                                  "--output lib " +
                                  options);
  }

  /// Runs a command in the test's folder. True if it succeeds.
  [[nodiscard]] bool run(const std::string& command) const {
    const std::string in_folder = "cd '" + root_.string() + "' && (" + command + ") > log 2>&1";
    const bool succeeded = std::system(in_folder.c_str()) == 0;
    EXPECT_TRUE(succeeded) << command << "\n" << read("log");
    return succeeded;
  }

  [[nodiscard]] std::string read(const std::string& file) const { return read_file(root_ / file); }

  const std::string cxx_ = TREELINE_CXX;
};

}  // namespace treeline::test
