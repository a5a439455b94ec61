#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "program_test.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::read_file;

std::string robot_file(const std::string& name) {
  return TREELINE_ROBOTS "/" + name;
}

const std::string kUrdf = robot_file("puma560/puma560.urdf");
const std::string kScene = robot_file("puma560/scene.yaml");

class GenerateTest : public test::OwnFolder {
 protected:
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return test::run_program(root_, "generate " + arguments);
  }
  [[nodiscard]] Outcome generate() const { return run(kUrdf + " " + kScene + " --output puma560"); }
};

// Would catch: a command that does nothing, or prints messages where data belongs.
TEST_F(GenerateTest, WritesTheFolder) {
  const Outcome outcome = generate();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("inverse_dynamics"), std::string::npos);
  EXPECT_TRUE(fs::exists(root_ / "puma560" / "puma560.hpp"));
  EXPECT_TRUE(fs::exists(root_ / "puma560" / "control_torque.cpp"));
}

// Would catch: output that depends on the place of the files or on the working directory.
TEST_F(GenerateTest, SameBytesFromAnywhere) {
  ASSERT_EQ(generate().exit_code, 0);
  fs::create_directories(root_ / "elsewhere");
  fs::copy_file(kUrdf, root_ / "elsewhere" / "puma560.urdf");
  fs::copy_file(kScene, root_ / "elsewhere" / "scene.yaml");
  const Outcome again = run("elsewhere/puma560.urdf ./elsewhere/scene.yaml -o '" +
                            (root_ / "elsewhere" / "puma560").string() + "/'");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  for (const auto& entry : fs::directory_iterator(root_ / "puma560")) {
    const fs::path other = root_ / "elsewhere" / "puma560" / entry.path().filename();
    EXPECT_EQ(read_file(entry.path()), read_file(other)) << other;
  }
}

