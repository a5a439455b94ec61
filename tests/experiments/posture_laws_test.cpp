// Posture and force laws in closed loop on generated code. Would catch: a law that has no effect in
// the null space, a law that affects the task, and a selection frame that is transposed or not
// updated.
#include <gtest/gtest.h>

#include "avoid_limits.hpp"
#include "balance.hpp"
#include "press_surface.hpp"

namespace treeline::experiments {
namespace {

TEST(PostureLaws, JointLimitsAreAvoidedAndTheToolDoesNotNotice) {
  const AvoidRun avoiding = run_avoid_limits(true);
  const AvoidRun without = run_avoid_limits(false);
  EXPECT_TRUE(avoid_claim_holds(avoiding, without)) << avoid_summary(avoiding, without);
  // The base makes room.
  EXPECT_GT(avoiding.figures.base_travel, 3.0 * without.figures.base_travel);
}

TEST(PostureLaws, CentreOfMassStaysOverTheFeet) {
  const std::string folder = std::string(TREELINE_ROBOTS_DIR) + "/humanoid24";
  Plan plan;
  JointLimits limits;
  std::string error;
  ASSERT_TRUE(read_plan(folder + "/touch_floor.yaml", plan, error)) << error;
  ASSERT_TRUE(read_limits(folder + "/humanoid24.urdf", plan.joints, limits, error)) << error;
  const BalanceRun balancing = run_balance(plan, limits, true);
  const BalanceRun without = run_balance(plan, limits, false);
  EXPECT_TRUE(balance_claim_holds(balancing, without)) << balance_summary(balancing, without);
}

TEST(ForceSelection, PressesAlongAMovingDirection) {
  const PressRun moving = run_press(Frame::moving);
  const PressRun fixed = run_press(Frame::fixed);
  EXPECT_TRUE(press_claim_holds(moving, fixed)) << press_summary(moving, fixed);
}

}  // namespace
}  // namespace treeline::experiments
