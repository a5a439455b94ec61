// Would catch, of the emitted controller with a simulated PUMA: laws that do not arrive, steps of
// torque where laws change, torque beyond a limit or in another direction, faults that are not
// seen or not braked, torque that is not finite.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "controller/simulated_arm.hpp"

namespace treeline::tests {
namespace {

constexpr int n = SimulatedArm::n;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double largest_difference(const double (&a)[n], const double (&b)[n]) {
  double most = 0;
  for (int i = 0; i < n; ++i) most = std::max(most, std::fabs(a[i] - b[i]));
  return most;
}

double fastest(const SimulatedArm& arm) {
  double most = 0;
  for (const double qd : arm.input.qd) most = std::max(most, std::fabs(qd));
  return most;
}

/// Lets torques change as fast as a law asks, to see the law itself.
void free_rates(SimulatedArm& arm) {
  for (double& rate : arm.config.torque_rate) rate = 1e9;
}

TEST(Controller, BeginsIdleAndHoldsTheRobot) {
  SimulatedArm arm;
  arm.run(1);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_IDLE);
  EXPECT_EQ(arm.output.faults, 0U);
  double g[n];
  puma_arm::gravity(arm.input.q, g);
  EXPECT_LT(largest_difference(arm.output.tau, g), 1e-9);
  for (int i = 0; i < n; ++i) EXPECT_NEAR(arm.input.q[i], SimulatedArm::kHome[i], 1e-9);
}

TEST(Controller, JointsFollowTheSplineAndArrive) {
  SimulatedArm arm = running();
  arm.move_joints({0.8, -0.4, 0.2, -0.5, 0.3, 0.6}, 1);
  double worst = 0;
  for (int k = 0; k < 1500; ++k) {
    arm.step();
    for (const double error : arm.output.joint_error) worst = std::max(worst, std::fabs(error));
    arm.move();
  }
  // The model is exact; what is left is the integrator's error of first order in the period.
  EXPECT_LT(worst, 2e-3);
  const double goal[n] = {0.8, -0.4, 0.2, -0.5, 0.3, 0.6};
  EXPECT_LT(largest_difference(arm.input.q, goal), 1e-6);
  EXPECT_LT(fastest(arm), 1e-5);
}

TEST(Controller, ShortMotionsAreStretchedToTheLimitsOfSpeed) {
  SimulatedArm arm = running();
  arm.move_joints({2.0, -2.4, 2.0, -0.5, 0.3, 0.6}, 0.01);
  double peak = 0;
  for (int k = 0; k < 1500; ++k) {
    arm.step();
    arm.move();
    for (int i = 0; i < n; ++i) {
      peak = std::max(peak, std::fabs(arm.input.qd[i]) / arm.config.speed[i]);
    }
  }
  EXPECT_EQ(arm.output.faults, 0U);
  EXPECT_LT(peak, 1 + arm.config.speed_margin);
  EXPECT_NEAR(arm.input.q[0], 2.0, 1e-4);
}

TEST(Controller, PointsFollowTheSplineAndArrive) {
  SimulatedArm arm = running();
  double position[3], rotation[9];
  arm.pose(position, rotation);
  const double goal[3] = {position[0] - 0.05, position[1] + 0.1, position[2] + 0.08};
  constexpr double c = 0.8, s = 0.6;  // a turn about the vertical
  const double about[9] = {c, -s, 0, s, c, 0, 0, 0, 1};
  double turned[9] = {};
  for (int i = 0; i < 27; ++i)
    turned[i / 3] += about[i / 9 * 3 + i % 3] * rotation[i % 3 * 3 + i / 3 % 3];
  arm.move_point(goal, turned, 1);
  arm.run(0.5);
  // A new goal in the midst of the motion: the reference goes on without a step.
  arm.move_point(goal, rotation, 1);
  double worst = 0;
  for (int k = 0; k < 1600; ++k) {
    arm.step();
    for (const double error : arm.output.task_error) worst = std::max(worst, std::fabs(error));
    arm.move();
  }
  EXPECT_LT(worst, 3e-3);
  arm.pose(position, rotation);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(position[i], goal[i], 1e-6);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_RUNNING);
}

/// The torque of the same state with and without a command: what the switch itself changes.
double step_of_switch(SimulatedArm arm, void (*command)(SimulatedArm&)) {
  arm.step();
  SimulatedArm other = arm;
  arm.step();
  command(other);
  other.step();
  return largest_difference(arm.output.tau, other.output.tau);
}

