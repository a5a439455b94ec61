// A published quadruped that trots over a ground that only pushes, in closed loop on generated
// code. Would catch: torques beyond limits or at a base without motors, forces beyond their cones,
// programs that are not solved, joints beyond their speeds, feet that stay on the ground or land
// elsewhere, and a body that does not arrive.
#include "trot.hpp"

#include <gtest/gtest.h>

namespace treeline::experiments {
namespace {

TEST(Trot, StandsTrotsInPlaceAndWalksTenMetresWithinLimits) {
  const TrotPlan plan;
  EXPECT_EQ(plan.way, 10.0);
  const TrotRun run = run_trot(plan);
  EXPECT_TRUE(trot_claim_holds(plan, run)) << trot_summary(plan, run);
}

}  // namespace
}  // namespace treeline::experiments
