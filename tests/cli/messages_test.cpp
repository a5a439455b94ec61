// Would catch: error messages from which a user cannot tell what to do. Each situation is one in
// which first users of the program did not get the help that they needed.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../own_environment.hpp"
#include "program_test.hpp"
#include "run_on_terminal.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;

constexpr const char* kArm = R"(<robot name="arm">
  <link name="base"/>
  <joint name="elbow_joint" type="revolute"><parent link="base"/><child link="forearm"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <link name="forearm"><inertial><origin xyz="0.2 0 0"/><mass value="1"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
  <joint name="mount" type="fixed"><parent link="forearm"/><child link="gripper"/></joint>
  <link name="gripper"/>
</robot>
)";

class MessagesTest : public test::ProgramTest {
 protected:
  MessagesTest() {
    write("arm.urdf", kArm);
    write("empty.yaml", "");
  }

  /// The messages of a run that ends so.
  [[nodiscard]] std::string messages(const std::string& arguments, int exit_code) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << arguments << "\n" << outcome.err;
    return outcome.err;
  }
  /// Messages about a scene that is refused.
  [[nodiscard]] std::string refused(const std::string& scene) const {
    write("scene.yaml", scene);
    return messages("generate arm.urdf scene.yaml -o out", 1);
  }
};

void expect_parts(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
  }
}

TEST_F(MessagesTest, UnknownCommandGetsTheNearest) {
  expect_parts(messages("inspct arm.urdf", 2),
               {"treeline: error: there is no command \"inspct\"", "did you mean \"inspect\"?"});
  expect_parts(messages("frobnicate", 2), {"the commands are generate, check,"});
  expect_parts(messages("", 2), {"no command is given", "generate", "treeline help"});
  expect_parts(messages("help inspct", 2), {"did you mean \"inspect\"?"});
}

TEST_F(MessagesTest, HelpAndVersion) {
  const Outcome version = run("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out, "treeline " TREELINE_PROJECT_VERSION "\n");
  for (const char* arguments : {"help generate", "generate --help"}) {
    const Outcome help = run(arguments);
    EXPECT_EQ(help.exit_code, 0) << arguments;
    expect_parts(help.out, {"--output", "Examples:"});
  }
  EXPECT_EQ(run("version").out, version.out);
  EXPECT_EQ(run("help help").out, run("--help").out);
  EXPECT_EQ(run("help").out, run("--help").out);
  EXPECT_EQ(run("help").exit_code, 0);
}

// Would catch: parts that a program cannot tell apart, as of a fault with a colon in it, and
// remedies that the text tells once for several faults.
TEST_F(MessagesTest, ProgramsReadJson) {
  test::OwnEnvironment environment;
  write("scene.yaml", "real: half\nlanes: many\n");
  const std::string text = messages("generate arm.urdf scene.yaml -o out", 1);
  environment.set("TREELINE_MESSAGES", "json");
  std::istringstream lines(messages("generate arm.urdf scene.yaml -o out", 1));
  int errors = 0;
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json told = nlohmann::json::parse(line);
    if (told["severity"] != "error") continue;
    ++errors;
    EXPECT_EQ(told["file"], "scene.yaml");
    EXPECT_EQ(told["line"], errors);
    EXPECT_EQ(told["element"], errors == 1 ? "real" : "lanes");
    const std::string fault = told["fault"];
    expect_parts(text, {fault.c_str(), told["remedy"].get<std::string>().c_str()});
    expect_parts(told["text"], {"scene.yaml:", "error: ", fault.c_str()});
  }
  EXPECT_EQ(errors, 2);
}

TEST_F(MessagesTest, UnknownOptionsGetTheNearest) {
  expect_parts(messages("generate arm.urdf empty.yaml --outpt out", 2),
               {"there is no option --outpt", "did you mean \"--output\"?"});
  expect_parts(messages("generate --outpt=out", 2), {"did you mean \"--output\"?"});
  expect_parts(messages("inspect arm.urdf empty.yaml third", 2),
               {"\"third\" is one argument too many", "write treeline inspect urdf [scene]"});
  expect_parts(messages("inspect", 2), {"urdf is missing", "write treeline inspect urdf [scene]"});
}

