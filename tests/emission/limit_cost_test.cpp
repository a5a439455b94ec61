#include <gtest/gtest.h>

#include "core/emitted_limits.hpp"
#include "emission/costs.hpp"

// Would catch: a stack that is stated smaller than what the method puts there.
namespace treeline {
namespace {

TEST(LimitCost, CountsWhatTheMethodPutsOnTheStack) {
  constexpr int V = 12, P = 6, H = 9, T = 4, C = 15, F = 9;
  using Sizes = core::LimitSizes<V, P, H, T, C, F>;
  LimitFacts facts;
  facts.passive.resize(P);
  facts.force_weights.resize(H);
  facts.task_weights.resize(T);
  facts.cones.resize(C);
  facts.freedoms = F;
  facts.held_shares.assign(H, -1);  // the test's headers know shares
  facts.task_shares.assign(T, -1);
  const LimitCost cost = cost_of_limits(facts, V);
  ASSERT_EQ(cost.unknowns, Sizes::kUnknowns);
  ASSERT_EQ(cost.rows, Sizes::kRows);
  constexpr std::size_t kMatrices = V * V + H * V + T * V + V + H;
  const std::size_t bytes =
      sizeof(core::EmittedLimits<double, Sizes>::TlLimitProgram) + kMatrices * sizeof(double);
  EXPECT_NEAR(8.0 * cost.values, static_cast<double>(bytes), 0.05 * static_cast<double>(bytes));
}

}  // namespace
}  // namespace treeline
