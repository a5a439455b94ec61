// Would catch: a certificate of bounds that are far from those of the header, a failed proof that
// passes, and a message that does not name the missing package.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/run_program.hpp"
#include "compilation/temporary_folder.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

const std::string kPuma =
    "'" TREELINE_ROBOTS_DIR "/puma560/puma560.urdf' '" TREELINE_ROBOTS_DIR "/puma560/scene.yaml' ";

bool starts(const char* program) {
  return std::system((std::string(program) + " --version >/dev/null 2>&1").c_str()) == 0;
}

TEST(CertifyCommand, ProvesMassMatrixAndGravityAsTheHeaderStatesThem) {
  if (!starts("gappa")) GTEST_SKIP() << "the program gappa is not installed";
  const TemporaryFolder folder;
  const auto run = test::run_program(
      folder.path(), "certify " + kPuma + "--functions gravity,mass_matrix --json --output proofs");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto report = nlohmann::json::parse(run.out);
  ASSERT_EQ(report["functions"].size(), 2U);
  for (const auto& function : report["functions"]) {
    EXPECT_LE(function["results"][0]["ratio"], 1.1) << function;
    EXPECT_GE(function["results"][0]["ratio"], 0.5) << function;
    const fs::path scripts = folder.path() / "proofs" / std::string(function["name"]);
    const auto files = std::distance(fs::directory_iterator(scripts), fs::directory_iterator());
    EXPECT_EQ(static_cast<std::size_t>(files), function["steps"]);
  }
  const std::string last = (folder.path() / "proofs/gravity/step_0190.g").string();
  EXPECT_EQ(std::system(("gappa '" + last + "' 2>/dev/null").c_str()), 0);
}

TEST(CertifyCommand, LetsCoqCheckGravity) {
  if (!starts("gappa") || !starts("coqc")) GTEST_SKIP() << "gappa or coq is not installed";
  const TemporaryFolder folder;
  const auto run = test::run_program(
      folder.path(), "certify " + kPuma + "--functions gravity --json --coq --output proofs");
  EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
  const auto function = nlohmann::json::parse(run.out)["functions"][0];
  EXPECT_TRUE(function["checked_by_coq"]);
  const std::string proof = test::read_file(folder.path() / "proofs/gravity.v");
  for (const char* unproven : {"Hypothesis a", "Admitted", "Axiom"}) {
    EXPECT_EQ(proof.find(unproven), std::string::npos) << unproven;
  }
}

TEST(CertifyCommand, FailsWhereTheProofIsWorseThanAskedFor) {
  if (!starts("gappa")) GTEST_SKIP() << "the program gappa is not installed";
  const TemporaryFolder folder;
  const auto run =
      test::run_program(folder.path(), "certify " + kPuma + "--functions gravity --within 0.1");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.out.find("FAILED"), std::string::npos) << run.out;
  const auto late =
      test::run_program(folder.path(), "certify " + kPuma + "--functions gravity --seconds 0");
  EXPECT_EQ(late.exit_code, 3);
  EXPECT_NE(late.out.find("the time is over"), std::string::npos) << late.out;
}

TEST(CertifyCommand, HasNoProofOfDivisions) {
  if (!starts("gappa")) GTEST_SKIP() << "the program gappa is not installed";
  const TemporaryFolder folder;
  const auto run = test::run_program(folder.path(), "certify " + kPuma + "--functions lambda");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.out.find("not tried"), std::string::npos) << run.out;
}

TEST(CertifyCommand, NamesThePackageOfAMissingProgram) {
  const TemporaryFolder folder;
  const std::string command = "cd '" + folder.path().string() + "' && PATH=nothing '" +
                              TREELINE_PROGRAM "' certify " + kPuma +
                              "--functions gravity 2>message >/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  const std::string message = test::read_file(folder.path() / "message");
  EXPECT_NE(message.find("apt-get install gappa"), std::string::npos) << message;
}

}  // namespace
}  // namespace treeline::tests
