// `treeline doctor`. Would catch: a program that is there and called missing, one that is not and
// called there, and a way to install it that is left out.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "../own_environment.hpp"
#include "program_test.hpp"

namespace treeline {
namespace {

class DoctorTest : public test::ProgramTest {
 protected:
  /// Writes a program that says its version, or fails.
  void write_program(const std::string& name, int exit_code) {
    const auto path = root_ / name;
    std::ofstream(path) << "#!/bin/sh\necho '" << name << " 1.2.3'\nexit " << exit_code << "\n";
    chmod(path.c_str(), S_IRWXU);
  }
};

TEST_F(DoctorTest, TellsWhatIsThere) {
  write_program("cmake", 0);
  write_program("gappa", 1);
  write_program("own", 0);
  test::OwnEnvironment environment;
  environment.set("PATH", root_.string());
  environment.set("CXX", "own --strict");
  const auto outcome = run("doctor --json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  std::map<std::string, nlohmann::json> needs;
  for (const auto& need : nlohmann::json::parse(outcome.out)) needs[need["name"]] = need;
  EXPECT_EQ(needs["cmake"]["version"], "cmake 1.2.3");
  EXPECT_EQ(needs["own --strict ($CXX)"]["version"], "own 1.2.3");
  EXPECT_EQ(needs["gappa"]["found"], false);
  EXPECT_EQ(needs["arm-none-eabi-g++"]["found"], false);
  const std::string used_by = needs["arm-none-eabi-g++"]["used_by"];
  EXPECT_NE(used_by.find("cortex-m4f"), std::string::npos) << used_by;
  const auto text = run("doctor");
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.out.find("missing: apt-get install gappa"), std::string::npos) << text.out;
}

}  // namespace
}  // namespace treeline
