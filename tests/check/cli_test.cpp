#include <nlohmann/json.hpp>

#include "cli/run_program.hpp"
#include "fixture.hpp"
#include "target/executes.hpp"

// `treeline check` as a shell runs it. Would catch: exit codes that hide a failure, output that is
// not JSON, messages among the data, and a route of a large robot that is fast and loses digits.

namespace treeline::tests {
namespace {

using test::Outcome;

class CheckCommand : public testing::Test {
 protected:
  Outcome run(const std::string& options) {
    const std::string folder = TREELINE_ROBOTS_DIR "/planar3r/";
    return test::run_program(folder_.path(), "check '" + folder + "planar3r.urdf' '" + folder +
                                                 "scene.yaml' --functions gravity,jacobian " +
                                                 options);
  }

  TemporaryFolder folder_;
};

TEST_F(CheckCommand, PassesWithATable) {
  const Outcome outcome = run("--states 20");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("passed: 2 functions"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CheckCommand, TellsOneStateAsJson) {
  const Outcome outcome = run("--states 1 --first 7 --seed 3 --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(json.at("passed"));
  ASSERT_EQ(json.at("named_states").size(), 1U);
  EXPECT_EQ(json.at("named_states")[0].at("index"), 7);
  EXPECT_EQ(json.at("named_states")[0].at("q").size(), 3U);
  EXPECT_EQ(json.at("functions")[0].at("name"), "jacobian");
  EXPECT_GT(json.at("functions")[0].at("code_bytes"), 0);
}

// The last joints of a humanoid's limbs are far from the origin of a common frame.
TEST_F(CheckCommand, LargeRobotsKeepTheirDigits) {
  const std::string tests = TREELINE_ROBOTS_DIR "/../tests/";
  const Outcome outcome = test::run_program(
      folder_.path(), "check '" + tests + "data/golden/humanoid24.urdf' '" + tests +
                          "bench/suite/humanoid24.yaml' --first 720 --states 14 --functions "
                          "mass_matrix,inverse_dynamics_derivatives,forward_dynamics_derivatives");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
}

TEST_F(CheckCommand, CorruptFolderIsThree) {
  Subjects subjects = load("planar3r");
  subjects.scene.functions = {Function::jacobian, Function::gravity};
  const Generation generation = generate(subjects.robot, subjects.scene);
  write_folder(folder_.path() / "generated", generation);
  const auto file = folder_.path() / "generated" / "jacobian.cpp";
  std::string text = read_file(file);
  const auto at = text.find(" + ");
  ASSERT_NE(at, std::string::npos);
  write_file(file, text.replace(at, 3, " - "));
  const Outcome outcome = run("--states 20 --generated generated");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.out.find("jacobian: beyond its bound"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("jacobian.cpp: stale"), std::string::npos) << outcome.out;
}

// Would catch: vectors and processors of the target that are not those of the delivered code.
TEST_F(CheckCommand, CompilesForAProcessorOfThisMachine) {
  const Target& target = *find_target("x86-64-v3");
  const Outcome outcome = run("--states 20 --target x86-64-v3");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find(target.flags) != std::string::npos, executes(target)) << outcome.out;
  EXPECT_EQ(outcome.err.find("does not execute") == std::string::npos, executes(target));
  EXPECT_EQ(run("--states 20 --target x86-64-v3 --flags -O1").out.find(target.flags),
            std::string::npos);
}

TEST_F(CheckCommand, BadInputIsOneAndBadUsageTwo) {
  const Outcome outcome = run("--generated nowhere");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("nowhere"), std::string::npos) << outcome.err;
  EXPECT_EQ(run("--states 0").exit_code, 2);
}

}  // namespace
}  // namespace treeline::tests
