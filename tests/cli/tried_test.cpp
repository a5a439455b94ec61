// Would catch: a folder that is called out of date because its cheapest algorithm loses digits, so
// that `generate` took the next; a refusal whose own advice leads to another one, or that calls a
// fault of the program what the scene asks for; a constant that was rounded before it was combined
// with others.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
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
// A clamped joint leaves the task nothing to move with, and `singular: exact` divides by that.
TEST_F(Tried, AFunctionThatFailsIsShownByCheckAlsoWithASelftest) {
  write("held.urdf",
        "<robot name='held'><link name='base'/><link name='arm'><inertial>"
        "<origin xyz='-0.258 -0.147 -0.052'/><mass value='2'/>"
        "<inertia ixx='0.3' iyy='0.4' izz='0.2' ixy='0' ixz='0' iyz='0'/></inertial></link>"
        "<joint name='hinge' type='revolute'><parent link='base'/><child link='arm'/>"
        "<origin rpy='0.3 0.5 0.7'/><axis xyz='0 0 1'/>"
        "<limit lower='-1' upper='1' effort='10' velocity='8'/></joint></robot>");
  write("held.yaml",
        "singular: exact\n"
        "operational_points: [{name: tip, link: arm, rows: [z], origin: {xyz: [-0.35, 0.26, "
        "-0.1]}}]\n"
        "constraints: [{name: clamp, between: [arm, world], rows: [y, rz]}]\n"
        "functions: [supported_control_torque]\n"
        "selftest: 2\n");
  const Outcome refused = run("generate held.urdf held.yaml -o out");
  ASSERT_EQ(refused.exit_code, 3) << refused.err;
  EXPECT_NE(refused.err.find("with `singular: smooth` it yields"), std::string::npos)
      << refused.err;
  const auto begin = refused.err.find("`treeline ") + std::string("`treeline ").size();
  const Outcome shown = run(refused.err.substr(begin, refused.err.find('`', begin) - begin));
  EXPECT_EQ(shown.exit_code, 3) << shown.err;
  EXPECT_NE(shown.out.find("\"named_states\""), std::string::npos) << shown.out;
}

// A body that floats beside its base: its Lambda is a constant, to which every algorithm comes
// through numbers that are 500 times as large. Would catch constants that are rounded before they
// are combined: they were off by 260 ulp, and nothing was written.
TEST_F(Tried, ConstantsAreRoundedOnce) {
  write("loose.urdf",
        read_file(fs::path(TREELINE_ROBOTS) / "../tests/data/written/loose_body.urdf"));
  write("loose.yaml",
        "base: floating\n"
        "operational_points: [{name: tip, link: body, axes: local, rows: [x, ry, rz], origin: "
        "{xyz: [-0.299, -0.124, 0.171], rpy: [1.463, -1.455, -0.147]}}]\n"
        "functions: [lambda]\n");
  const Outcome checked = run("check loose.urdf loose.yaml --first 460 --states 10 --json");
  ASSERT_EQ(checked.exit_code, 0) << checked.out << checked.err;
  const auto errors = nlohmann::json::parse(checked.out);
  EXPECT_LE(errors["functions"][0]["worst"]["error"].get<double>(), 0.5);
}

}  // namespace
}  // namespace treeline::test
