#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../own_environment.hpp"
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
    environment_.set("CXX", compiler);
    environment_.set("TREELINE_CACHE", root_ / "kept");
    write("scene.yaml", "operational_points: [{name: tool, link: link3}]\n");
  }

  /// Number of sources that a drive compiles.
  [[nodiscard]] std::size_t count_compiled() {
    fs::remove(root_ / "compiled");
    const Outcome outcome = drive(kRobots + "/planar3r/planar3r.urdf scene.yaml", "start\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    said_ = outcome.err;
    return fs::exists(root_ / "compiled") ? fs::file_size(root_ / "compiled") : 0;
  }

  test::OwnEnvironment environment_;
  std::string said_;
};

TEST_F(DriveAgain, CompilesOnlyWhatHasChanged) {
  EXPECT_GT(count_compiled(), 2U);
  EXPECT_EQ(count_compiled(), 0U);
  write("scene.yaml",
        "operational_points: [{name: tool, link: link3, origin: {xyz: [0.1, 0, 0]}}]");
  EXPECT_GT(count_compiled(), 2U);
}

// Another user could have put there what would be loaded.
TEST_F(DriveAgain, LoadsNothingThatOthersCouldHaveWritten) {
  EXPECT_GT(count_compiled(), 2U);
  EXPECT_EQ(said_.find("TREELINE_CACHE"), std::string::npos) << said_;
  fs::permissions(root_ / "kept", fs::perms::all);
  EXPECT_GT(count_compiled(), 2U);
  EXPECT_NE(said_.find("others may write to it"), std::string::npos) << said_;
  EXPECT_NE(said_.find("chmod go-w"), std::string::npos) << said_;
}

TEST_F(DriveAgain, KeepsNothingWhereAskedTo) {
  environment_.set("TREELINE_CACHE", "");
  environment_.set("HOME", root_);
  EXPECT_GT(count_compiled(), 2U);
  EXPECT_FALSE(fs::exists(root_ / "kept"));
  EXPECT_FALSE(fs::exists(root_ / ".cache"));
}

}  // namespace
}  // namespace treeline
