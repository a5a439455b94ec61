// Would catch: a folder that is called out of date because its cheapest algorithm loses digits, so
// that `generate` took the next.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program_test.hpp"

namespace treeline::test {
namespace {

namespace fs = std::filesystem;

class Tried : public ProgramTest {};

TEST_F(Tried, AFolderByAnotherAlgorithmIsUpToDate) {
  for (const char* const file : {"light_tool.urdf", "light_tool.yaml"}) {
    write(file, read_file(fs::path(TREELINE_ROBOTS) / "../tests/data/written" / file));
  }
  const std::string files = "light_tool.urdf light_tool.yaml";
  const Outcome made = run("generate " + files + " -o out");
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.err.find("It is written by another"), std::string::npos) << made.err;
  const Outcome compared = run("generate " + files + " -o out --compare");
  EXPECT_EQ(compared.exit_code, 0) << compared.out;
  EXPECT_EQ(compared.err, made.err);  // the same note, and no other
}

}  // namespace
}  // namespace treeline::test
