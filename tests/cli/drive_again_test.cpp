#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "drive_fixture.hpp"

// Would catch: a robot that is compiled anew at each start, and one whose code is that of another
// scene or program.

namespace treeline {
namespace {

namespace fs = std::filesystem;

class DriveAgain : public DriveTest {
 protected:
  DriveAgain() {
    // A compiler that counts what it compiles.
    const fs::path compiler = root_ / "compiler";
    write("compiler", fmt::format("#!/bin/sh\ncase \"$*\" in *' -c '*) echo >> '{}';; esac\n"
                                  "exec c++ \"$@\"\n",
                                  (root_ / "compiled").string()));
    fs::permissions(compiler, fs::perms::owner_all);
    setenv("CXX", compiler.c_str(), 1);
    setenv("TREELINE_CACHE", (root_ / "kept").c_str(), 1);
    write("scene.yaml", "operational_points: [{name: tool, link: link3}]\n");
  }
  ~DriveAgain() override { unsetenv("CXX"); }

  /// Number of sources that a drive compiles.
  [[nodiscard]] std::size_t count_compiled() const {
    fs::remove(root_ / "compiled");
    const Outcome outcome = drive(kRobots + "/planar3r/planar3r.urdf scene.yaml", "start\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return fs::exists(root_ / "compiled") ? fs::file_size(root_ / "compiled") : 0;
  }
};

TEST_F(DriveAgain, CompilesOnlyWhatHasChanged) {
  EXPECT_GT(count_compiled(), 2U);
  EXPECT_EQ(count_compiled(), 0U);
  write("scene.yaml",
        "operational_points: [{name: tool, link: link3, origin: {xyz: [0.1, 0, 0]}}]");
  EXPECT_GT(count_compiled(), 2U);
}

TEST_F(DriveAgain, KeepsNothingWhereAskedTo) {
  setenv("TREELINE_CACHE", "", 1);
  setenv("HOME", root_.c_str(), 1);
  EXPECT_GT(count_compiled(), 2U);
  EXPECT_FALSE(fs::exists(root_ / "kept"));
  EXPECT_FALSE(fs::exists(root_ / ".cache"));
}

}  // namespace
}  // namespace treeline