/// Text without comments and strings.
std::string code_of(const std::string& text) {
  static const std::regex other(R"(//[^\n]*|/\*[^*]*(\*[^/][^*]*)*\*/|"(\\.|[^"\\\n])*")");
  return std::regex_replace(text, other, "");
}

// Would catch: names of the file that end a comment or a string, so that what is behind them is
// compiled, in any file that a scene can ask for.
TEST_F(GenerateTest, NamesAreNeverCode) {
  std::string urdf = read_file(kUrdf);
  for (const char* name : {"puma560", "joint2", "link3", "tool"}) {
    urdf = std::regex_replace(urdf, std::regex(std::string("\"") + name + "\""),
                              "\"odd */ evil; /* &quot; evil; \\ " + std::string(name) + "\"");
  }
  std::ofstream(root_ / "odd.urdf") << std::regex_replace(
      urdf, std::regex("</robot>"),
      "<link name=\"a\"><collision><geometry><sphere radius=\"1\"/></geometry></collision></link>"
      "<joint name=\"b\" type=\"fixed\"><parent link=\"link6\"/><child "
      "link=\"a\"/></joint></robot>");
  const std::string common =
      R"(operational_points: [{name: tip, link: 'odd */ evil; /* " evil; \ tool', rows: [x, y]}])"
      "\nname: odd\nbatch: 2\n";
  std::ofstream(root_ / "stepped.yaml")
      << common << "selftest: 1\nground: {step: true}\ndamped: {mass: 40, inertia: 4}\n"
      << "functions: [jacobian, bias_acceleration, inverse_dynamics, lambda_inverse]\n"
      << "controller: {laws: [joint_impedance, task_impedance, force]}\n";
  std::ofstream(root_ / "limited.yaml")
      << common << "torque_limits: urdf\n"
      << "constraints: [{name: wall, between: [link5, world], rows: [x]}]\n"
      << "functions: [mass_matrix, jacobian, supported_control_torque, constraint_jacobian]\n";
  for (const char* options : {"stepped.yaml --language c", "stepped.yaml --language c++",
                              "limited.yaml --language c", "limited.yaml --language c++"}) {
    const Outcome made = run("odd.urdf -o odd " + std::string(options));
    ASSERT_EQ(made.exit_code, 0) << made.err;
    for (const auto& entry : fs::directory_iterator(root_ / "odd")) {
      if (entry.path().extension() == ".json" || entry.path().extension() == ".txt") continue;
      EXPECT_EQ(code_of(read_file(entry.path())).find("evil"), std::string::npos) << entry;
    }
    fs::remove_all(root_ / "odd");
  }
}

// Would catch: a build that compiles files which are not there, or leaves some out.
TEST_F(GenerateTest, ListsTheSourcesThatItWrites) {
  const std::string point = "operational_points: [{name: tool, link: tool}]\n";
  const std::string few = "functions: [gravity, mass_matrix, jacobian, control_torque]\n";
  const std::pair<const char*, std::string> scenes[] = {
      {"", "functions: [gravity]\n"},
      {"--language c", point + few + "batch: 4\n"},
      {"--profile misra", "functions: [gravity]\n"},
      {"--name math", "functions: [gravity]\n"},
      {"--language c",
       point + "constraints: [{name: wall, between: [tool, world], rows: [x]}]\nbatch: 2\n"
               "torque_limits: urdf\nfunctions: [mass_matrix, jacobian, supported_control_torque, "
               "constraint_jacobian]\n"},
      {"", point + few + "controller: {laws: [joint_impedance, task_impedance, force]}\n"}};
  int folder = 0;
  for (const auto& [options, scene] : scenes) {
    std::ofstream(root_ / "scene.yaml") << scene;
    const std::string inputs = kUrdf + " scene.yaml " + options;
    const Outcome listed = run(inputs + " --list-sources");
    ASSERT_EQ(listed.exit_code, 0) << listed.err;
    EXPECT_EQ(listed.err, "");
    const fs::path output = root_ / ("out_" + std::to_string(folder++));
    const Outcome made = run(inputs + " --output " + output.string());
    ASSERT_EQ(made.exit_code, 0) << made.err;
    std::multiset<std::string> written, predicted;
    for (const auto& entry : fs::directory_iterator(output)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".cpp" || extension == ".c") written.insert(entry.path().stem());
    }
    std::istringstream lines(listed.out);
    for (std::string line; std::getline(lines, line);) predicted.insert(line);
    EXPECT_EQ(predicted, written) << scene;
  }
}

// Would catch: a manifest that JSON readers do not accept, or that omits a file.
TEST_F(GenerateTest, ManifestListsTheFolder) {
  ASSERT_EQ(generate().exit_code, 0);
  const YAML::Node manifest = YAML::LoadFile(root_ / "puma560" / "manifest.json");
  std::set<std::string> listed;
  for (const YAML::Node& file : manifest["files"]) {
    listed.insert(file.as<std::string>());
  }
  std::set<std::string> present;
  for (const auto& entry : fs::directory_iterator(root_ / "puma560")) {
    present.insert(entry.path().filename());
  }
  EXPECT_EQ(listed, present);
  EXPECT_EQ(manifest["real"].as<std::string>(), "double");
  EXPECT_EQ(manifest["coordinates"].as<int>(), 6);
  EXPECT_EQ(manifest["inputs"][0]["sha256"].as<std::string>().size(), 64u);
}

// Would catch: stale output that passes, and fresh output that does not.
TEST_F(GenerateTest, CompareTellsStaleFromFresh) {
  const std::string compare = kUrdf + " " + kScene + " --output puma560 --compare";
  EXPECT_EQ(run(compare).exit_code, 3);
  EXPECT_FALSE(fs::exists(root_ / "puma560"));
  ASSERT_EQ(generate().exit_code, 0);
  EXPECT_EQ(run(compare).exit_code, 0);
  std::ofstream(root_ / "puma560" / "gravity.cpp", std::ios::app) << "\n";
  const Outcome stale = run(compare + " --json");
  EXPECT_EQ(stale.exit_code, 3);
  const YAML::Node summary = YAML::Load(stale.out);
  ASSERT_EQ(summary["differences"].size(), 1u);
  EXPECT_EQ(summary["differences"][0]["file"].as<std::string>(), "gravity.cpp");
}

// Would catch: options that have no effect, or that the contract does not mention.
TEST_F(GenerateTest, OptionsOverruleTheScene) {
  const Outcome outcome =
      run(kUrdf + " " + kScene +
          " --output small --name small --real float --functions gravity,jacobian");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string contract = read_file(root_ / "small" / "small.hpp");
  EXPECT_NE(contract.find("using Real = float;"), std::string::npos);
  EXPECT_NE(contract.find("--name small --real float --functions gravity,jacobian"),
            std::string::npos);
  EXPECT_TRUE(fs::exists(root_ / "small" / "jacobian.cpp"));
  EXPECT_FALSE(fs::exists(root_ / "small" / "mass_matrix.cpp"));
}

// Would catch: a language that has no effect, that the folder cannot be regenerated with, and the
// other language's files left beside it.
TEST_F(GenerateTest, WritesC) {
  const std::string inputs = kUrdf + " " + kScene + " --output arm --name arm --functions gravity";
  ASSERT_EQ(run(inputs).exit_code, 0);
  const Outcome outcome = run(inputs + " --language c");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(root_ / "arm" / "gravity.c"));
  EXPECT_FALSE(fs::exists(root_ / "arm" / "gravity.cpp"));
  EXPECT_NE(read_file(root_ / "arm" / "arm.h").find("--name arm --language c --functions gravity"),
            std::string::npos);
}

