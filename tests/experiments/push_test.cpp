// A floating humanoid that is pushed while it stands on a ground that only pushes, in closed loop
// on generated code. Would catch: torques beyond limits or at a base without motors, forces beyond
// their cones, programs that are not solved, and limits that do not keep a body upright which falls
// without them.
#include "push.hpp"

#include <gtest/gtest.h>

namespace treeline::experiments {
namespace {

TEST(Push, RecoversWithinLimitsAndFallsWithout) {
  const PushRun limited = run_push(true);
  const PushRun unlimited = run_push(false);
  EXPECT_TRUE(push_claim_holds(limited, unlimited)) << push_summary(limited, unlimited);
}

}  // namespace
}  // namespace treeline::experiments