// Would catch: text of the option parser, `Check rk5 value in {adaptive->2,euler->0,...} FAILED`.
TEST_F(MessagesTest, ValuesOutOfRangeGetWords) {
  const std::string integrator = messages("simulate arm.urdf --integrator rk5", 2);
  expect_parts(integrator, {"--integrator: \"rk5\" is not known here", "did you mean \"rk4\"?",
                            "the choices are euler, rk4, adaptive"});
  EXPECT_EQ(integrator.find("->"), std::string::npos) << integrator;
  const std::string real = messages("generate arm.urdf empty.yaml -o out --real half", 2);
  expect_parts(real, {"\"half\" is not known here", "the choices are float, double"});
  const std::string states = messages("check arm.urdf empty.yaml --states 0", 2);
  expect_parts(states, {"\"0\" is not a whole number from 1 to 1000000"});
  expect_parts(messages("check arm.urdf empty.yaml --seed -1", 2),
               {"\"-1\" is not a whole number"});
  expect_parts(messages("simulate arm.urdf --seconds nan", 2),
               {"\"nan\" is not a number from 1e-06 to 1e+06"});
  expect_parts(messages("simulate arm.urdf --q 0,up", 2), {"\"up\" is not a number"});
  for (const char* tolerance : {"-1", "nan", "x"}) {
    expect_parts(messages("diff arm.urdf arm.urdf --tolerance " + std::string(tolerance), 2),
                 {"is not a number from 0 to 1e+12"});
  }
  for (const char* command : {"diff arm.urdf arm.urdf", "init-scene arm.urdf"}) {
    expect_parts(messages(command + std::string(" --base Fixed"), 2), {"did you mean \"fixed\"?"});
  }
  expect_parts(messages("inspect arm.urdf --warnings all --warnings none", 2),
               {"--warnings: it is given 2 times, and once is enough"});
  for (const char* both : {"--dot --json", "--dot --summary", "--savings --noise",
                           "--base-parameters --dot", "--noise --repair out.urdf"}) {
    expect_parts(messages(std::string("inspect arm.urdf ") + both, 2), {"does not go with"});
  }
  expect_parts(messages("inspect arm.urdf --warnings loud", 2),
               {"the choices are all, summary, none"});
}

TEST_F(MessagesTest, UnknownLinksAndJointsGetTheTree) {
  expect_parts(refused("operational_points:\n- {name: tool, link: tool}\n"),
               {"scene.yaml:2: error: operational_points[0]/link: the robot has no link \"tool\"",
                "\n  its links are, each below the one that carries it:", "\n    base\n",
                "\n      forearm\n", "\n        gripper\n"});
  expect_parts(refused("locked: {elbow: 0.1}\n"), {"did you mean \"elbow_joint\"?"});
  expect_parts(refused("locked: {finger_joint: 0}\n"), {"its joints that move are elbow_joint"});
}

TEST_F(MessagesTest, UnknownKeysAndFunctionsGetTheList) {
  for (const char* key : {"colour", "motors"}) {
    expect_parts(refused(std::string(key) + ": 1\n"),
                 {"is unknown", "the keys here are name, base, gravity,", "operational_points"});
  }
  expect_parts(refused("friction: viscous\n"), {"joint_friction: viscous or coulomb counts"});
  expect_parts(refused("tool: hand\n"), {"operational_points: [{name: tool, link: LINK}]"});
  expect_parts(refused("functions: [hessian_tensor]\n"),
               {"the functions are forward_kinematics,", "mass_matrix"});
  expect_parts(refused("functions: [gravity_vector]\n"), {"did you mean \"gravity\"?"});
  expect_parts(refused("functions: all\n"), {"leave out functions for all that the scene permits"});
  expect_parts(messages("generate arm.urdf empty.yaml -o out --functions all", 1),
               {"leave out functions for all"});
  expect_parts(messages("generate arm.urdf empty.yaml -o out --functions masmatrix", 1),
               {"did you mean \"mass_matrix\"?"});
  // A file behind the list is not one of it, and blanks in a list do not count.
  EXPECT_EQ(messages("generate --functions 'gravity, mass_matrix' arm.urdf empty.yaml -o out", 0),
            "");
  expect_parts(refused("batch: 3\n"), {"the choices are 2, 4, 8, 16"});
  expect_parts(refused("operational_points:\n- {name: t, link: forearm, origin: [0, 0, 0.1]}\n"),
               {"operational_points[0]/origin", "xyz", "rpy"});
}

