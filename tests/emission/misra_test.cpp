#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <regex>
#include <sstream>

#include "emission/backend.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emit.hpp"
#include "emission/generated_file.hpp"
#include "emission/print_files.hpp"
#include "emission/print_parts.hpp"
#include "emission/sample.hpp"

// Would catch: code of `profile: misra` that has what the profile promises to leave out, or that is
// longer than it promises; what cppcheck says of it is in tests/consumers.
namespace treeline {
namespace {

/// Limits of the sample: a motor, a joint without one, three forces in a cone.
LimitFacts limits_of_two() {
  LimitFacts limits;
  limits.passive = {1};
  limits.force_weights = {1, 1, 1};
  limits.torque = {80, 0};
  limits.cones = {{0, {0, 0, -1}, -2}};
  limits.task_weights = {1, 1};
  limits.freedoms = 2;
  return limits;
}

/// What a controller calls, as far as files are printed.
Program give_back(const std::string& name, const std::string& result, int rows,
                  std::vector<Argument> arguments) {
  Program program;
  program.name = name;
  program.arguments = std::move(arguments);
  const Graph::Scope scope(program.graph);
  program.results = {{{result, rows, 1, ""}, {}}};
  const std::string from = program.arguments.front().name + "[0]";
  for (int i = 0; i < rows; ++i)
    program.results.front().values.push_back(program.graph.input(from));
  return program;
}

/// A controller of two joints with every law, an observer and currents.
ControllerUnit every_law() {
  ControllerUnit unit;
  unit.settings.task = unit.settings.force = true;
  unit.settings.observer = 300;
  unit.settings.motors = {{"shoulder", {100, 0.05, 0}}, {"elbow", {50, 0.05, 0}}};
  const Argument q{"q", 2, 1, ""};
  unit.kinematics = give_back("controller_kinematics", "g", 2, {q});
  unit.joint_torque = give_back("controller_joint_torque", "tau", 2,
                                {{"qdd", 2, 1, ""}, q, {"payload", 10, 1, ""}});
  unit.task_torque = give_back("controller_task_torque", "tau", 2, {{"qdd_0", 2, 1, ""}, q});
  unit.push_torque = give_back("controller_push_torque", "tau", 2, {{"f_ext", 6, 1, ""}, q});
  unit.joints = {{"shoulder", false, -1, 1, 2, 3, false, 5},
                 {"elbow", false, -1, 1, 2, 3, false, 2.5}};
  unit.points = {{"tip", {true, true, false, false, false, false}, true}};
  unit.rows = 2;
  return unit;
}

std::vector<GeneratedFile> emit_safe(Language language, bool single_precision) {
  EmissionContext context = test::sample_context("arm", single_precision, language);
  context.misra = true;
  Diagnostics diagnostics;
  auto files = emit(context, test::safe_programs(), diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  context.limits = limits_of_two();
  context.controller = std::make_shared<const ControllerUnit>(every_law());
  for (auto& more :
       {print_damped_headers(context), print_limit_headers(context),
        std::vector{print_square_root(context)}, print_controller({context, {}, {}})}) {
    files.insert(files.end(), more.begin(), more.end());
  }
  guard_headers(context.name, files);
  std::erase_if(files, [](const GeneratedFile& file) {
    return file.name == "CMakeLists.txt" || file.name == "manifest.json";
  });
  return files;
}

/// Lines of code, without comments and strings.
std::vector<std::string> code_of(const std::string& text) {
  static const std::regex not_code(R"(//.*|/\*.*?\*/|"([^"\\]|\\.)*")");
  std::istringstream lines(text);
  std::vector<std::string> code;
  for (std::string line; std::getline(lines, line);) {
    code.push_back(std::regex_replace(line, not_code, "_"));
  }
  return code;
}

void expect_no(const std::string& pattern, const GeneratedFile& file) {
  const std::regex expression(pattern);
  for (const std::string& line : code_of(file.text)) {
    EXPECT_FALSE(std::regex_search(line, expression)) << file.name << ": " << line;
  }
}

TEST(Misra, HasNoMacrosBuiltinsAndSmallSuffixes) {
  for (const Language language : {Language::c, Language::cpp}) {
    for (const GeneratedFile& file : emit_safe(language, true)) {
      expect_no("^#(define (?!TREELINE_ARM\\w*_H(PP)?$)|undef|pragma)", file);
      expect_no("\\b[0-9][0-9a-fx.p+-]*[fulUL]*[ful]\\b", file);
      // Its atomic reads and writes are a deviation that notes for a safety review state.
      if (file.name.starts_with("controller_mailbox.")) continue;
      expect_no(
          "__(?!cplusplus|FAST_MATH__|ASSOCIATIVE_MATH__|RECIPROCAL_MATH__|"
          "FINITE_MATH_ONLY__|FLT_EVAL_METHOD__)\\w|\\b(union|reinterpret_cast|restrict|"
          "asm|goto)\\b",
          file);
    }
  }
}

TEST(Misra, WritesOneStatementALine) {
  for (const Language language : {Language::c, Language::cpp}) {
    for (const GeneratedFile& file : emit_safe(language, true)) {
      expect_no(";.*[^ }].*;(?!.*\\))", file);
    }
  }
}

/// The most statements of a function that begins at the margin.
int longest_function(const std::string& text) {
  int longest = 0;
  int statements = 0;
  bool inside = false;
  for (const std::string& line : code_of(text)) {
    const bool begins =
        line.ends_with("{") && line.find(") ") != std::string::npos && !line.starts_with("  ");
    if (begins) statements = 0;
    inside = begins || (inside && line != "}");
    statements += inside && line.find(';') != std::string::npos ? 1 : 0;
    longest = std::max(longest, statements);
  }
  return longest;
}

TEST(Misra, BoundsTheLengthOfFunctions) {
  for (const Language language : {Language::c, Language::cpp}) {
    int longest = 0;
    for (const GeneratedFile& file : emit_safe(language, false)) {
      const int length = longest_function(file.text);
      EXPECT_LE(length, kMostStatements) << file.name;
      longest = std::max(longest, length);
    }
    EXPECT_GE(longest, kMostStatements - 5);  // or functions were not found
  }
}

// Would catch: a table on the stack, which compilers copy there by a call of memcpy.
TEST(Misra, KeepsTablesOffTheStack) {
  for (const Language language : {Language::c, Language::cpp}) {
    for (const GeneratedFile& file : emit_safe(language, false)) {
      expect_no("^ +constexpr [^=]*\\[", file);
    }
  }
}

TEST(Misra, NamesConstants) {
  for (const GeneratedFile& file : emit_safe(Language::cpp, false)) {
    if (!file.name.ends_with(".cpp")) continue;
    for (const std::string& line : code_of(file.text)) {
      const bool has_number = std::regex_search(line, std::regex("[^\\w][0-9]+\\.[0-9e]"));
      const bool is_plain = std::regex_search(line, std::regex("[^\\w](0\\.0|0\\.5|1\\.0|2\\.0)"));
      EXPECT_TRUE(!has_number || is_plain || line.starts_with("  const Real constant_")) << line;
    }
  }
}

TEST(Misra, RefusesWhatItDoesNotHave) {
  EmissionContext context = test::sample_context("arm", false, Language::cpp);
  context.misra = true;
  context.lanes = 4;
  context.batch = 4;
  Diagnostics diagnostics;
  backend_of(Language::cpp).refuse(context, diagnostics);
  std::vector<std::string> keys;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    keys.push_back(diagnostic.element);
    EXPECT_FALSE(diagnostic.remedy.empty());
  }
  EXPECT_EQ(keys, (std::vector<std::string>{"lanes", "batch"}));
}

}  // namespace
}  // namespace treeline
