// NAME_selftest as firmware has it. Would catch: bits that emitted code does not give, a fault that
// it misses or gives to another function, states beyond limits or other ones on the next run, a
// step that never moves, sources that no build compiles, and a folder that changes unasked.
#include <algorithm>
#include <set>

#include "check/add_selftest.hpp"
#include "compilation/run_commands.hpp"
#include "emission/controller_unit.hpp"
#include "emission/selftest_facts.hpp"
#include "fixture.hpp"
#include "generation/predict_sources.hpp"

namespace treeline::tests {
namespace {

namespace fs = std::filesystem;

Subjects load_tested(const std::string& robot, const std::string& scene_file,
                     std::vector<Function> functions, Language language, Real real) {
  Subjects subjects = load_unmade(robot, scene_file);
  subjects.scene.functions = std::move(functions);
  subjects.scene.language = language;
  subjects.scene.real = real;
  subjects.scene.selftest = 2;
  subjects.generation = generate(subjects.robot, subjects.scene);
  Diagnostics diagnostics;
  EXPECT_TRUE(add_selftest(subjects.robot, subjects.scene, subjects.generation, diagnostics));
  for (const Diagnostic& each : diagnostics.list()) ADD_FAILURE() << to_string(each);
  return subjects;
}

const GeneratedFile& find_emitted(const Subjects& subjects, const std::string& name) {
  const auto& files = subjects.generation.files;
  const auto at = std::find_if(files.begin(), files.end(),
                               [&](const GeneratedFile& file) { return file.name == name; });
  if (at == files.end()) throw std::runtime_error(name + " is not emitted");
  return *at;
}

/// Compiles the folder as a user does, with a program that returns what the self-test does.
int run_as_user(const Subjects& subjects, const fs::path& folder, const std::string& flags) {
  const bool is_c = subjects.scene.language == Language::c;
  const std::string name = subjects.scene.name;
  write_file(
      folder / (is_c ? "main.c" : "main.cpp"),
      "#include \"" + name + "_selftest.h\"\nint main(void) { return " + name + "_selftest(); }\n");
  Command command{is_c ? "gcc" : "g++",
                  is_c ? "-std=c99" : "-std=c++17",
                  "-Wall",
                  "-Wextra",
                  "-Wpedantic",
                  "-Wconversion",
                  "-Wsign-conversion",
                  "-Wshadow",
                  "-Werror",
                  "-o",
                  (folder / "selftest_program").string()};
  for (const std::string& flag : split_words(flags)) command.push_back(flag);
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension();
    if (ending == ".c" || ending == ".cpp") command.push_back(entry.path());
  }
  const CommandOutcome compiled = run_commands({command}, 1, folder).front();
  EXPECT_EQ(compiled.exit_code, 0) << compiled.output;
  return run_commands({{(folder / "selftest_program").string()}}, 1, folder).front().exit_code;
}

/// Adds 1 to the last result that a source writes.
void break_source(const fs::path& file) {
  std::string text = read_file(file);
  const auto at = text.rfind("] = ");
  ASSERT_NE(at, std::string::npos) << file;
  write_file(file, text.insert(at + 4, "1 + "));
}

TEST(Selftest, TellsWhichFunctionIsWrong) {
  for (const auto& [language, real] :
       {std::pair{Language::c, Real::float32}, std::pair{Language::cpp, Real::float64}}) {
    SCOPED_TRACE(language == Language::c ? "C" : "C++");
    const Subjects subjects = load_tested(
        "puma560", "scene.yaml", {Function::gravity, Function::inverse_dynamics}, language, real);
    const TemporaryFolder folder;
    const fs::path code = folder.path() / "code";
    write_folder(code, subjects.generation);
    EXPECT_EQ(run_as_user(subjects, code, "-O2 -ffp-contract=off"), 0);
    EXPECT_EQ(run_as_user(subjects, code, "-O2 -ffp-contract=off -flto"), 0);
    break_source(code / (language == Language::c ? "inverse_dynamics.c" : "inverse_dynamics.cpp"));
    const auto& facts = *subjects.generation.context->selftest;
    ASSERT_EQ(facts.functions.size(), 2U);
    const int broken = facts.functions[0].function == "inverse_dynamics" ? 1 : 2;
    EXPECT_EQ(run_as_user(subjects, code, "-O2 -ffp-contract=off"), broken);
    const std::string header = find_emitted(subjects, subjects.scene.name + "_selftest.h").text;
    EXPECT_NE(header.find("      " + std::to_string(broken) + "  inverse_dynamics\n"),
              std::string::npos)
        << header;
  }
}

TEST(Selftest, FailsInCheck) {
  const Subjects subjects =
      load_tested("puma560", "scene.yaml", {Function::gravity}, Language::c, Real::float64);
  const CheckReport report = check_or_throw(subjects, quick_options(20));
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_EQ(report.selftest, 0);
  const TemporaryFolder folder;
  write_folder(folder.path() / "code", subjects.generation);
  break_source(folder.path() / "code" / "gravity.c");
  CheckOptions options = quick_options(20);
  options.folder = folder.path() / "code";
  const CheckReport broken = check_or_throw(subjects, options);
  EXPECT_EQ(broken.selftest, 1);
  EXPECT_FALSE(broken.passed());
  EXPECT_NE(print_text(broken).find("_selftest returns 1"), std::string::npos);
}

TEST(Selftest, IsTheSameEachTimeAndWithinLimits) {
  const auto make = [] {
    return load_tested("puma560", "scene.yaml", {Function::gravity}, Language::c, Real::float64);
  };
  const Subjects subjects = make();
  EXPECT_EQ(find_emitted(subjects, "selftest.c").text, find_emitted(make(), "selftest.c").text);
  const auto& facts = *subjects.generation.context->selftest;
  ASSERT_EQ(facts.arguments.size(), 1U);
  ASSERT_EQ(facts.arguments[0].by_state.size(), 2U);
  const auto& rows = subjects.generation.context->coordinate_rows;
  for (const std::vector<double>& q : facts.arguments[0].by_state) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      EXPECT_GE(q[i], rows[i].lower);
      EXPECT_LE(q[i], rows[i].upper);
      EXPECT_EQ(q[i], static_cast<double>(static_cast<float>(q[i])));
    }
  }
}

