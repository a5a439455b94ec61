// Would catch: a folder that is called out of date because its cheapest algorithm loses digits, so
// that `generate` took the next; a refusal whose own advice leads to another one.
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

// The advice is to let `check` print the state. A self-test, which needs states within the bounds,
// stood in its way.
TEST_F(Tried, AFunctionThatFailsIsShownByCheckAlsoWithASelftest) {
  write("loose.urdf",
        read_file(fs::path(TREELINE_ROBOTS) / "../tests/data/written/loose_body.urdf"));
  write("loose.yaml",
        "base: floating\n"
        "operational_points: [{name: tip, link: body, axes: local, rows: [x, ry, rz], origin: "
        "{xyz: [-0.299, -0.124, 0.171], rpy: [1.463, -1.455, -0.147]}}]\n"
        "functions: [lambda]\n"
        "selftest: 2\n");
  const Outcome refused = run("generate loose.urdf loose.yaml -o out");
  ASSERT_EQ(refused.exit_code, 3) << refused.err;
  const auto begin = refused.err.find("`treeline ") + std::string("`treeline ").size();
  const Outcome shown = run(refused.err.substr(begin, refused.err.find('`', begin) - begin));
  EXPECT_EQ(shown.exit_code, 3) << shown.err;
  EXPECT_NE(shown.out.find("\"named_states\""), std::string::npos) << shown.out;
}

}  // namespace
}  // namespace treeline::test