// Would catch: a scene that is called broken XML where a robot is expected.
TEST_F(MessagesTest, ASceneIsNoRobot) {
  write("scene.yaml", "base: fixed\n");
  write("robots.yaml", "robots: [{name: left, urdf: arm.urdf}]\n");
  for (const char* arguments :
       {"init-scene scene.yaml", "convert scene.yaml", "diff arm.urdf scene.yaml"}) {
    expect_parts(messages(arguments, 1), {"scene.yaml: error: this is a scene, not a robot",
                                          "as their second argument, behind the robot"});
  }
  expect_parts(messages("init-scene robots.yaml", 1),
               {"robots.yaml: error: this is a scene, not a robot", "in place of one"});
}

// Would catch: a file in another encoding that is called broken.
TEST_F(MessagesTest, EncodingsAreNamed) {
  using namespace std::string_literals;
  write("packed.urdf.gz", "\x1f\x8b\x08\x00\x00"s);
  write("marked.urdf", "\xff\xfe<\0r\0"s);
  write("bare.urdf", "<\0r\0o\0"s);
  write("scene.yaml", "\xfe\xff\0b\0a"s);
  expect_parts(messages("inspect packed.urdf.gz", 1), {"compressed by gzip", "gunzip"});
  expect_parts(messages("inspect - <packed.urdf.gz", 1),
               {"standard input: error: the file is compressed by gzip"});
  for (const char* file : {"marked.urdf", "bare.urdf", "arm.urdf scene.yaml"}) {
    expect_parts(messages("inspect "s + file, 1), {"the file is UTF-16 text", "UTF-8"});
  }
}

// Would catch: limits that nobody has filled in and nobody is told of; a joint that the scene locks
// anyway, or one that moves, among them.
TEST_F(MessagesTest, InspectNamesLimitsThatPermitNoMotion) {
  EXPECT_EQ(messages("inspect arm.urdf", 0), "");
  const auto with_limits = [this](const std::string& limits) {
    std::string text = kArm;
    const std::string old = R"(lower="-1" upper="1" effort="1" velocity="1")";
    write("limited.urdf", text.replace(text.find(old), old.size(), limits));
  };
  with_limits(R"(lower="0" upper="0" effort="1" velocity="1")");
  expect_parts(messages("inspect limited.urdf", 0),
               {"limited.urdf:4: warning: joint[elbow_joint]/limit",
                "lower and upper are both 0: a placeholder"});
  with_limits(R"(lower="-1" upper="1" effort="1" velocity="0")");
  expect_parts(messages("inspect limited.urdf", 0),
               {"limited.urdf:4: warning: joint[elbow_joint]/limit", "velocity=0: a placeholder"});
  write("locked.yaml", "base: floating\nlocked: {elbow_joint: 0}\n");
  EXPECT_EQ(messages("inspect limited.urdf locked.yaml", 0).find("velocity=0"), std::string::npos);
}

// Would catch: the JSON library's own text.
TEST_F(MessagesTest, ChoicesThatAreNoManifest) {
  write("choices.json", "{}");
  const std::string generate = "generate arm.urdf empty.yaml -o out --choices ";
  expect_parts(messages(generate + "choices.json", 1),
               {"choices.json: error: choices: there is no list of rows", "manifest.json"});
  expect_parts(messages(generate + "arm.urdf", 1), {"arm.urdf: error: choices: this is not JSON"});
}

TEST_F(MessagesTest, XmlNamesTheOpenElement) {
  write("b.urdf", "<robot name='b'>\n<link name='a'>\n");
  expect_parts(messages("inspect b.urdf", 1),
               {"b.urdf:2: error: <link> is not closed: <link name=\"a\"> is open since line 2"});
}

