// A floating humanoid that stands, in closed loop on generated code. Would catch: torques at a base
// without motors, feet that drift, a task that the support disturbs, and forces of the ground that
// are not those that act.
#include "stand.hpp"

#include <gtest/gtest.h>

namespace treeline::experiments {
namespace {

TEST(Stand, ShiftsItsWeightByMotorsAlone) {
  const StandRun run = run_stand();
  EXPECT_TRUE(stand_claim_holds(run)) << stand_summary(run);
}

}  // namespace
}  // namespace treeline::experiments
