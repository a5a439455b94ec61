#include <gtest/gtest.h>

#include "check/judges.hpp"
#include "fixture.hpp"

// Would catch: errors beyond what the graph permits that pass, and correct results that do not.

namespace treeline::tests {
namespace {

constexpr double kUnit = 0x1p-53;

struct Judged {
  Subjects subjects = load("planar3r");
  std::vector<StateReference> references = make_references(
      subjects.robot, subjects.scene, subjects.generation, ReferenceOptions{.states = 21});

  /// Judges results that are those of the graph times `factor`.
  std::optional<RoundingReport> judge(Function function, double factor) const {
    const auto& functions = subjects.generation.functions;
    std::size_t i = 0;
    while (functions[i].function != function) ++i;
    std::vector<Call> calls;
    for (const StateReference& reference : references) {
      const FunctionReference& at = reference.functions[i];
      if (at.singular) continue;
      std::vector<double> entries = at.graph;
      for (double& entry : entries) entry *= factor;
      calls.push_back({&reference.state, at.condition, at.size, {entries, false}});
    }
    return judge_rounding(functions[i], subjects.generation.domain, kUnit, calls);
  }
};

TEST(JudgeRounding, WhatTheGraphGivesIsSound) {
  const Judged judged;
  for (const Function function :
       {Function::mass_matrix, Function::forward_dynamics, Function::control_torque}) {
    const auto report = judged.judge(function, 1);
    ASSERT_TRUE(report.has_value());
    EXPECT_GT(report->states, 5) << function_name(function);
    EXPECT_GT(report->used, 0.01) << function_name(function);
    EXPECT_LE(report->used, 1) << function_name(function);
  }
}

/// At q = 0 the arm is stretched along x. The relaxed row contributes x to the fifth power of a
/// tiny number, whose first-order bound is smaller than its rounding.
TEST(JudgeRounding, WhatIsFlatThereIsSound) {
  Judged judged;
  judged.references.resize(1);
  ASSERT_EQ(judged.references.front().state.kind, StateClass::neutral);
  for (const Function function : {Function::lambda, Function::control_torque}) {
    std::size_t i = 0;
    const auto& functions = judged.subjects.generation.functions;
    while (functions[i].function != function) ++i;
    FunctionReference& at = judged.references.front().functions[i];
    EXPECT_LE(judged.judge(function, 1)->used, 1) << function_name(function);
    // An error that is small compared with the result at neighbouring states, and below what double
    // can resolve.
    for (std::size_t k = 0; k < at.graph.size(); ++k) at.graph[k] += 0x1p-110 * at.size[k];
    EXPECT_LE(judged.judge(function, 1)->used, 1) << function_name(function);
  }
}

/// A thousand ulp more than permitted at 21 states, which is not a whole number of batches.
TEST(JudgeRounding, WhatTheGraphDoesNotGiveIsNot) {
  const Judged judged;
  for (const Function function :
       {Function::mass_matrix, Function::forward_dynamics, Function::control_torque}) {
    EXPECT_GT(judged.judge(function, 1 + 0x1p-42)->used, 1) << function_name(function);
  }
}

TEST(JudgeRounding, SaysWhichKindItIs) {
  const Judged judged;
  EXPECT_EQ(judged.judge(Function::mass_matrix, 1)->kind, RoundingBound::Kind::proven);
  EXPECT_EQ(judged.judge(Function::forward_dynamics, 1)->kind, RoundingBound::Kind::searched);
  EXPECT_EQ(judged.judge(Function::control_torque, 1)->kind, RoundingBound::Kind::typical);
}

// Would catch: a bound that is told smaller than it is, where the header rounds the same up.
TEST(JudgeRounding, TellsBoundsRoundedUp) {
  CheckReport report;
  FunctionReport function;
  function.name = "gravity";
  function.rounding = RoundingReport{RoundingBound::Kind::proven, 1.21e-15};
  function.bound.interpreter = 5.001 / Bound::kInterpreterFactor;
  report.functions = {function};
  const std::string told = print_text(report);
  EXPECT_NE(told.find(" 1.3e-15 "), std::string::npos) << told;
  EXPECT_NE(told.find("8 + 5.01 "), std::string::npos) << told;
  report.functions[0].rounding->kind = RoundingBound::Kind::searched;
  EXPECT_NE(print_text(report).find(" ~2e-15 "), std::string::npos) << print_text(report);
}

}  // namespace
}  // namespace treeline::tests
