// Would catch: velocities from coordinates that are late by more than the header says, that swing
// behind a step, count a jump as motion, or come from input.qd after all; a motion that is followed
// worse by them than by measured ones.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "controller/simulated_arm.hpp"

namespace treeline::tests {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// An arm whose velocities nobody measures.
SimulatedArm observing(double observer) {
  SimulatedArm arm;
  arm.config.observer = observer;
  arm.config.hold_frequency = std::min(60.0, observer / 4);
  arm.config.hold_reach = 10;  // it stands idle, and is moved all the same
  for (double& qd : arm.input.qd) qd = kNaN;
  arm.step();
  EXPECT_EQ(arm.output.faults, 0U);
  return arm;
}

/// Velocity of joint 0 found after it moved along `q(t)`, s, for so long.
template <class Motion>
double observed(SimulatedArm& arm, double time, const Motion& q) {
  const double from = arm.input.q[0];
  const int steps = static_cast<int>(std::lround(time / arm.config.period));
  for (int k = 1; k <= steps; ++k) {
    arm.input.q[0] = from + q(k * arm.config.period);
    arm.step();
  }
  return arm.state.sound_qd[0];
}

TEST(Observer, FindsAConstantSpeed) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double observer : {50.0, 300.0, 500.0}) {
    for (int k = 0; k < 10; ++k) {
      SimulatedArm arm = observing(observer);
      const double speed = unit(rng);
      EXPECT_NEAR(observed(arm, 1, [&](double t) { return speed * t; }), speed, 1e-9) << observer;
    }
  }
}

TEST(Observer, IsAsLateAsItsHeaderSays) {
  for (const double observer : {100.0, 300.0}) {
    SimulatedArm arm = observing(observer);
    const double a = 0.8;
    const double found = observed(arm, 1, [&](double t) { return 0.5 * a * t * t; });
    EXPECT_NEAR(a - found, 2 * a / observer - 1.5 * a * arm.config.period, 1e-9);
  }
}

// Both poles are at p: behind a step d of q the velocity is (1 - p)^2 / T (k + 1) p^k d.
TEST(Observer, AnswersACountAsTwoPoles) {
  SimulatedArm arm = observing(300);
  const double T = arm.config.period, p = 1 - 300 * T, d = 1e-3;
  for (int k = 0; k < 40; ++k) {
    const double found = observed(arm, T, [&](double) { return k == 0 ? d : 0.0; });
    const double expected = (1 - p) * (1 - p) / T * (k + 1) * std::pow(p, k) * d;
    EXPECT_NEAR(found, expected, 1e-12) << k;
  }
}

TEST(Observer, TakesAJumpForNoMotion) {
  SimulatedArm arm = observing(300);
  const double before = observed(arm, 0.5, [](double t) { return 0.2 * t; });
  EXPECT_NEAR(observed(arm, arm.config.period, [](double) { return 0.2; }), before, 1e-12);
  EXPECT_EQ(arm.output.faults, static_cast<std::uint32_t>(PUMA_ARM_FAULT_JUMP));
  EXPECT_EQ(arm.output.brakes, 1);
}

TEST(Observer, GoesOnWhereACoordinateIsLost) {
  SimulatedArm arm = observing(300);
  const double before = observed(arm, 0.5, [](double t) { return 0.2 * t; });
  const double q = arm.input.q[0];
  arm.input.q[0] = kNaN;
  arm.step();
  EXPECT_EQ(arm.output.faults, static_cast<std::uint32_t>(PUMA_ARM_FAULT_MEASUREMENT));
  EXPECT_EQ(arm.state.sound_qd[0], before);
  EXPECT_NEAR(arm.state.sound_q[0], q + before * arm.config.period, 1e-15);
}

// A second in motion, of which the arm measures coordinates in counts of 5e-5 rad.
TEST(Observer, LeadsAMotion) {
  SimulatedArm real = running();
  SimulatedArm arm = real;  // what the controller sees of it
  arm.config.observer = 300;
  const std::array<double, 6> goal = {0.9, -0.4, 0.1, -0.4, 0.3, 0.4};
  double most = 0;
  for (int k = 0; k < 2000; ++k) {
    if (k == 200) arm.move_joints(goal, 1.2);
    for (int i = 0; i < SimulatedArm::n; ++i) {
      arm.input.q[i] = 5e-5 * std::round(real.input.q[i] / 5e-5);
      arm.input.qd[i] = kNaN;
    }
    arm.step();
    for (int i = 0; i < SimulatedArm::n; ++i) {
      real.output.tau[i] = arm.output.tau[i];
      most = std::max(most, std::fabs(arm.output.joint_error[i]));
    }
    real.move();
  }
  EXPECT_EQ(arm.output.faults, 0U);
  EXPECT_LT(most, 0.02);
  for (int i = 0; i < SimulatedArm::n; ++i) {
    EXPECT_NEAR(real.input.q[i], goal[static_cast<std::size_t>(i)], 5e-4) << i;
  }
}

TEST(Observer, HasToBeFasterThanWhatHolds) {
  SimulatedArm arm;
  std::int32_t index = -1;
  for (const double bad : {-1.0, 10.0, 239.0, 501.0, kNaN}) {
    arm.config.observer = bad;
    EXPECT_EQ(puma_arm_check_config(&arm.config, &index), PUMA_ARM_CONFIG_OBSERVER) << bad;
  }
}

TEST(Currents, AreTorquesOverGearAndMotor) {
  const double per_ampere[] = {-62.6111 * 0.223, 107.815 * 0.226, -53.7063 * 0.24,
                               76.0364 * 0.069,  71.923 * 0.072,  76.686 * 0.066};
  SimulatedArm arm = running();
  arm.move_joints({0.9, -0.4, 0.1, -0.4, 0.3, 0.4}, 1);
  arm.run(0.3);
  for (int i = 0; i < SimulatedArm::n; ++i) {
    EXPECT_NEAR(arm.output.current[i] * per_ampere[i], arm.output.tau[i], 1e-12) << i;
    EXPECT_GT(std::fabs(arm.output.current[i]), 0) << i;
  }
  arm.config.torque_per_ampere[3] = 0;
  std::int32_t index = -1;
  EXPECT_EQ(puma_arm_check_config(&arm.config, &index), PUMA_ARM_CONFIG_TORQUE_PER_AMPERE);
  EXPECT_EQ(index, 3);
  arm.step();
  EXPECT_TRUE(std::isfinite(arm.output.current[3]));  // by the defaults
}

}  // namespace
}  // namespace treeline::tests
