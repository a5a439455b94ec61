// Friction and backlash, compared with results that are known without the code. Would catch: teeth
// that pull, a play of the wrong width, friction that drives or dissipates the wrong energy, a
// motor without its rotor, and rotors or friction that count twice.
#include "servo/geared_robot.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace treeline::servo;  // NOLINT: all of it is under test

/// One wheel of 2 kg m^2.
struct Wheel {
  static constexpr int kCoordinates = 1;
  static constexpr int kVelocities = 1;
  static constexpr bool kDrivesInJoints = false;
  static constexpr double kInertia = 2.0;
  static void forward_dynamics(const double (&)[1], const double (&)[1], const double (&tau)[1],
                               double (&qdd)[1]) noexcept {
    qdd[0] = tau[0] / kInertia;
  }
};

/// A wheel whose forward dynamics has rotors and friction of its own.
struct DrivenWheel : Wheel {
  static constexpr bool kDrivesInJoints = true;
};
/// Nothing is said of them.
struct SilentWheel {
  static constexpr int kCoordinates = 1;
  static constexpr int kVelocities = 1;
  static void forward_dynamics(const double (&)[1], const double (&)[1], const double (&)[1],
                               double (&)[1]) noexcept {}
};

// Rotors and friction cannot count twice.
static_assert(DrivenFunctions<Wheel>);
static_assert(!DrivenFunctions<DrivenWheel> && SimulatedFunctions<DrivenWheel>);
static_assert(!DrivenFunctions<SilentWheel> && SimulatedFunctions<SilentWheel>);

StateOf<Wheel> state(double q, double qd) {
  StateOf<Wheel> result;
  result.q[0] = q;
  result.qd[0] = qd;
  return result;
}

double motor_speed(const GearedRobot<Wheel>& robot) {
  StateOf<Wheel> seen;
  robot.read(seen);
  return seen.qd[0];
}

TEST(GearTorque, TeethPushAndNeverPull) {
  const GearBacklash gear{0.02, 1000.0, 50.0};
  EXPECT_EQ(gear_torque(gear, 0.009, 5.0), 0.0);
  EXPECT_EQ(gear_torque(gear, -0.009, -5.0), 0.0);
  EXPECT_NEAR(gear_torque(gear, 0.013, 0.0), 3.0, 1e-12);
  EXPECT_NEAR(gear_torque(gear, -0.013, 0.0), -3.0, 1e-12);
  EXPECT_NEAR(gear_torque(gear, 0.013, 0.01), 3.5, 1e-12);
  EXPECT_EQ(gear_torque(gear, 0.013, -1.0), 0.0);
  EXPECT_EQ(gear_torque({0.0, 1000.0, 50.0}, 0.001, -1.0), 1.0 - 50.0);  // without play it can
}

TEST(FrictionTorque, OpposesAndLevelsOff) {
  const JointFriction friction{3.0, 2.0, 0.01};
  EXPECT_EQ(friction_torque(friction, 0.0), 0.0);
  EXPECT_NEAR(friction_torque(friction, 1.0), 5.0, 1e-12);
  EXPECT_NEAR(friction_torque(friction, -1.0), -5.0, 1e-12);
  EXPECT_EQ(friction_torque({}, 1.0), 0.0);
}

// The motor, 1 kg m^2 under 1 N m, crosses half of its play of 0.02 rad alone: sqrt(2 x 0.01 s) =
// 0.141 s. Until then the wheel is at rest.
TEST(GearedRobot, CrossesItsPlayAloneAndThenDrivesTheWheel) {
  GearedRobot<Wheel> robot(state(0, 0), {Drive{1.0, {}, {0.02, 1e5, 100.0}}});
  robot.write({1.0});
  for (int i = 0; i < 140; ++i) robot.pass_time(1e-3);
  EXPECT_EQ(robot.links().q[0], 0.0);
  EXPECT_NEAR(motor_speed(robot), 0.14, 1e-12);
  for (int i = 0; i < 860; ++i) robot.pass_time(1e-3);
  // Momentum: 1 N m for 1 s, whatever happens at the teeth.
  EXPECT_NEAR(motor_speed(robot) + Wheel::kInertia * robot.links().qd[0], 1.0, 1e-9);
  EXPECT_GT(robot.links().qd[0], 0.3);
}

// Without friction, damping and torque nothing dissipates energy: the wheel rattles forever.
TEST(GearedRobot, RattlesWithoutLoss) {
  const GearBacklash gear{0.02, 1e4, 0.0};
  GearedRobot<Wheel> robot(state(0, 1), {Drive{1.0, {}, gear}}, 64);
  const auto energy = [&] {
    StateOf<Wheel> motor;
    robot.read(motor);
    const double v = robot.links().qd[0];
    const double depth = std::fmax(std::fabs(motor.q[0] - robot.links().q[0]) - 0.01, 0.0);
    return 0.5 * motor.qd[0] * motor.qd[0] + 0.5 * Wheel::kInertia * v * v +
           0.5 * gear.stiffness * depth * depth;
  };
  robot.write({2.0});
  for (int i = 0; i < 100; ++i) robot.pass_time(1e-3);
  robot.write({0.0});
  const double before = energy();
  for (int i = 0; i < 2000; ++i) robot.pass_time(1e-3);
  // Steps across the corners of the play's law: measured 1e-7.
  EXPECT_NEAR(energy() / before, 1.0, 1e-5);
}

// Coulomb friction of 3 N m stops 3 kg m^2 rotating at 1 rad/s in 1 s, linearly.
TEST(GearedRobot, CoulombFrictionStopsLinearly) {
  GearedRobot<Wheel> robot(state(0, 1), {Drive{1.0, {3.0, 0.0, 1e-3}, {0.0, 1e5, 300.0}}});
  for (int i = 0; i < 500; ++i) robot.pass_time(1e-3);
  EXPECT_NEAR(robot.links().qd[0], 0.5, 1e-3);
  for (int i = 0; i < 600; ++i) robot.pass_time(1e-3);
  EXPECT_NEAR(robot.links().qd[0], 0.0, 1e-4);
}

}  // namespace
