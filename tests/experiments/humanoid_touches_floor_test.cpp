// Chang fig. 6.3 and 6.4 on the humanoid's checked-in code: the physical claims. Would catch:
// null-space torques that affect a hand, a posture that has no effect, and hands that leave their
// paths.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "humanoid24_functions.hpp"
#include "servo/clock.hpp"
#include "touch_floor.hpp"

namespace treeline::experiments {
namespace {

constexpr int kJoints = Humanoid24::kVelocities;
constexpr int kRows = Humanoid24::kTaskRows;

const std::string kFolder = std::string(TREELINE_ROBOTS_DIR) + "/humanoid24/";

Plan the_plan() {
  Plan plan;
  std::string error;
  EXPECT_TRUE(read_plan(kFolder + "touch_floor.yaml", plan, error)) << error;
  return plan;
}

Outcome run(const Plan& plan) {
  JointLimits limits;
  std::string error;
  EXPECT_TRUE(read_limits(kFolder + "humanoid24.urdf", plan.joints, limits, error)) << error;
  servo::SimulatedClock clock;
  return touch_floor<Humanoid24>(plan, {}, limits, clock);
}

/// a^T M b.
double product(const double (&a)[kJoints], const double (&M)[kJoints * kJoints],
               const double (&b)[kJoints]) {
  double sum = 0.0;
  for (int i = 0; i < kJoints * kJoints; ++i) {
    sum += a[i / kJoints] * M[i] * b[i % kJoints];
  }
  return sum;
}

TEST(HumanoidTouchesFloor, WithBothHandsWhereTheyShallBe) {
  const Plan plan = the_plan();
  const Outcome outcome = run(plan);
  EXPECT_FALSE(outcome.fault);  // joints, velocities and torques stay within the URDF's limits
  EXPECT_TRUE(within_bounds(outcome)) << summary(outcome, plan, false);
  const std::size_t last = outcome.table.rows() - 1;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(outcome.table.at(last, 4 + i), plan.target[i], 1e-6);
  }
}

// "... without any additional commands": one stiffness for all joints, and which one matters
// little. 300 Hz is the thesis's rate. Would catch: a posture that needs each joint's own figure,
// springs that shake the light joints, and bounds that only the shorter period keeps.
TEST(HumanoidTouchesFloor, WithAnyOneStiffnessForAllJointsAlsoAtTheThesisRate) {
  for (const double rate : {1000.0, 300.0}) {
    for (const double spring : {10.0, 60.0, 200.0}) {
      Plan plan = the_plan();
      plan.rate = rate;
      plan.spring = spring;
      const Outcome outcome = run(plan);
      EXPECT_FALSE(outcome.fault) << rate << " Hz, " << spring << " N m/rad";
      EXPECT_TRUE(within_bounds(outcome)) << spring << summary(outcome, plan, false);
    }
  }
}

// J M^-1 times any torque of the null space is zero. The torque is the difference of two postures,
// so that everything else cancels. 1e-10 is the thesis's claim for zero, for accelerations of 1
// rad/s^2. The posture also has an effect: among all motions that do not move the hands, the body
// makes the one nearest to the desired one in the measure of kinetic energy (Gauss), so the
// difference is orthogonal to it.
TEST(HumanoidTouchesFloor, NullTorquesDoNotAccelerateTheHandsAndFollowTheAdvice) {
  const Plan plan = the_plan();
  std::mt19937_64 random(64);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  double worst = 0.0;
  for (int round = 0; round < 100; ++round) {
    double q[kJoints];
    const double rest[kJoints] = {};
    double posture[kJoints];
    const double none[kRows] = {};
    for (std::size_t i = 0; i < kJoints; ++i) {
      q[i] = plan.start[i] + 0.1 * number(random);
      posture[i] = number(random);
    }
    double tau[2][kJoints];
    double qdd[2][kJoints];
    humanoid24::control_torque(q, rest, rest, none, tau[0]);
    humanoid24::control_torque(q, rest, posture, none, tau[1]);
    humanoid24::forward_dynamics(q, rest, tau[0], qdd[0]);
    humanoid24::forward_dynamics(q, rest, tau[1], qdd[1]);
    double J[kRows * kJoints];
    humanoid24::jacobian(q, J);
    double response[kJoints];
    double withheld[kJoints];
    for (int i = 0; i < kJoints; ++i) {
      response[i] = qdd[1][i] - qdd[0][i];
      withheld[i] = posture[i] - response[i];
    }
    for (int row = 0; row < kRows; ++row) {
      double coupling = 0.0;
      for (int i = 0; i < kJoints; ++i) {
        coupling += J[row * kJoints + i] * response[i];
      }
      worst = std::max(worst, std::fabs(coupling));
    }
    double M[kJoints * kJoints];
    humanoid24::mass_matrix(q, M);
    const double energy = product(response, M, response);
    EXPECT_GT(energy, 0.1 * product(posture, M, posture)) << round;  // the body does move
    EXPECT_NEAR(product(response, M, withheld), 0.0, 1e-10 * energy) << round;
  }
  std::cout << "largest coupling " << worst << " m/s^2 or rad/s^2\n";
  EXPECT_LT(worst, 1e-10);
}

}  // namespace
}  // namespace treeline::experiments