// Would catch: a controller alone that needs functions, files in C++ among those in C, a list of
// files to compile that is not what there is.
TEST_F(GenerateTest, WritesAControllerAloneInC) {
  std::ofstream(root_ / "alone.yaml")
      << "{name: arm, language: c, functions: [], controller: {laws: [joint_impedance]}}";
  const Outcome outcome = run(kUrdf + " alone.yaml --output arm");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::set<std::string> sources;
  for (const auto& file : fs::directory_iterator(root_ / "arm")) {
    EXPECT_FALSE(file.path().string().ends_with("pp")) << file.path();
    if (file.path().extension() == ".c") sources.insert(file.path().filename());
  }
  EXPECT_EQ(sources, (std::set<std::string>{"controller.c", "controller_joint_torque.c",
                                            "controller_kinematics.c", "id.c"}));
  const std::string header = read_file(root_ / "arm" / "arm_controller.h");
  EXPECT_NE(header.find("as C99: controller.c, controller_kinematics.c,"), std::string::npos);
}

// Would catch: a dump that is empty, or that also writes files.
TEST_F(GenerateTest, DumpsTheGraphs) {
  const Outcome text = run(kUrdf + " " + kScene + " --functions gravity --dump text");
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_EQ(text.out.rfind("; gravity:", 0), 0u);
  const Outcome dot = run(kUrdf + " " + kScene + " --functions gravity --dump dot");
  EXPECT_EQ(dot.out.rfind("digraph gravity {", 0), 0u);
  const Outcome folder = run(kUrdf + " " + kScene + " --dump text -o out");
  EXPECT_EQ(folder.exit_code, 2);
  EXPECT_NE(folder.err.find("--output does not go with --dump"), std::string::npos) << folder.err;
}

// Would catch: a folder called `=out`.
TEST_F(GenerateTest, ShortOptionsHaveNoEqualsSign) {
  const Outcome outcome = run(kUrdf + " " + kScene + " -o=out");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("write -o out, or --output=out"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(root_ / "=out"));
}

// Would catch: a wrong exit code, a missing message, or half a folder after bad input.
TEST_F(GenerateTest, BadInputIsOne) {
  for (const std::string& arguments :
       {"none.urdf " + kScene + " -o out", kUrdf + " none.yaml -o out",
        kUrdf + " " + kScene + " -o out --functions gravty",
        kUrdf + " " + kScene + " -o out --name 'my robot'",
        kUrdf + " " + kScene + " -o out --name gravity"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 1) << arguments;
    EXPECT_NE(outcome.err.find("error:"), std::string::npos) << arguments << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_FALSE(fs::exists(root_ / "out")) << arguments;
  }
}

// Would catch: functions that a scene may list but the command line may not.
TEST_F(GenerateTest, EveryFunctionCanBeNamed) {
  const Outcome outcome =
      run(robot_file("tumbler/tumbler.urdf") + " " + robot_file("tumbler/scene.yaml") +
          " --output out --functions contact_motion,link_inverse_inertias");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(root_ / "out" / "contact_motion.cpp"));
  EXPECT_TRUE(fs::exists(root_ / "out" / "link_inverse_inertias.cpp"));
}

