// Chang appendix A on the PUMA 560: the physical claims. Would catch: a lost direction of the wrong
// type, a torque without bound, a NaN anywhere, and an arm that cannot leave a singularity or
// leaves it on the wrong side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "lock_run.hpp"

namespace treeline::experiments {

void PrintTo(Lock lock, std::ostream* out) {
  *out << name_of(lock);
}

namespace {

void expect_type(const double (&q)[6], core::SingularityType type) {
  const WeakestDirection found = look_at_direction(q, 5);
  EXPECT_LT(found.all.values[5], 1e-6);
  EXPECT_EQ(found.type, type) << "curvature " << found.lost.curvature;
}

TEST(Singularity, ThreeLocksOfThePumaAreRecognisedAndTyped) {
  const double elbow[6] = {0.3, -0.9, elbow_lock(), 0.2, 1.2, -0.4};
  const double head[6] = {0.3, overhead(0.6), 0.6, 0.2, 1.2, -0.4};
  const double wrist[6] = {0.3, -0.9, elbow_lock() + 1.2, 0.2, 0.0, -0.4};
  const double regular[6] = {0.3, -0.9, elbow_lock() + 1.2, 0.2, 1.2, -0.4};
  expect_type(elbow, core::SingularityType::moves_along);
  expect_type(head, core::SingularityType::moves_along);
  expect_type(wrist, core::SingularityType::turns);
  EXPECT_GT(look_at_direction(regular, 5).all.values[5], 0.1);
}

// The null motion of the head lock rotates joint 1, that of the elbow lock bends joint 3, that of
// the wrist lock rotates joint 4 against joint 6.
TEST(Singularity, NullMotionsAreThoseOfTheLocks) {
  const double head[6] = {0.3, overhead(0.6), 0.6, 0.2, 1.2, -0.4};
  const double wrist[6] = {0.3, -0.9, elbow_lock() + 1.2, 0.2, 0.0, -0.4};
  const double elbow[6] = {0.3, -0.9, elbow_lock(), 0.0, 1.2, 0.0};
  EXPECT_GT(std::fabs(look_at_direction(head, 5).motion[0]), 0.3);
  const WeakestDirection turning = look_at_direction(wrist, 5);
  EXPECT_NEAR(turning.motion[3], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(turning.motion[5], -std::sqrt(0.5), 1e-6);
  const WeakestDirection bending = look_at_direction(elbow, 5);
  EXPECT_GT(bending.motion[2], 0.5);
  EXPECT_NEAR(bending.motion[1], -0.5 * bending.motion[2], 0.02);
}

class Locks : public testing::TestWithParam<Lock> {};

INSTANTIATE_TEST_SUITE_P(All, Locks, testing::ValuesIn(kLocks));

TEST_P(Locks, AreEnteredPassedAndLeft) {
  std::vector<LockRun> runs;
  for (const Strategy strategy : kStrategies) runs.push_back(run_lock(GetParam(), strategy));
  EXPECT_TRUE(lock_claim_holds(GetParam(), runs)) << lock_summary(GetParam(), runs);
}

TEST(Singularity, ElbowComesBackOnTheSideAskedFor) {
  const double start = make_path(Lock::elbow).start[2];
  const LockFigures through = run_lock(Lock::elbow, Strategy::singular, 1.0).figures;
  const LockFigures back = run_lock(Lock::elbow, Strategy::singular, -1.0).figures;
  EXPECT_NEAR(through.final_q[2], 2.0 * elbow_lock() - start, 1e-3);
  EXPECT_NEAR(back.final_q[2], start, 1e-3);
  EXPECT_LT(back.final_position_error, 1e-5);
}

// Joint 1 rotates by the change of its azimuth to the wrist as the arm leans to the other side, or
// not.
TEST(Singularity, ShoulderComesBackOnTheSideAskedFor) {
  const LockPath path = make_path(Lock::head);
  const double* start = path.start;
  const LockFigures through = run_lock(Lock::head, Strategy::singular, 1.0).figures;
  const LockFigures back = run_lock(Lock::head, Strategy::singular, -1.0).figures;
  EXPECT_NEAR(through.final_q[0] - start[0], 2.0 * std::atan2(0.1501, 0.1) - std::acos(-1.0), 1e-3);
  EXPECT_NEAR(through.final_q[2], start[2], 1e-3);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(back.final_q[i], start[i], 1e-3);
}

// The lock is where `overhead` says: the wrist's centre comes no nearer than the offset.
TEST(Singularity, OverheadPutsTheWristOverTheAxis) {
  for (const double ahead : {0.0, 0.1, -0.07}) {
    const double q[6] = {0.0, overhead(2.3, ahead), 2.3, 0.4, 0.8, 0.0};
    double position[3];
    double rotation[9];
    puma560::forward_kinematics(q, position, rotation);
    EXPECT_NEAR(position[0] - 0.05625 * rotation[2], ahead, 1e-12);
    EXPECT_NEAR(position[1] - 0.05625 * rotation[5], 0.1501, 1e-12);
    EXPECT_GT(position[2], 1.0);
  }
}

// At any configuration, exactly at every combination of locks, and very near them: finite and
// bounded.
TEST(Singularity, TorqueIsBoundedEverywhere) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> angle(-3.0, 3.0);
  const double beside[] = {0.0, 1e-300, 1e-12, -1e-9, 1e-6, -1e-3, 1e-2};
  double largest = 0.0;
  for (int round = 0; round < 2000; ++round) {
    double q[6];
    double qd[6];
    ToolCommand command;
    for (int i = 0; i < 6; ++i) {
      q[i] = angle(random);
      qd[i] = angle(random) / 6.0;
      command.acceleration[i] = angle(random);
      command.displacement[i] = round % 5 == 0 ? 0.0 : angle(random) / 10.0;
    }
    const double off = beside[round % 7];
    if (round % 2 == 0) q[4] = off;
    if (round % 3 == 0) q[2] = elbow_lock() + off;
    if (round % 4 == 0) q[1] = overhead(q[2]) + off;
    double tau[6];
    control(Strategy::singular, q, qd, command, round % 2 == 0 ? 1.0 : -1.0, tau);
    for (const double torque : tau) {
      ASSERT_TRUE(std::isfinite(torque)) << "round " << round;
      largest = std::max(largest, std::fabs(torque));
    }
  }
  // Accelerations of 5 m/s^2 where a singular value of 0.04 is still used: 10 times what they need
  // far from singularities.
  EXPECT_LT(largest, 2000.0);
}

}  // namespace
}  // namespace treeline::experiments
