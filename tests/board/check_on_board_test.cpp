// Would catch: other bits on a processor than on the host, a count of instructions that depends on
// the state where every operation has an instruction, a stack that exceeds what is stated, a call
// of a library, and a changed function that passes.
#include "board/check_on_board.hpp"

#include <gtest/gtest.h>

#include <tuple>

#include "check/add_selftest.hpp"
#include "check/fixture.hpp"
#include "description/follow_target.hpp"

namespace treeline::tests {
namespace {

/// The PUMA with some of its functions, for a target.
Subjects puma_for(const std::string& target, Real real, std::vector<Function> functions) {
  Subjects subjects = load("puma560", "scene_float.yaml");
  subjects.scene.real = real;
  subjects.scene.target = target;
  subjects.scene.functions = std::move(functions);
  follow_target(subjects.scene);
  subjects.generation = generate(subjects.robot, subjects.scene);
  return subjects;
}

CheckOptions board_options(int states) {
  CheckOptions options;
  options.references.states = states;
  return options;
}

BoardReport run_on_board(const Subjects& subjects, const CheckOptions& options) {
  Diagnostics diagnostics;
  const auto report =
      check_on_board(subjects.robot, subjects.scene, subjects.generation, options, {}, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.list()) ADD_FAILURE() << to_string(diagnostic);
  if (!report) throw std::runtime_error("nothing ran");
  return *report;
}

std::vector<std::string> boards() {
  std::vector<std::string> names;
  for (const Target& target : all_targets()) {
    if (target.board.kind != BoardKind::none) names.emplace_back(target.name);
  }
  return names;
}

using Machine = std::tuple<std::string, Real>;

class OnBoard : public testing::TestWithParam<Machine> {};

TEST_P(OnBoard, GivesTheHostsBits) {
  const auto& [name, real] = GetParam();
  const Subjects subjects =
      puma_for(name, real, {Function::inverse_dynamics, Function::control_torque});
  const BoardReport report = run_on_board(subjects, board_options(40));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_EQ(report.functions.size(), 2U);
  const bool emulated = emulates(*find_target(name), bytes_of(real));
  for (const BoardFunction& f : report.functions) {
    EXPECT_EQ(f.states, 40);
    EXPECT_EQ(f.bits_differ, 0) << f.name;
    EXPECT_EQ(f.arithmetic.empty(), !emulated) << f.name;
    EXPECT_GT(f.text_bytes, 400) << f.name;
    ASSERT_TRUE(f.stack_bytes) << f.name;
    if (emulated) continue;
    EXPECT_EQ(f.least, f.most) << f.name;
    EXPECT_GT(f.cycles, 0.3 * static_cast<double>(f.most)) << f.name;
    EXPECT_LE(f.stack_seen, static_cast<std::uint64_t>(*f.stack_bytes)) << f.name;
    EXPECT_GE(f.stack_seen + 64, static_cast<std::uint64_t>(*f.stack_bytes)) << f.name;
  }
}

std::string machine_name(const testing::TestParamInfo<Machine>& info) {
  std::string name = std::get<0>(info.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name + (std::get<1>(info.param) == Real::float32 ? "_float" : "_double");
}

INSTANTIATE_TEST_SUITE_P(Machines, OnBoard,
                         testing::Combine(testing::ValuesIn(boards()),
                                          testing::Values(Real::float32, Real::float64)),
                         machine_name);

// Would catch: float code that a single-precision unit computes in double, or in a loop of sweeps.
TEST(OnBoard, FloatControlFitsASmallCore) {
  const BoardReport report = run_on_board(
      puma_for("cortex-m4f", Real::float32, {Function::control_torque}), board_options(300));
  ASSERT_EQ(report.functions.size(), 1U);
  EXPECT_LT(report.functions[0].most, 1200U);
  EXPECT_TRUE(report.functions[0].takes_constant_time()) << print_text(report);
  EXPECT_TRUE(report.functions[0].arithmetic.empty());
}

/// The PUMA with the damped law and what that calls.
Subjects damped_puma_for(const std::string& target, Real real, Language language) {
  Subjects subjects = puma_for(target, real,
                               {Function::jacobian, Function::bias_acceleration,
                                Function::inverse_dynamics, Function::lambda_inverse});
  subjects.scene.damped = EffectiveMassLimit{20, 2};
  subjects.scene.language = language;
  subjects.generation = generate(subjects.robot, subjects.scene);
  return subjects;
}

void expect_damped(const BoardReport& report) {
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_EQ(report.functions.size(), 5U);
  const BoardFunction& damped = report.functions.back();
  EXPECT_EQ(damped.name, "damped_control_torque");
  EXPECT_EQ(damped.states, 20);
  // It calls the others: its stack holds the deepest of them.
  ASSERT_TRUE(damped.stack_bytes);
  EXPECT_GT(*damped.stack_bytes, report.functions[3].stack_bytes.value_or(0));
  const int of_library = damped.arithmetic.empty() ? 0 : 64;  // where numbers are emulated
  EXPECT_LE(damped.stack_seen, static_cast<std::uint64_t>(*damped.stack_bytes + of_library));
}

TEST(OnBoard, RunsTheDampedLaw) {
  expect_damped(
      run_on_board(damped_puma_for("cortex-m7", Real::float64, Language::cpp), board_options(20)));
}

// Would catch: a table of safe code that compilers copy by memcpy, small code that is not judged.
TEST(OnBoard, RunsTheDampedLawOfSafeSmallCode) {
  Subjects subjects = damped_puma_for("cortex-m7", Real::float64, Language::cpp);
  subjects.scene.profile = Profile::misra;
  subjects.scene.optimize = Optimize::size;
  subjects.generation = generate(subjects.robot, subjects.scene);
  const BoardReport report = run_on_board(subjects, board_options(20));
  expect_damped(report);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(report.functions[i].is_small);
  EXPECT_FALSE(report.functions[4].is_small);  // a header
  EXPECT_EQ(report.small_command, report.command + " -Os");
  EXPECT_NE(print_text(report).find("`optimize`"), std::string::npos);
}

// Would catch: a header of the library of C++, which this toolchain does not have.
TEST(OnBoard, RunsSafeCodeWithoutALibrary) {
  Subjects subjects = damped_puma_for("rv32imfc", Real::float32, Language::cpp);
  subjects.scene.profile = Profile::misra;
  subjects.generation = generate(subjects.robot, subjects.scene);
  expect_damped(run_on_board(subjects, board_options(20)));
}

// Would catch: eigenvectors written out, or sweeps that repeat until some matrix is diagonal.
TEST(OnBoard, TheDampedLawFitsASmallCore) {
  const BoardReport report =
      run_on_board(damped_puma_for("cortex-m4f", Real::float32, Language::cpp), board_options(20));
  expect_damped(report);
  EXPECT_LT(report.functions.back().most, 20000U);
}

// Would catch: C that needs a library, a state that C reads at another place than C++, a stack that
// is looked up under the symbol of C++, and the flags of C++ given to C.
TEST(OnBoard, RunsC) {
  for (const auto& [target, real] :
       {std::pair{"cortex-m4f", Real::float32}, std::pair{"cortex-m0", Real::float32},
        std::pair{"rv64gc", Real::float64}}) {
    SCOPED_TRACE(target);
    const BoardReport report =
        run_on_board(damped_puma_for(target, real, Language::c), board_options(20));
    EXPECT_NE(report.command.find("gcc -std=c99"), std::string::npos) << report.command;
    expect_damped(report);
    EXPECT_EQ(report.functions.back().arithmetic.empty(), std::string(target) != "cortex-m0");
  }
}

/// The loops of two functions, in both languages.
void expect_loops_run(Subjects subjects) {
  subjects.scene.target = "cortex-m4f";
  subjects.scene.real = Real::float32;
  subjects.scene.functions = {Function::inverse_dynamics, Function::mass_matrix};
  subjects.scene.optimize = Optimize::size;
  for (const Language language : {Language::cpp, Language::c}) {
    SCOPED_TRACE(language == Language::c ? "C" : "C++");
    subjects.scene.language = language;
    follow_target(subjects.scene);
    subjects.generation = generate(subjects.robot, subjects.scene);
    const BoardReport report = run_on_board(subjects, board_options(10));
    EXPECT_TRUE(report.passed()) << print_text(report);
    for (const BoardFunction& function : report.functions) {
      EXPECT_LT(function.text_bytes + function.constant_bytes, 5500) << function.name;
      EXPECT_TRUE(function.takes_constant_time()) << function.name;
    }
  }
}

// Would catch: loops that are taken for wrong because of a zero's sign, and loops in C that call
// what a board does not have.
TEST(OnBoard, RunsLoopsOverLinks) {
  expect_loops_run(load_unmade("humanoid24", "scene.yaml"));
}

// Would catch: a table that is filled so that the compiler calls memset.
TEST(OnBoard, RunsLoopsWhoseTableArgumentsChange) {
  Subjects subjects = load_unmade("humanoid24", "scene.yaml");
  subjects.scene.inputs.gravity = true;
  subjects.scene.inputs.payloads.push_back({"right_hand"});
  expect_loops_run(subjects);
}

// Would catch: a choice that does not ask what operations cost on the target. A Cortex-M4F does not
// wait for operands, so that the route of fewer operations wins there, though its chain is longer.
TEST(OnBoard, CostsOfTheTargetDecide) {
  const auto chosen = [](const char* target) {
    Subjects subjects = load("samm");
    subjects.scene.target = target;
    subjects.scene.real = Real::float32;
    subjects.scene.functions = {Function::lambda_inverse};
    subjects.scene.lanes = 1;
    return generate(subjects.robot, subjects.scene).functions.front().chosen;
  };
  const Cost generic = chosen("generic");
  const Cost small = chosen("cortex-m4f");
  EXPECT_NE(key_of(small.route), key_of(generic.route));
  EXPECT_LT(small.count.flops(), generic.count.flops());
  EXPECT_EQ(small.count.div, generic.count.div);
}

TEST(OnBoard, HoldsContractionToTheBound) {
  CheckOptions options = board_options(40);
  options.compile.flags = "-O2";
  const Subjects subjects = puma_for("cortex-m7", Real::float64, {Function::inverse_dynamics});
  const BoardReport report = run_on_board(subjects, options);
  EXPECT_TRUE(report.contracted);
  EXPECT_TRUE(report.passed()) << print_text(report);
  EXPECT_GT(report.functions[0].bits_differ, 0);
  EXPECT_GT(report.functions[0].worst, 0);
}

// Would catch: a comparison that always passes.
TEST(OnBoard, CatchesAChangedFunction) {
  const Subjects subjects =
      puma_for("cortex-m4f", Real::float32, {Function::inverse_dynamics, Function::gravity});
  const TemporaryFolder folder;
  write_folder(folder.path() / "code", subjects.generation);
  const auto file = folder.path() / "code" / "gravity.cpp";
  std::string text = read_file(file);
  const auto at = text.rfind(" + ");
  ASSERT_NE(at, std::string::npos);
  write_file(file, text.replace(at, 3, " - "));
  CheckOptions options = board_options(20);
  options.folder = folder.path() / "code";
  const BoardReport report = run_on_board(subjects, options);
  EXPECT_FALSE(report.passed());
  ASSERT_EQ(report.functions.size(), 2U);
  EXPECT_EQ(report.functions[0].bits_differ, 0);
  EXPECT_GT(report.functions[1].bits_differ, 0);
  ASSERT_EQ(report.stale.size(), 1U);
  EXPECT_NE(print_text(report).find("gravity: other bits than on the host"), std::string::npos);
}

// Would catch: a library function that slips into firmware.
TEST(OnBoard, NamesCallsAndVariables) {
  const Subjects subjects = puma_for("cortex-m4f", Real::float32, {Function::gravity});
  const TemporaryFolder folder;
  write_folder(folder.path() / "code", subjects.generation);
  const auto file = folder.path() / "code" / "gravity.cpp";
  const std::string text = read_file(file);
  write_file(file,
             text +
                 "\nextern \"C\" __attribute__((weak)) void print_line();\n"
                 "int calls;\nvoid count_call() { ++calls; if (&print_line) print_line(); }\n");
  CheckOptions options = board_options(20);
  options.folder = folder.path() / "code";
  const BoardReport report = run_on_board(subjects, options);
  EXPECT_FALSE(report.passed());
  EXPECT_EQ(report.functions[0].strays, std::vector<std::string>{"print_line"});
  EXPECT_EQ(report.functions[0].static_bytes, 4);
  EXPECT_EQ(report.functions[0].bits_differ, 0);
}

// Would catch: a controller that is passed without running on the board, other bits there than on
// the host, modes that are not measured, and a changed law that passes.
TEST(StepOnBoard, RunsInEveryMode) {
  Subjects subjects = load_unmade("puma560", "firmware/scene.yaml");
  subjects.scene.target = "cortex-m4f";
  subjects.scene.real = Real::float32;
  subjects.scene.functions = {Function::gravity};
  follow_target(subjects.scene);
  subjects.generation = generate(subjects.robot, subjects.scene);
  const BoardReport report = run_on_board(subjects, board_options(20));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_EQ(report.functions.size(), 2U);
  const BoardFunction& step = report.functions.back();
  EXPECT_EQ(step.name, subjects.scene.name + "_step");
  EXPECT_EQ(step.states, 1000);
  EXPECT_EQ(step.bits_differ, 0);
  EXPECT_GT(step.text_bytes, 5000);
  ASSERT_TRUE(step.stack_bytes);
  EXPECT_LE(step.stack_seen, static_cast<std::uint64_t>(*step.stack_bytes) + 64);
  ASSERT_EQ(step.modes.size(), 4U);
  for (const BoardFunction::Mode& mode : step.modes) {
    EXPECT_GT(mode.steps, 1);
    EXPECT_GT(mode.least, 500U);
    EXPECT_LE(mode.most, step.most);
  }
}

// Would catch: a self-test that is not run or measured there, that needs a library, or that passes
// with a changed law; and a controller without functions, for which there are no states.
TEST(StepOnBoard, RunsTheSelftestOfAControllerAlone) {
  Subjects subjects = load_unmade("puma560", "firmware/scene.yaml");
  subjects.scene.target = "cortex-m4f";
  subjects.scene.language = Language::c;
  subjects.scene.functions = {};
  subjects.scene.selftest = 1;
  follow_target(subjects.scene);
  subjects.generation = generate(subjects.robot, subjects.scene);
  Diagnostics diagnostics;
  ASSERT_TRUE(add_selftest(subjects.robot, subjects.scene, subjects.generation, diagnostics));
  const BoardReport report = run_on_board(subjects, board_options(5));
  EXPECT_TRUE(report.passed()) << print_text(report);
  ASSERT_EQ(report.functions.size(), 2U);
  const BoardFunction& selftest = report.functions.back();
  EXPECT_EQ(selftest.name, subjects.scene.name + "_selftest");
  EXPECT_GT(selftest.most, 40 * report.functions.front().least);
  EXPECT_LT(selftest.text_bytes + selftest.constant_bytes, 2000);
  EXPECT_FALSE(report.counts_cycles);

  const TemporaryFolder folder;
  write_folder(folder.path() / "code", subjects.generation);
  const auto file = folder.path() / "code" / "controller_joint_torque.c";
  std::string text = read_file(file);
  const auto at = text.rfind("] = ");
  ASSERT_NE(at, std::string::npos);
  write_file(file, text.insert(at + 4, "1 + "));
  CheckOptions options = board_options(5);
  options.folder = folder.path() / "code";
  const BoardReport broken = run_on_board(subjects, options);
  EXPECT_EQ(broken.functions.back().returned, 1);
  EXPECT_FALSE(broken.passed());
  EXPECT_NE(print_text(broken).find("_selftest: returns 1"), std::string::npos);
}

}  // namespace
}  // namespace treeline::tests