// Would catch: functions of the command line that are not checked like those of a scene. Here
// damped_control_torque would call functions that do not exist.
TEST_F(GenerateTest, FunctionsNamedAreCheckedWithTheScene) {
  const Outcome outcome = run(robot_file("ur10e/ur10e.urdf") + " " +
                              robot_file("ur10e/scene.yaml") + " -o out --functions gravity");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("damped needs jacobian"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(root_ / "out"));
}

/// Generates a few functions of the PUMA's scene, with the choices of a file.
std::string generate_by(const std::string& choices, const std::string& output) {
  return kUrdf + " " + kScene + " --functions gravity,forward_dynamics --choices " + choices +
         " --output " + output;
}

// Would catch: a recorded choice that is read and not obeyed, or that the next manifest forgets;
// one of earlier versions, which named routes in words, that is not understood.
TEST_F(GenerateTest, ObeysRecordedChoices) {
  std::ofstream(root_ / "mine.json")
      << R"({"choices": [{"function": "forward_dynamics", "chosen": )"
         R"({"method": "articulated bodies, Chang table 4.2", "lanes": 2}}]})";
  ASSERT_EQ(run(generate_by("mine.json", "first")).exit_code, 0);
  const YAML::Node manifest = YAML::LoadFile(root_ / "first" / "manifest.json");
  EXPECT_EQ(manifest["choices"][1]["function"].as<std::string>(), "forward_dynamics");
  const YAML::Node chosen = manifest["choices"][1]["chosen"];
  EXPECT_EQ(chosen["method"].as<std::string>(), "articulated bodies, Chang table 4.2");
  EXPECT_EQ(chosen["route"].as<std::string>(), "aba");
  EXPECT_EQ(chosen["lanes"].as<int>(), 2);
  // The manifest leads to the same folder again, and its code differs from the choice by cost.
  EXPECT_EQ(run(generate_by("first/manifest.json", "first") + " --compare").exit_code, 0);
  ASSERT_EQ(generate().exit_code, 0);
  EXPECT_NE(read_file(root_ / "first" / "forward_dynamics.cpp"),
            read_file(root_ / "puma560" / "forward_dynamics.cpp"));
}

// Would catch: a choice that is impossible and is dropped without a message.
TEST_F(GenerateTest, ChoicesThatCannotBeMadeAreBadInput) {
  for (const std::string text :
       {R"({"choices": [{"function": "gravity", "chosen": {"method": "by magic"}}]})",
        R"({"choices": [{"function": "gravty", "chosen": {"method": "by magic"}}]})",
        R"({"choices": [{"function": "gravity", "chosen": {"method": "x", "lanes": 3}}]})",
        R"({"choices": [{"function": "batch_gravity", "chosen": {"method": "x", "lanes": 2}}]})",
        R"({"choices": 3})", R"([])", "no JSON"}) {
    std::ofstream(root_ / "mine.json") << text;
    const Outcome outcome = run(generate_by("mine.json", "out"));
    EXPECT_EQ(outcome.exit_code, 1) << text;
    EXPECT_NE(outcome.err.find("error:"), std::string::npos) << text << outcome.err;
    EXPECT_FALSE(fs::exists(root_ / "out")) << text;
  }
  EXPECT_EQ(run(generate_by("none.json", "out")).exit_code, 1);
}

// Would catch: choices of another robot that are taken without a word; some that are written by
// hand, without a robot's name, that are refused.
TEST_F(GenerateTest, ChoicesOfAnotherRobotAreBadInput) {
  const std::string choices =
      R"("choices": [{"function": "forward_dynamics", "chosen": {"route": "aba"}}]})";
  std::ofstream(root_ / "other.json") << R"({"robot": "ur10e", )" + choices;
  const Outcome other = run(generate_by("other.json", "out"));
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find("for the robot \"ur10e\", not for \"puma560\""), std::string::npos)
      << other.err;
  EXPECT_FALSE(fs::exists(root_ / "out"));
  std::ofstream(root_ / "mine.json") << "{" + choices;
  EXPECT_EQ(run(generate_by("mine.json", "out")).exit_code, 0);
}

