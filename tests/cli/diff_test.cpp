// Would catch: a `treeline diff` whose exit code is not the documented one, and an `inspect` whose
// patch does not lead to its repaired file.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "program_test.hpp"

namespace treeline::test {
namespace {

namespace fs = std::filesystem;

class Diff : public ProgramTest {
 protected:
  Diff() { write("puma.urdf", puma_); }

  std::string puma_ = read_file(fs::path(TREELINE_ROBOTS) / "puma560/puma560.urdf");
};

TEST_F(Diff, ExitCodes) {
  const Outcome same = run("diff puma.urdf puma.urdf");
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("the same"), std::string::npos) << same.out;
  const std::size_t at = puma_.find("mass value=\"") + 12;
  const std::string heavier = puma_.substr(0, at) + '1' + puma_.substr(at);
  write("heavier.urdf", heavier);
  const Outcome different = run("diff puma.urdf heavier.urdf --json");
  EXPECT_EQ(different.exit_code, 3) << different.err;
  EXPECT_TRUE(nlohmann::json::parse(different.out)["differs"]);
  EXPECT_EQ(run("diff puma.urdf missing.urdf").exit_code, 1);
  EXPECT_EQ(run("diff puma.urdf").exit_code, 2);
  EXPECT_EQ(run("diff puma.urdf puma.urdf --tolerance -1").exit_code, 2);
}

// Would catch: a file name that breaks a line in two, or that ends the program.
TEST_F(Diff, FileNamesMayBeAnyBytes) {
  fs::copy_file(root_ / "puma.urdf", root_ / "two\nlines.urdf");
  fs::copy_file(root_ / "puma.urdf", root_ / "latin\xE4.urdf");
  const std::string names = "\"$(printf 'two\\nlines.urdf')\" \"$(printf 'latin\\344.urdf')\"";
  const Outcome text = run("diff " + names);
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out.rfind("two\\x0alines.urdf (puma560) and latin\\xe4.urdf (puma560): ", 0), 0U)
      << text.out;
  const Outcome json = run("diff " + names + " --json");
  EXPECT_EQ(json.exit_code, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(json.out)["first"]["file"], "two\nlines.urdf");
}

const std::string kImpossible =
    "<robot name=\"r\">\n  <link name=\"world\"/>\n  <joint name=\"free\" "
    "type=\"floating\"><parent "
    "link=\"world\"/><child link=\"a\"/></joint>\n  <link name=\"a\">\n    <inertial>\n      <mass "
    "value=\"1\"/>\n      <inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" "
    "izz=\"0.4\"/>\n    </inertial>\n  </link>\n</robot>\n";

TEST_F(Diff, RepairAndPatchAgree) {
  write("bad.urdf", kImpossible);
  const Outcome inspected = run("inspect bad.urdf --repair repaired.urdf");
  ASSERT_EQ(inspected.exit_code, 0) << inspected.err;
  EXPECT_NE(inspected.out.find("the motion feels it"), std::string::npos) << inspected.out;
  EXPECT_EQ(read_file(root_ / "bad.urdf"), kImpossible);
  std::string expected = kImpossible;
  expected.replace(expected.find("ixx=\"0.1\""), 9, "ixx=\"0.2\"");
  expected.replace(expected.find("iyy=\"0.1\""), 9, "iyy=\"0.2\"");
  EXPECT_EQ(read_file(root_ / "repaired.urdf"), expected);

  write("report.txt", inspected.out);
  const std::string command =
      "cd '" + root_.string() + "' && patch -s -o patched.urdf bad.urdf report.txt";
  if (std::system("command -v patch >/dev/null") == 0) {
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(read_file(root_ / "patched.urdf"), expected);
  }
  EXPECT_EQ(run("diff bad.urdf repaired.urdf").exit_code, 3);
  const Outcome again = run("inspect repaired.urdf --repair again.urdf");
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(read_file(root_ / "again.urdf"), expected);
  EXPECT_NE(again.err.find("nothing needed repair"), std::string::npos) << again.err;
  EXPECT_EQ(run("inspect bad.urdf --repair missing/folder.urdf").exit_code, 1);
}

}  // namespace
}  // namespace treeline::test
