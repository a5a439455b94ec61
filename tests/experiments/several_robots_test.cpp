// Experiments with several robots in one scene (Chang 7.2, 7.3.1): their claims, and that without
// trouble robots which control their shares by themselves command the torques that one computer
// would. Would catch: a share, a frame or an exchange that is right in one law and wrong in
// another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "carry_ladder.hpp"
#include "carry_plan.hpp"
#include "cooperation.hpp"
#include "core/command_laws.hpp"
#include "core/orientation.hpp"
#include "share_law.hpp"
#include "three_arms.hpp"

namespace {

using namespace treeline::experiments;  // NOLINT: all of it is under test

TEST(Cooperation, ClaimsHold) {
  const Comparison comparison = compare_laws({});
  EXPECT_TRUE(claims_hold(comparison)) << summary(comparison);
}

// On the way, with commanded internal forces, where both robots see the same object.
TEST(Cooperation, SharesAreTheWholeWhereNobodyErrs) {
  const CarryPlan plan;
  const PairState start = start_state();
  PairState state = start;
  double largest = 0.0, off = 0.0;
  for (int cycle = 0; cycle < 6000; ++cycle) {
    const Wanted wanted = wanted_at(plan, cycle / plan.rate);
    const ObjectSeen seen = see_object(state);
    double error[6], xdd[6], qdd_0[2][kJoints];
    treeline::core::pose_error(seen.position, seen.rotation, wanted.position, wanted.rotation,
                               error);
    treeline::core::tracking_law<6, double>({plan.stiffness, plan.damping}, error, seen.velocity,
                                            wanted.velocity, wanted.acceleration, xdd);
    advise(plan, start, state, wanted, qdd_0);
    const PairTorques whole = control_pair(state, xdd, wanted.internal, qdd_0);
    for (int robot = 0; robot < 2; ++robot) {
      double share[kJoints];
      control_share(robot, plan, wanted, wanted.internal, state.q[robot], state.qd[robot],
                    qdd_0[robot], share);
      for (int i = 0; i < kJoints; ++i) {
        largest = std::max(largest, std::abs(whole.tau[robot][i]));
        off = std::max(off, std::abs(whole.tau[robot][i] - share[i]));
      }
    }
    integrate_pair(whole, 1.0 / plan.rate, state);
  }
  // With one step of integration a cycle the robots see the object alike within 1e-11 m, which a
  // stiffness of 2500 /s^2 and moving masses of some 200 kg make 1e-5 N.
  EXPECT_GT(largest, 10.0);
  EXPECT_LT(off, 1e-4);
}

TEST(ThreeArms, CarryTheBeamAsCommanded) {
  const ThreeArmsOutcome outcome = carry_with_three_arms({});
  EXPECT_FALSE(outcome.fault);
  EXPECT_TRUE(within_bounds(outcome)) << summary(outcome);
  EXPECT_GT(outcome.table.rows(), 5000U);
}

TEST(Ladder, TwoHumanoidsCarryItAsCommanded) {
  const LadderOutcome outcome = carry_ladder({});
  EXPECT_FALSE(outcome.fault);
  EXPECT_TRUE(within_bounds(outcome)) << summary(outcome);
  EXPECT_GT(outcome.table.rows(), 3900U);
}

}  // namespace