// Would catch: what builds ask for before there are files, and a list of CMake's that lacks it.
TEST(Selftest, IsCompiledByBuilds) {
  for (const Language language : {Language::c, Language::cpp}) {
    const Subjects subjects =
        load_tested("puma560", "scene.yaml", {Function::gravity}, language, Real::float64);
    const auto stems = predict_sources(subjects.scene);
    EXPECT_EQ(std::count(stems.begin(), stems.end(), "selftest"), 1);
    const std::string ending = language == Language::c ? ".c" : ".cpp";
    EXPECT_NE(find_emitted(subjects, "CMakeLists.txt").text.find("selftest" + ending),
              std::string::npos);
  }
}

TEST(Selftest, ComesOnlyWhereItIsAskedFor) {
  Subjects subjects = load("puma560");
  const auto before = subjects.generation.files.size();
  Diagnostics diagnostics;
  EXPECT_TRUE(add_selftest(subjects.robot, subjects.scene, subjects.generation, diagnostics));
  EXPECT_EQ(subjects.generation.files.size(), before);
}

// Would catch: bits of loops, whose zeros may have another sign, that are taken for wrong.
TEST(Selftest, PassesLoopsOverLinks) {
  Subjects subjects = load_unmade("humanoid24", "scene.yaml");
  subjects.scene.functions = {Function::mass_matrix};
  subjects.scene.optimize = Optimize::size;
  subjects.scene.selftest = 1;
  subjects.generation = generate(subjects.robot, subjects.scene);
  Diagnostics diagnostics;
  ASSERT_TRUE(add_selftest(subjects.robot, subjects.scene, subjects.generation, diagnostics));
  const TemporaryFolder folder;
  write_folder(folder.path() / "code", subjects.generation);
  EXPECT_EQ(run_as_user(subjects, folder.path() / "code", "-O2 -ffp-contract=off"), 0);
}

TEST(Selftest, IsRefusedWithoutAFunction) {
  Subjects subjects = load("puma560");
  subjects.scene.selftest = 1;
  subjects.generation.functions.clear();
  Diagnostics diagnostics;
  EXPECT_FALSE(add_selftest(subjects.robot, subjects.scene, subjects.generation, diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(Selftest, MovesTheStep) {
  for (const Language language : {Language::c, Language::cpp}) {
    SCOPED_TRACE(language == Language::c ? "C" : "C++");
    const Subjects subjects =
        load_tested("puma560", "firmware/scene.yaml", {Function::gravity}, language, Real::float32);
    const auto& motion = subjects.generation.context->selftest->motion;
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->kinds, (std::vector<std::string>{"START", "MOVE_JOINTS", "MOVE_POINT",
                                                       "COMPLY", "LEAD_JOINTS", "STOP"}));
    EXPECT_EQ(motion->modes, (std::vector<int>{1, 1, 1, 1, 1, 2}));
    for (const std::uint32_t faults : motion->faults) EXPECT_EQ(faults, 0U);
    EXPECT_EQ(std::set(motion->tau.begin(), motion->tau.end()).size(), motion->tau.size());
    const TemporaryFolder folder;
    const fs::path code = folder.path() / "code";
    write_folder(code, subjects.generation);
    EXPECT_EQ(run_as_user(subjects, code, "-O2 -ffp-contract=off"), 0);
    break_source(code / (language == Language::c ? "controller_joint_torque.c"
                                                 : "controller_joint_torque.cpp"));
    EXPECT_EQ(run_as_user(subjects, code, "-O2 -ffp-contract=off"), 2);
  }
}

}  // namespace
}  // namespace treeline::tests