TEST(Controller, SwitchesWithoutAStepInTorque) {
  SimulatedArm arm = running();
  free_rates(arm);
  arm.move_joints({0.5, -0.7, 0.5, 0, 0.6, 0}, 1);
  arm.run(0.6);
  const auto to_task = [](SimulatedArm& each) {
    double position[3], rotation[9];
    each.pose(position, rotation);
    each.move_point(position, rotation, 1);
  };
  // Two steps of one state: the torque of the second differs by what the reference moved on.
  const double moving = step_of_switch(arm, [](SimulatedArm&) {});
  EXPECT_EQ(moving, 0);
  SimulatedArm still = running();
  free_rates(still);
  still.input.qd[1] = 0.5;  // pushed: the torque of both laws differs much
  EXPECT_LT(step_of_switch(still, to_task), 1e-9);
  still.config.fade = 0;
  EXPECT_GT(step_of_switch(still, to_task), 1);
  to_task(arm);
  arm.run(0.3);
  const auto to_force = [](SimulatedArm& each) { each.press({0, 0, -1}, 10, 0.5); };
  arm.input.qd[1] += 0.5;
  arm.config.fade = 0.1;
  // The law goes on from the same reference, which moves by less than a step's worth.
  EXPECT_LT(step_of_switch(arm, to_force), 0.2);
}

TEST(Controller, ScalesTheTorqueInItsDirection) {
  SimulatedArm arm = running();
  free_rates(arm);
  arm.input.qd[0] = 1.5;
  arm.input.qd[4] = -3;
  SimulatedArm free = arm, clamped = arm;
  for (double& torque : free.config.torque) torque = 1e6;
  arm.config.torque[0] = 30;
  clamped.config.torque[0] = 30;
  clamped.config.saturation = PUMA_ARM_CLAMP;
  arm.step();
  free.step();
  clamped.step();
  ASSERT_GT(std::fabs(free.output.tau[0]), 60);
  EXPECT_EQ(arm.output.saturated, 1);
  EXPECT_EQ(free.output.saturated, 0);
  double g[n];
  puma_arm::gravity(arm.input.q, g);
  for (int i = 0; i < n; ++i) {
    EXPECT_NEAR(arm.output.tau[i] - g[i], arm.output.factor * (free.output.tau[i] - g[i]), 1e-9);
    EXPECT_NEAR(clamped.output.tau[i], i == 0 ? -30 : free.output.tau[i], 1e-9);
  }
  EXPECT_NEAR(std::fabs(arm.output.tau[0]), 30, 1e-12);
  EXPECT_NEAR(arm.output.factor, clamped.output.factor, 1e-12);
}

TEST(Controller, BrakesToRestAndStaysHeldAfterStop) {
  SimulatedArm arm = running();
  arm.move_joints({0.8, -0.4, 0.2, -0.5, 0.3, 0.6}, 1);
  arm.run(0.5);
  ASSERT_GT(fastest(arm), 0.5);
  arm.send(PUMA_ARM_STOP);
  arm.step();
  EXPECT_EQ(arm.output.mode, PUMA_ARM_STOPPING);
  arm.run(1);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_IDLE);
  EXPECT_LT(fastest(arm), 1e-3);
}

void expect_fault(SimulatedArm arm, std::uint32_t fault) {
  arm.step();
  EXPECT_EQ(arm.output.mode, PUMA_ARM_FAULTED);
  EXPECT_EQ(arm.output.faults, fault);
}

