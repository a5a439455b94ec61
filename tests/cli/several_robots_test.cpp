#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "program_test.hpp"

// Scenes with several robots on the command line. Would catch: a command that takes one robot for
// all, inputs that the contract, the manifest or a build does not know of, and output that depends
// on where the files are.

namespace treeline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::read_file;

const std::string kRobots = TREELINE_ROBOTS;

const std::string kScene = R"(name: pair
robots:
  - {name: left, urdf: arms/planar3r.urdf}
  - {name: right, urdf: arms/planar3r.urdf, pose: {xyz: [0, 1, 0]}}
  - {name: stone, urdf: stone.urdf, base: floating}
operational_points:
  - {name: left_tip, link: left/link3, rows: [x, y]}
  - {name: right_tip, link: right/link3, rows: [x, y]}
)";

class SeveralRobots : public test::ProgramTest {
 protected:
  SeveralRobots() {
    fs::create_directories(root_ / "arms");
    fs::copy_file(kRobots + "/planar3r/planar3r.urdf", root_ / "arms/planar3r.urdf");
    write(
        "stone.urdf",
        "<robot name='stone'><link name='stone'><inertial><origin xyz='0.1 0 0'/><mass value='2'/>"
        "<inertia ixx='0.1' iyy='0.2' izz='0.2' ixy='0' ixz='0' iyz='0'/></inertial></link>"
        "</robot>");
    write("pair.yaml", kScene);
  }
};

TEST_F(SeveralRobots, GenerateNamesAllInputs) {
  const Outcome outcome = run("generate pair.yaml");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const YAML::Node manifest = YAML::LoadFile(root_ / "pair/manifest.json");
  EXPECT_EQ(manifest["command"].as<std::string>(), "treeline generate pair.yaml --output pair");
  ASSERT_EQ(manifest["inputs"].size(), 3U);
  EXPECT_EQ(manifest["inputs"][0]["file"].as<std::string>(), "pair.yaml");
  EXPECT_EQ(manifest["inputs"][1]["file"].as<std::string>(), "arms/planar3r.urdf");
  EXPECT_EQ(manifest["inputs"][2]["file"].as<std::string>(), "stone.urdf");
  const std::string contract = read_file(root_ / "pair/pair.hpp");
  EXPECT_NE(contract.find("From pair.yaml, arms/planar3r.urdf and stone.urdf by"),
            std::string::npos);
  EXPECT_NE(contract.find("left/joint1"), std::string::npos);
  EXPECT_NE(contract.find("right/joint3"), std::string::npos);
}

TEST_F(SeveralRobots, SameBytesFromAnywhere) {
  ASSERT_EQ(run("generate pair.yaml").exit_code, 0);
  fs::create_directories(root_ / "elsewhere");
  const Outcome piped = run("generate - --output elsewhere/pair < pair.yaml");
  ASSERT_EQ(piped.exit_code, 0) << piped.err;
  std::string absolute = "generate '";
  absolute += (root_ / "pair.yaml").string() + "' -o other";
  ASSERT_EQ(test::run_program(root_ / "elsewhere", absolute).exit_code, 0);
  for (const auto& entry : fs::directory_iterator(root_ / "pair")) {
    const fs::path name = entry.path().filename();
    EXPECT_EQ(read_file(entry.path()), read_file(root_ / "elsewhere/other" / name)) << name;
    // Headers name standard input as a file, and id.cpp has their digest.
    if (name.extension() != ".cpp" || name == "id.cpp") continue;
    EXPECT_EQ(read_file(entry.path()), read_file(root_ / "elsewhere/pair" / name)) << name;
  }
}

TEST_F(SeveralRobots, DepfileNamesEveryInput) {
  ASSERT_EQ(run("generate pair.yaml --depfile pair.stamp.d").exit_code, 0);
  const std::string rule = read_file(root_ / "pair.stamp.d");
  EXPECT_EQ(rule.find((root_ / "pair.stamp:").string()), 0U) << rule;
  for (const char* file : {"pair.yaml", "arms/planar3r.urdf", "stone.urdf"}) {
    EXPECT_NE(rule.find((root_ / file).string()), std::string::npos) << file;
  }
}

TEST_F(SeveralRobots, CheckPassesAgainstFiftyDigits) {
  const Outcome outcome = run("check pair.yaml --states 40 --flags -O0");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST_F(SeveralRobots, OtherCommandsTakeThem) {
  const Outcome inspected = run("inspect pair.yaml");
  EXPECT_EQ(inspected.exit_code, 0) << inspected.err;
  EXPECT_NE(inspected.out.find("right/joint3"), std::string::npos);
  const Outcome drawn = run("draw pair.yaml --svg pair.svg");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_GT(read_file(root_ / "pair.svg").size(), 1000U);
  const Outcome moved = run("simulate pair.yaml --seconds 0.2");
  EXPECT_EQ(moved.exit_code, 0) << moved.err;
  const Outcome repaired = run("inspect pair.yaml --repair repaired.urdf");
  EXPECT_EQ(repaired.exit_code, 1);
  EXPECT_NE(repaired.err.find("repair each robot's URDF by itself"), std::string::npos);
}

TEST_F(SeveralRobots, FilesInTheWrongOrderAreExplained) {
  write("one.yaml", "operational_points: [{name: tip, link: tool}]\n");
  const Outcome alone = run("generate one.yaml");
  EXPECT_EQ(alone.exit_code, 1);
  EXPECT_NE(alone.err.find("it lists no robots"), std::string::npos) << alone.err;
  const Outcome both = run("generate arms/planar3r.urdf pair.yaml");
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_NE(both.err.find("name the scene alone"), std::string::npos) << both.err;
  const Outcome twice = run("generate pair.yaml one.yaml");
  EXPECT_EQ(twice.exit_code, 1);
  EXPECT_NE(twice.err.find("name that scene alone"), std::string::npos) << twice.err;
}

}  // namespace
}  // namespace treeline
