// The table of functions. Would catch: a row that is in no list or in two that exclude each other,
// a name that is not found again, frames chosen by the cost of a function whose own are chosen by
// another's, a build that knows other functions than the program.
#include "functions/function.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace treeline {
namespace {

bool is_among(Function function, const auto& functions) {
  return std::find(functions.begin(), functions.end(), function) != functions.end();
}

TEST(Functions, AreFoundByTheirNames) {
  for (const Function function : kSceneFunctions) {
    EXPECT_EQ(find_function(function_name(function)), function) << function_name(function);
  }
  EXPECT_EQ(find_function("damped_control_torque"),
            std::nullopt);  // a key of the scene asks for it
  EXPECT_EQ(find_function("no_function"), std::nullopt);
}

TEST(Functions, AreDefaultsOrRequested) {
  for (const FunctionInfo& row : kFunctions) {
    const bool requested = is_among(row.function, kRequestedFunctions);
    const bool composed = row.emitted == Emitted::with_damping;
    EXPECT_EQ(row.emitted == Emitted::by_default, !requested && !composed) << row.name;
    EXPECT_NE(std::string(row.equation), "") << row.name;
    if (is_among(row.function, kDefaultFunctions)) {
      EXPECT_FALSE(needs_objects(row.function) || needs_contacts(row.function) ||
                   needs_constraints(row.function))
          << row.name;
    }
  }
  for (const Function function : kDampedFunctions)
    EXPECT_TRUE(is_among(function, kDefaultFunctions));
}

TEST(Functions, ChooseFramesByFunctionsThatChooseTheirOwn) {
  for (const FunctionInfo& row : kFunctions) {
    for (const Function function : row.frames) {
      const FrameCost& own = info_of(function).frames;
      ASSERT_EQ(own.count, 1U) << row.name;
      EXPECT_EQ(*own.begin(), function) << row.name;
    }
  }
}

TEST(Functions, NameTheMatrixThatTheySolveWith) {
  EXPECT_STREQ(matrix_symbol(solve_of(Function::forward_dynamics)), "M");
  EXPECT_STREQ(matrix_symbol(solve_of(Function::mass_matrix)), "");
  EXPECT_TRUE(inverts_mass_matrix(Function::control_torque));
  EXPECT_FALSE(inverts_mass_matrix(Function::inverse_dynamics));
}

TEST(Functions, AreKnownToCMake) {
  std::string listed;
  for (const Function function : kSceneFunctions) {
    if (!listed.empty()) listed += ',';
    listed += function_name(function);
  }
  EXPECT_EQ(TREELINE_FUNCTIONS, listed);
}

}  // namespace
}  // namespace treeline