TEST(Controller, FaultsOfMeasurementsAreSeen) {
  SimulatedArm arm = running();
  arm.config.jump = 1e9;
  arm.config.following = 1e9;
  SimulatedArm far = arm, fast = arm, blind = arm;
  far.input.q[2] = far.config.upper[2] + 0.9 * far.config.position_margin;
  far.step();
  EXPECT_EQ(far.output.mode, PUMA_ARM_RUNNING);
  far.input.q[2] = far.config.upper[2] + 1.1 * far.config.position_margin;
  expect_fault(far, PUMA_ARM_FAULT_POSITION);
  far.input.q[2] = far.config.lower[2] - 1.1 * far.config.position_margin;
  expect_fault(far, PUMA_ARM_FAULT_POSITION);
  fast.input.qd[3] = -1.05 * fast.config.speed[3];
  fast.step();
  EXPECT_EQ(fast.output.mode, PUMA_ARM_RUNNING);
  fast.input.qd[3] = -1.15 * fast.config.speed[3];
  expect_fault(fast, PUMA_ARM_FAULT_SPEED);
  blind.input.q[5] = kNaN;
  expect_fault(blind, PUMA_ARM_FAULT_MEASUREMENT);
  blind.input.q[5] = 0;
  blind.input.qd[0] = std::numeric_limits<double>::infinity();
  expect_fault(blind, PUMA_ARM_FAULT_MEASUREMENT);
  blind.input.qd[0] = 0;
  blind.input.force[1] = kNaN;
  expect_fault(blind, PUMA_ARM_FAULT_MEASUREMENT);
  arm.send(PUMA_ARM_EMERGENCY_STOP);
  expect_fault(arm, PUMA_ARM_FAULT_EMERGENCY);
}

TEST(Controller, StaleCommandsAreAFaultWhereAsked) {
  SimulatedArm arm = running();
  arm.config.stale_ticks = 20;
  arm.send(PUMA_ARM_KEEP_ALIVE);
  arm.run(0.02);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_RUNNING);
  arm.send(PUMA_ARM_KEEP_ALIVE);
  arm.run(0.02);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_RUNNING);
  arm.run(0.002);
  EXPECT_EQ(arm.output.faults, static_cast<std::uint32_t>(PUMA_ARM_FAULT_STALE));
}

TEST(Controller, HoldsWhatIsNotMeasuredForAWhileAndThenNothing) {
  SimulatedArm arm = running();
  double g[n];
  puma_arm::gravity(arm.input.q, g);
  arm.input.q[1] = kNaN;
  arm.input.qd[1] = kNaN;
  for (int k = 0; k < arm.config.blind_ticks; ++k) {
    arm.step();
    ASSERT_LT(largest_difference(arm.output.tau, g), 1e-6) << k;
    EXPECT_EQ(arm.output.brakes, 1) << k;
  }
  for (int k = 0; k < 30; ++k) arm.step();  // as fast as its rate lets the torque go
  EXPECT_EQ(arm.output.tau[1], 0);
  EXPECT_NEAR(arm.output.tau[2], g[2], 1e-6);
}

TEST(Controller, ArgumentsThatAreNotFiniteLeaveWhatHeldTheRobotLast) {
  SimulatedArm arm = running();
  double g[n];
  puma_arm::gravity(arm.input.q, g);
  arm.input.force[0] = kNaN;  // only the law of forces reads it
  arm.step();
  EXPECT_LT(largest_difference(arm.output.tau, g), 1e-6);
  EXPECT_EQ(arm.output.faults, static_cast<std::uint32_t>(PUMA_ARM_FAULT_MEASUREMENT));
  arm.input.force[0] = 0;
  arm.run(0.5);
  arm.send(PUMA_ARM_RESET);
  arm.step();
  EXPECT_EQ(arm.output.mode, PUMA_ARM_IDLE);
  EXPECT_EQ(arm.output.faults, 0U);
  EXPECT_EQ(arm.output.reason, 0U);
  EXPECT_EQ(arm.output.brakes, 0);
}

TEST(Controller, AJointBeyondItsLimitCanBeLedBackAfterAReset) {
  SimulatedArm arm;
  arm.input.q[2] = arm.config.upper[2] + 0.3;
  arm.step();
  EXPECT_EQ(arm.output.mode, PUMA_ARM_FAULTED);
  arm.send(PUMA_ARM_RESET);
  arm.step();
  EXPECT_EQ(arm.output.mode, PUMA_ARM_IDLE);
  arm.send(PUMA_ARM_START);
  arm.step();
  arm.move_joints({0.3, -0.9, 3.5, 0.2, 0.8, -0.4}, 1);
  arm.run(1.5);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_RUNNING);
  EXPECT_NEAR(arm.input.q[2], 3.5, 1e-3);
  arm.input.q[2] = arm.config.upper[2] + 0.3;  // what was admitted is not any more
  arm.step();
  EXPECT_EQ(arm.output.mode, PUMA_ARM_FAULTED);
}

