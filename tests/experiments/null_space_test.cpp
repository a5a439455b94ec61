// Chang fig. 2.4 and 2.5: the physical claim. Would catch: a null-space torque that couples into
// the task, a transposed projection, and a swing that has died down (and so would prove nothing).
#include "null_space.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace treeline::experiments {
namespace {

TEST(NullSpace, OnlyTheDynamicallyConsistentInverseLeavesTheTipAlone) {
  const NullSpaceRun pseudo = run_null_space(Inverse::pseudo);
  const NullSpaceRun consistent = run_null_space(Inverse::dynamic_consistent);
  // Integration alone leaves 1e-12; the claim requires 1e-9.
  EXPECT_LT(consistent.figures.tip_motion, 1e-9);
  EXPECT_LT(consistent.figures.coupling, 1e-10);
  EXPECT_GT(pseudo.figures.tip_motion, 1e-2);
  EXPECT_GT(pseudo.figures.coupling, 1.0);
  EXPECT_TRUE(null_space_claim_holds(pseudo, consistent));
}

// Nothing dissipates in the null space, so the last swing is as wide as the first.
TEST(NullSpace, SwingIsNotDamped) {
  const std::vector<double> q2 = run_null_space(Inverse::dynamic_consistent).table.column(6);
  const auto half = q2.begin() + static_cast<std::ptrdiff_t>(q2.size() / 2);
  const double first = *std::max_element(q2.begin(), half);
  const double last = *std::max_element(half, q2.end());
  EXPECT_NEAR(first, last, 1e-3);
}

}  // namespace
}  // namespace treeline::experiments
