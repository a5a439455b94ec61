// Published hands of three and of five fingers that turn a ball, in closed loop on generated code.
// Would catch: fingertips that slip or let go, forces beyond their cones, torque at a ball without
// motors, a ball that does not follow, and joints beyond their limits.
#include "turn_ball.hpp"

#include <gtest/gtest.h>

namespace treeline::experiments {
namespace {

TEST(TurnBall, ByThreeFingersOfAnAllegroHand) {
  const BallRun run = turn_ball_by_allegro(plan_of_allegro());
  EXPECT_EQ(run.fingers, 3);
  EXPECT_TRUE(ball_claim_holds(run)) << ball_summary(run);
}

TEST(TurnBall, ByFiveFingersOfAShadowHand) {
  const BallRun run = turn_ball_by_shadow(plan_of_shadow());
  EXPECT_EQ(run.fingers, 5);
  EXPECT_TRUE(ball_claim_holds(run)) << ball_summary(run);
}

/// The internal force is what holds the ball: without it friction does not carry the weight.
TEST(TurnBall, NotIfFingersDoNotSqueeze) {
  BallPlan plan = plan_of_allegro();
  plan.squeeze = 0.0;
  const BallRun run = turn_ball_by_allegro(plan);
  EXPECT_FALSE(ball_claim_holds(run)) << ball_summary(run);
  EXPECT_LE(run.figures.least_felt, 0.0);
}

}  // namespace
}  // namespace treeline::experiments