/// Pushes the arm against a wall of springs below it; returns the force, N, after some time.
double press_against_wall(SimulatedArm& arm, double wanted, double gap, double time) {
  constexpr double kStiffness = 20000;  // N/m
  double position[3], rotation[9], J[6 * n];
  arm.pose(position, rotation);
  const double wall = position[2] - gap;
  arm.move_point(position, rotation, 1);
  arm.run(0.1);
  arm.press({0, 0, -1}, wanted, 0.5);
  double force = 0;
  for (int k = 0; k < static_cast<int>(time * 1000); ++k) {
    arm.pose(position, rotation);
    puma_arm::jacobian(arm.input.q, J);
    force = std::max(0.0, kStiffness * (wall - position[2]));
    std::array<double, 6> outside{};
    for (int i = 0; i < n; ++i) outside[static_cast<std::size_t>(i)] = J[2 * n + i] * force;
    arm.input.force[2] = -force;
    arm.step();
    arm.move(outside);
  }
  return force;
}

TEST(Controller, PressesWithTheForceThatIsWanted) {
  SimulatedArm arm = running();
  EXPECT_NEAR(press_against_wall(arm, 20, 0.01, 6), 20, 0.1);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_RUNNING);
  for (int i = 0; i < 2; ++i) EXPECT_LT(std::fabs(arm.output.task_error[i]), 2e-3);
}

// Would catch: a point that presses in another direction, and is thrown back to where it began to
// press in the first.
TEST(Controller, PressesInAnotherDirectionFromWhereItGotTo) {
  SimulatedArm arm = running();
  double begin[3], from[3], to[3], rotation[9];
  arm.pose(begin, rotation);
  arm.press({0, 0, -1}, 20, 0.5);
  arm.run(4);
  arm.pose(from, rotation);
  arm.press({1, 0, 0}, 2, 0.5);
  arm.run(1);
  arm.pose(to, rotation);
  EXPECT_EQ(arm.output.faults, 0U);
  EXPECT_LT(from[2], begin[2] - 0.05) << "it approached";
  EXPECT_NEAR(to[2], from[2], 1e-3);
}

TEST(Controller, TheIntegralDoesNotWindUp) {
  SimulatedArm arm = running();
  arm.config.force_rate = 50;
  press_against_wall(arm, 40, 1, 1);  // there is no wall
  EXPECT_LE(std::fabs(arm.state.force_integral), arm.config.largest_force);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_RUNNING);
}

TEST(Controller, WhateverIsMeasuredTheTorqueIsFiniteAndWithinLimits) {
  constexpr unsigned kSeed = 71;
  std::mt19937 rng(kSeed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const double odd[] = {kNaN, 1e300, -1e300, std::numeric_limits<double>::infinity(), 1e9, 0};
  SimulatedArm arm;
  for (int k = 0; k < 20000; ++k) {
    for (int i = 0; i < n; ++i) {
      arm.input.q[i] = 3 * unit(rng);
      arm.input.qd[i] = 8 * unit(rng);
    }
    if (rng() % 10 == 0) arm.input.q[rng() % 6] = odd[rng() % 6];
    if (rng() % 10 == 0) arm.input.qd[rng() % 6] = odd[rng() % 6];
    if (rng() % 10 == 0) arm.input.command.goal[rng() % 6] = odd[rng() % 6];
    arm.input.command.position[rng() % 3] = rng() % 9 == 0 ? odd[rng() % 6] : unit(rng);
    for (int i = 0; i < 9; ++i) arm.input.command.rotation[i] = i % 4 == 0 ? 1 : 0;
    arm.input.command.direction[rng() % 3] = unit(rng) > 0 ? 1 : 0;
    arm.input.command.duration = rng() % 8 == 0 ? odd[rng() % 6] : unit(rng);
    arm.send(static_cast<puma_arm_kind>(rng() % 11));
    if (rng() % 3 == 0) arm.send(PUMA_ARM_RESET);
    if (rng() % 3 == 0) arm.send(PUMA_ARM_START);
    arm.step();
    ASSERT_GE(arm.output.mode, 0);
    ASSERT_LE(arm.output.mode, 3);
    for (int i = 0; i < n; ++i) {
      ASSERT_LE(std::fabs(arm.output.tau[i]), arm.config.torque[i])
          << "step " << k << " seed " << kSeed;
    }
  }
}

}  // namespace
}  // namespace treeline::tests
