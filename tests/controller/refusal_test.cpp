// Would catch: commands that cannot be met and are taken, or are refused without the reason;
// motions that swing beyond a joint's limits; what went on before and does not go on after a
// refusal; commands that there are not, refused for another reason.
#include <cmath>
#include <limits>

#include "controller/simulated_arm.hpp"
#include "planar_arm_controller.h"

namespace treeline::tests {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expect_refused(SimulatedArm arm, puma_arm_refusal reason) {
  arm.step();
  EXPECT_EQ(arm.output.refused, static_cast<int>(reason));
  EXPECT_EQ(arm.output.mode, PUMA_ARM_RUNNING);
  arm.step();
  EXPECT_EQ(arm.output.refused, PUMA_ARM_ACCEPTED) << "no command any more";
}

TEST(Refusal, OfDurations) {
  for (const double duration : {0.0, -1.0, 1e-30, 0.9e-3, kNaN, kInfinity, -kInfinity, 3601.0}) {
    SCOPED_TRACE(duration);
    SimulatedArm joints = running();
    SimulatedArm point = joints;
    SimulatedArm press = joints;
    joints.move_joints({0, 0, 0.5, 0, 0.1, 0}, duration);
    expect_refused(joints, PUMA_ARM_REFUSED_DURATION);
    double position[3], rotation[9];
    point.pose(position, rotation);
    point.move_point(position, rotation, duration);
    expect_refused(point, PUMA_ARM_REFUSED_DURATION);
    press.press({0, 0, 1}, 10, duration);
    expect_refused(press, PUMA_ARM_REFUSED_DURATION);
  }
}

TEST(Refusal, OfGoals) {
  SimulatedArm far = running();
  SimulatedArm wild = far, tilted = far, endless = far;
  far.move_joints({0, 0, 10, 0, 0, 0}, 1);
  expect_refused(far, PUMA_ARM_REFUSED_LIMITS);
  wild.move_joints({0, 0, kNaN, 0, 0.1, 0}, 1);
  expect_refused(wild, PUMA_ARM_REFUSED_LIMITS);
  tilted.move_point({0.5, 0, 0.5}, {1, 0, 0, 0, 1, 0, 0, 0, -1}, 1);
  expect_refused(tilted, PUMA_ARM_REFUSED_NUMBERS);
  endless.move_point({0.5, kInfinity, 0.5}, {1, 0, 0, 0, 1, 0, 0, 0, 1}, 1);
  expect_refused(endless, PUMA_ARM_REFUSED_NUMBERS);
}

TEST(Refusal, OfForcesAndPoints) {
  SimulatedArm strong = running();
  SimulatedArm bent = strong, nowhere = strong;
  strong.press({0, 0, 1}, 1000, 1);
  expect_refused(strong, PUMA_ARM_REFUSED_FORCE);
  bent.press({0, 0, 2}, 10, 1);
  expect_refused(bent, PUMA_ARM_REFUSED_NUMBERS);
  for (const int point : {1, -1, 1 << 30}) {
    nowhere.input.command.point = point;
    nowhere.press({0, 0, 1}, 10, 1);
    expect_refused(nowhere, PUMA_ARM_REFUSED_POINT);
  }
}

TEST(Refusal, OfKindsAndModes) {
  SimulatedArm arm = running();
  SimulatedArm unknown = arm;
  for (const int kind : {7, 13, -1, 256, 260}) {  // the lowest eight bits of 256 are a stop's
    unknown.send(PUMA_ARM_START);
    unknown.input.command.kind = kind;
    expect_refused(unknown, PUMA_ARM_REFUSED_KIND);
  }
  arm.send(PUMA_ARM_START);
  expect_refused(arm, PUMA_ARM_REFUSED_MODE);
  arm.send(PUMA_ARM_LEAD_JOINTS);  // it does not comply
  expect_refused(arm, PUMA_ARM_REFUSED_MODE);
  SimulatedArm idle;
  idle.move_joints({0, 0, 0.5, 0, 0.1, 0}, 1);
  idle.step();
  EXPECT_EQ(idle.output.refused, PUMA_ARM_REFUSED_MODE);
  EXPECT_EQ(idle.output.mode, PUMA_ARM_IDLE);
  SimulatedArm blind;
  blind.input.qd[0] = kNaN;
  blind.send(PUMA_ARM_START);
  blind.step();
  EXPECT_EQ(blind.output.refused, PUMA_ARM_REFUSED_MEASUREMENT);
}

TEST(Refusal, OfWaysBeyondALimitWhileTheOldMotionGoesOn) {
  SimulatedArm arm = running();
  const double upper = arm.config.upper[2];
  arm.move_joints({0.3, -0.9, upper - 0.05, 0.2, 0.8, -0.4}, 1);
  arm.run(0.5);
  ASSERT_GT(arm.input.qd[2], 1);
  // From this speed a motion of three seconds swings out by a radian and more.
  arm.move_joints({0.3, -0.9, upper - 0.1, 0.2, 0.8, -0.4}, 3);
  arm.step();
  EXPECT_EQ(arm.output.refused, PUMA_ARM_REFUSED_LIMITS);
  arm.move();
  arm.run(1);
  EXPECT_EQ(arm.output.faults, 0U);
  EXPECT_NEAR(arm.input.q[2], upper - 0.05, 1e-3);
}

TEST(Refusal, NotOfMotionsThatOnlyTakeLonger) {
  SimulatedArm arm = running();
  arm.move_joints({0.3, -0.9, 1.6, 0.2, 0.8, -0.4}, 1e-3);
  arm.run(0.1);
  EXPECT_EQ(arm.output.refused, 0);
  // Back in the midst of the motion, at once: nothing gets faster than its limit.
  arm.move_joints({0.3, -0.9, 0.6, 0.2, 0.8, -0.4}, 1e-3);
  double peak = 0;
  for (int k = 0; k < 1500; ++k) {
    arm.step();
    arm.move();
    peak = std::max(peak, std::fabs(arm.input.qd[2]) / arm.config.speed[2]);
  }
  EXPECT_EQ(arm.output.faults, 0U);
  EXPECT_LT(peak, 1 + arm.config.speed_margin);
  EXPECT_NEAR(arm.input.q[2], 0.6, 1e-3);
}

TEST(Refusal, LeavesSpringsOfPointsWhereTheyPull) {
  SimulatedArm arm = running();
  for (int i = 0; i < 3; ++i) arm.config.point_stiffness[i] = 400;
  arm.send(PUMA_ARM_COMPLY);
  arm.run(0.2);
  for (int k = 0; k < 500; ++k) {
    arm.step();
    arm.move({0, 20, 0, 0, 0, 0});
  }
  const puma_arm_state before = arm.state;
  arm.move_point({1e6, 0, 0.5}, {1, 0, 0, 0, 1, 0, 0, 0, 1}, 1);
  arm.step();
  EXPECT_EQ(arm.output.refused, PUMA_ARM_REFUSED_DURATION);
  EXPECT_EQ(arm.state.law, before.law);
  for (int i = 0; i < 24; ++i) EXPECT_EQ(arm.state.point_motion[i], before.point_motion[i]) << i;
  for (int i = 0; i < 6; ++i) EXPECT_EQ(arm.state.posture[i], before.posture[i]) << i;
}

TEST(Refusal, OfKindsThatThereAreNotInWhateverMode) {
  SimulatedArm arm;
  for (const int kind : {7, 13, -1, 1 << 30}) {
    arm.send(static_cast<puma_arm_kind>(kind));
    arm.step();
    EXPECT_EQ(arm.output.refused, PUMA_ARM_REFUSED_KIND) << kind;
  }
  planar_arm_config config{};
  planar_arm_state state{};
  planar_arm_input input{};
  planar_arm_output output{};
  planar_arm_default_config(&config);
  for (const planar_arm_kind kind : {PLANAR_ARM_PRESS, PLANAR_ARM_LEAD_POINT}) {
    input.command.kind = kind;
    ++input.command.sequence;
    planar_arm_step(&config, &state, &input, &output);
    EXPECT_EQ(output.refused, PLANAR_ARM_REFUSED_KIND) << kind;
  }
}

}  // namespace
}  // namespace treeline::tests