/// The arm as exporters write it, with 6 attributes, 2 elements and a limit that no equation uses,
/// and an inertia that no body can have.
std::string exported_arm() {
  std::string text = kArm;
  const auto replace = [&text](const std::string& what, const std::string& by) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
      text.replace(at, what.size(), by);
    }
  };
  replace("<link name=", "<link rgba='1' name=");
  replace("<joint name=", "<joint tag='1' name=");
  replace("<axis", "<note/><limb/><axis");
  replace(" velocity=\"1\"", "");
  replace("izz=\"0.1\"", "izz=\"9\"");
  return text;
}

TEST_F(MessagesTest, FaultsOfFormAreOneLineAndBrokenInertiasLast) {
  write("exported.urdf", exported_arm());
  const std::string told = messages("inspect exported.urdf", 0);
  expect_parts(
      told,
      {"exported.urdf: warning: without effect here: 5 unknown attributes (\"rgba\", \"tag\"), "
       "2 unknown elements (<note>, <limb>); --warnings all lists them\n",
       "exported.urdf: warning: 1 limit is missing and counts as none; --warnings all lists "
       "them\n"});
  const auto inertia = told.find("no body has this inertia");
  ASSERT_NE(inertia, std::string::npos) << told;
  EXPECT_EQ(told.find("warning:", inertia), std::string::npos) << "it stands last\n" << told;
  const std::string all = messages("inspect exported.urdf --warnings all", 0);
  expect_parts(all, {"\"rgba\"", "\"tag\"", "<note>", "<limb>", "\"velocity\"", "no body has"});
  EXPECT_EQ(all.find("without effect"), std::string::npos) << all;
  EXPECT_EQ(messages("inspect exported.urdf --warnings none", 0), "");
  expect_parts(messages("generate exported.urdf --warnings none -o out nowhere.yaml", 1),
               {"nowhere.yaml: error:"});
}

// Would catch: a number of another format that is counted among what has no effect.
TEST_F(MessagesTest, NumbersThatNobodyReadsAreTold) {
  std::string text = kArm;
  const std::string origin = "<origin xyz=\"0.2 0 0\"/>";
  text.replace(text.find(origin), origin.size(), "<origin pos=\"0.2 0 0\"/>");
  write("other.urdf", text);
  expect_parts(messages("inspect other.urdf", 0),
               {"other.urdf:5: warning: robot/link[forearm]/inertial/origin: the attribute \"pos\" "
                "is not part of URDF"});
}

TEST_F(MessagesTest, ColoursOnATerminalOnly) {
  const std::string arguments = "inspect " + (root_ / "nowhere.urdf").string();
  const std::string escape = "\033[";
  EXPECT_NE(test::run_on_terminal("", arguments).find(escape), std::string::npos);
  EXPECT_EQ(test::run_on_terminal("NO_COLOR=1", arguments).find(escape), std::string::npos);
  EXPECT_EQ(test::run_on_terminal("TERM=dumb", arguments).find(escape), std::string::npos);
  EXPECT_EQ(run(arguments).err.find(escape), std::string::npos);
}

// Would catch: tables that a terminal breaks in the midst of words, and a table for a program that
// is folded.
TEST_F(MessagesTest, TablesFitTheTerminal) {
  const auto widest = [this](const std::string& text) {
    std::size_t most = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with(root_.string())) most = std::max(most, line.size());
    }
    return most;
  };
  const std::string folder = "'" + root_.string() + "'";
  const std::string arguments = "generate " + folder +
                                "/arm.urdf --functions forward_dynamics -o " + folder +
                                "/out --warnings none";
  EXPECT_GT(widest(run(arguments).out), 110U);
  const std::string shown = test::run_on_terminal("", arguments, 70);
  EXPECT_LE(widest(shown), 71U) << shown;  // a carriage return ends lines
  expect_parts(shown, {"forward_dynamics", "method"});
}