// Would catch: a choice for batches, or the description of the measurement, that the next manifest
// omits.
TEST_F(GenerateTest, ObeysChoicesForBatches) {
  std::ofstream scene(root_ / "scene.yaml");
  scene << read_file(kScene) << "\nbatch: 8\n";
  scene.close();
  std::ofstream(root_ / "mine.json")
      << R"({"measured": "by hand", "choices": [{"function": "batch_forward_dynamics", "chosen": )"
         R"({"route": "aba"}}]})";
  const std::string command = kUrdf + " scene.yaml --functions forward_dynamics --output first";
  ASSERT_EQ(run(command + " --choices mine.json").exit_code, 0);
  const YAML::Node manifest = YAML::LoadFile(root_ / "first" / "manifest.json");
  EXPECT_EQ(manifest["measured"].as<std::string>(), "by hand");
  EXPECT_EQ(manifest["choices"][1]["function"].as<std::string>(), "batch_forward_dynamics");
  EXPECT_EQ(manifest["choices"][1]["chosen"]["method"].as<std::string>(),
            "articulated bodies, Chang table 4.2");
  EXPECT_NE(manifest["choices"][0]["chosen"]["method"].as<std::string>(),
            "articulated bodies, Chang table 4.2");
  EXPECT_EQ(run(command + " --choices first/manifest.json --compare").exit_code, 0);
}

// Would catch: a tuned folder that its own manifest does not reproduce, and a table that is not
// valid data.
TEST_F(GenerateTest, TunedFolderIsReproducible) {
  const std::string command = kUrdf + " " + kScene + " --functions gravity --output puma560 ";
  const Outcome tuned = run(command + "--tune --flags=-O1 --json");
  ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
  const YAML::Node summary = YAML::Load(tuned.out);
  EXPECT_EQ(summary["tuning"][0]["function"].as<std::string>(), "gravity");
  EXPECT_NE(summary["measured"].as<std::string>().find("-O1"), std::string::npos);
  EXPECT_EQ(run(command + "--choices puma560/manifest.json --compare").exit_code, 0);
  EXPECT_EQ(run(command + "--tune --compare").exit_code, 2);
  EXPECT_EQ(run(command + "--flags=-O1").exit_code, 2);
}

// Would catch: a message that does not say what could have been chosen.
TEST_F(GenerateTest, UnknownRouteIsToldWithThoseThereAre) {
  std::ofstream(root_ / "mine.json")
      << R"({"choices": [{"function": "forward_dynamics", "chosen": {"method": "by magic"}}]})";
  const Outcome outcome = run(generate_by("mine.json", "out"));
  EXPECT_NE(outcome.err.find("`by magic` in 8 lanes"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("`ltdl`, `aba`"), std::string::npos) << outcome.err;
}

// Would catch: a robot that is held, without operational points and passive joints, whose torques
// nothing judges: the trial before writing then read sizes that there were not.
TEST_F(GenerateTest, AHandThatHoldsARailNeedsNoPointAndNoPassiveJoint) {
  std::ofstream(root_ / "held.yaml")
      << "constraints: [{name: rail, between: [tool, world], rows: [x, y, z]}]\n"
         "functions: [supported_control_torque]\n";
  const Outcome outcome = run(kUrdf + " held.yaml --output held");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(test::run_program(root_, "check " + kUrdf + " held.yaml --states 100").exit_code, 0);
}

TEST_F(GenerateTest, BadUsageIsTwo) {
  for (const std::string& arguments :
       {std::string(), kUrdf + " " + kScene + " third.yaml",
        kUrdf + " " + kScene + " -o out --real half", kUrdf + " " + kScene + " -o out --unknown",
        kUrdf + " " + kScene + " -o out --language fortran"}) {
    EXPECT_EQ(run(arguments).exit_code, 2) << arguments;
  }
  EXPECT_EQ(run("--help").exit_code, 0);
  EXPECT_NE(run("--help").out.find("Examples:"), std::string::npos);
}

}  // namespace
}  // namespace treeline
