// Chang fig. 2.1 and 2.3 on the humanoid's checked-in code: the hands stay while the torso rocks.
// Would catch: posture torques that disturb the hands, advice that does not arrive or jerks them
// at each message, and a posture that does not come back.
#include "rock_torso.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace treeline::experiments {
namespace {

const std::string kFolder = std::string(TREELINE_ROBOTS_DIR) + "/humanoid24/";

struct Given {
  Plan pose;
  JointLimits limits;

  Given() {
    std::string error;
    EXPECT_TRUE(read_plan(kFolder + "touch_floor.yaml", pose, error)) << error;
    EXPECT_TRUE(read_limits(kFolder + "humanoid24.urdf", pose.joints, limits, error)) << error;
  }
};

TEST(RockTorso, AdviceIsContinuousAndEndsWhereItBegan) {
  const RockPlan plan;
  double before = 0.0;
  for (int i = 0; i <= 1500; ++i) {
    const WaistAdvice advice = advice_at(plan, 0.01 * i);
    // The steepest is 2 pi / period times the amplitude, and a little from its growing.
    EXPECT_LT(std::abs(advice.roll - before), 0.01 * plan.roll * (2 * 3.15 + 1) / plan.period);
    EXPECT_NEAR(advice.yaw * plan.roll, advice.roll * plan.yaw, 1e-15);
    before = advice.roll;
  }
  EXPECT_EQ(before, 0.0);
  EXPECT_NEAR(advice_at(plan, plan.lead + 1.25 * plan.period).roll, plan.roll, 1e-12);
}

TEST(RockTorso, MovesTheBodyAndNoHand) {
  const Given given;
  for (const double rate : {1000.0, 300.0}) {
    RockPlan plan;
    plan.rate = rate;
    const Outcome outcome = rock_torso(plan, given.pose, given.limits);
    EXPECT_FALSE(outcome.fault);  // joints, velocities and torques stay within the URDF's limits
    EXPECT_TRUE(rocks_without_hands(outcome, plan, given.pose))
        << rate << " Hz\n"
        << rock_summary(outcome, plan, given.pose);
    ASSERT_EQ(outcome.table.rows(), static_cast<std::size_t>(std::lround(plan.total() * rate)) + 1);
    // The springs' damping ends the rocking: nearly back a second after the last advice.
    const std::size_t last = outcome.table.rows() - 1;
    for (std::size_t i = 3; i < 6; ++i) {  // the waist
      EXPECT_NEAR(outcome.table.at(last, kFixedColumns + i), given.pose.start[i], 0.1)
          << given.pose.joints[i];
    }
  }
}

TEST(RockTorso, SaysSoWhereTheTorsoDoesNotFollow) {
  const Given given;
  RockPlan plan;
  plan.rounds = 2;
  plan.advice_rate = 0.01;  // nothing is said after the first message, at rest
  const Outcome outcome = rock_torso(plan, given.pose, given.limits);
  EXPECT_FALSE(outcome.fault);
  EXPECT_FALSE(rocks_without_hands(outcome, plan, given.pose));
  EXPECT_NE(rock_summary(outcome, plan, given.pose).find("BROKEN"), std::string::npos);
}

}  // namespace
}  // namespace treeline::experiments