// Would catch: deleted files that are counted as written.
TEST_F(MessagesTest, CountsTheFilesThatAreThere) {
  const auto count = [&] {
    return std::distance(fs::directory_iterator(root_ / "out"), fs::directory_iterator());
  };
  const Outcome first = run("generate arm.urdf empty.yaml -o out");
  EXPECT_EQ(first.exit_code, 0) << first.err;
  const auto all = count();
  expect_parts(first.out, {("out: " + std::to_string(all) + " files written\n").c_str()});
  const Outcome fewer = run("generate arm.urdf empty.yaml -o out --functions gravity");
  EXPECT_EQ(fewer.exit_code, 0) << fewer.err;
  const auto left = count();
  EXPECT_LT(left, all);
  expect_parts(fewer.out, {("out: " + std::to_string(left) + " files, ").c_str(),
                           (std::to_string(all - left) + " of an earlier run removed").c_str()});
  expect_parts(run("generate arm.urdf empty.yaml -o out --functions gravity").out,
               {("out: " + std::to_string(left) + " files, none changed").c_str()});
}

TEST_F(MessagesTest, DashIsStandardInput) {
  const Outcome inspected = run("inspect - <arm.urdf");
  EXPECT_EQ(inspected.exit_code, 0) << inspected.err;
  expect_parts(inspected.out, {"arm (standard input)"});
  EXPECT_EQ(run("generate - empty.yaml -o piped --functions gravity <arm.urdf").exit_code, 0);
  EXPECT_EQ(run("generate arm.urdf - -o out --functions gravity <empty.yaml").exit_code, 0);
  EXPECT_EQ(run("generate arm.urdf empty.yaml -o named --functions gravity").exit_code, 0);
  for (const char* folder : {"piped", "out"}) {
    EXPECT_EQ(test::read_file(root_ / folder / "gravity.cpp"),
              test::read_file(root_ / "named" / "gravity.cpp"));
  }
  write("bad.yaml", "gravty: 1\n");
  expect_parts(messages("generate arm.urdf - -o out <bad.yaml", 1),
               {"standard input:1: error: gravty"});
  expect_parts(messages("generate - - -o out <arm.urdf", 1), {"both"});
  expect_parts(messages("inspect ''", 1), {"the name of a file to read is empty"});
}

// Would catch: a compiler command of several words that is taken for one program.
TEST_F(MessagesTest, CompilerMayHaveALauncher) {
  const std::string check = "check arm.urdf empty.yaml --functions gravity --states 3 --json";
  test::OwnEnvironment environment;
  environment.set("CXX", "env g++");
  const Outcome launched = run(check);
  environment.set("CXX", "no-such-launcher g++");
  const std::string missing = messages(check, 1);
  EXPECT_EQ(launched.exit_code, 0) << launched.err << launched.out;
  const auto report = nlohmann::json::parse(launched.out);
  EXPECT_EQ(report["compile"]["command"].get<std::string>().rfind("env g++ ", 0), 0U);
  expect_parts(missing, {"no-such-launcher g++", "there is no program no-such-launcher"});
}

// Would catch: a check that does not state the domain of its bounds if sines are given.
TEST_F(MessagesTest, CheckStatesTheCircle) {
  write("given.yaml", "sin_cos: given\ngravity: [0, -9.81, 0]\nfunctions: [gravity]\n");
  const Outcome text = run("check arm.urdf given.yaml --states 20");
  EXPECT_EQ(text.exit_code, 0) << text.err << text.out;
  expect_parts(text.out, {"rounding: for inputs of ", "sin_q^2 + cos_q^2 = 1"});
  const auto json = nlohmann::json::parse(run("check arm.urdf given.yaml --states 20 --json").out);
  expect_parts(json["domain"].get<std::string>(), {"sin_q^2 + cos_q^2 = 1"});
  EXPECT_GT(json["functions"][0]["rounding"]["states"].get<int>(), 0);
}

// Would catch: a name that is told as a fault of C++ where code of another language is asked for.
TEST_F(MessagesTest, SpeakOfNoOtherLanguageThanTheCodes) {
  for (const char* language : {"c", "c++", "opencl"}) {
    const Outcome outcome = run("generate arm.urdf -o out --warnings none --name int --language " +
                                std::string(language));
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("`int` cannot be a name in emitted code"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(outcome.err.find("C++"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace treeline
