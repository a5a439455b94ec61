// Would catch: a controller of a task with some rows, in the point's own axes, that does not reach
// the pose; known forces or a payload that it does not compensate, or that makes torques jump;
// sliding joints that it takes for hinges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "samm_arm.hpp"
#include "samm_arm_controller.h"

namespace treeline::tests {
namespace {

constexpr int n = SAMM_ARM_JOINTS;

struct Mobile {
  samm_arm_config config{};
  samm_arm_state state{};
  samm_arm_input input{};
  samm_arm_output output{};

  Mobile() {
    samm_arm_default_config(&config);
    const double home[n] = {0.1, -0.2, 0.4, 0.3, -0.9, 0.6, 0.2, 0.8, -0.4};
    for (int i = 0; i < n; ++i) input.q[i] = home[i];
    input.payload[0] = 2;     // kg
    input.payload[3] = 0.2;   // kg m, along z
    input.payload[4] = 0.03;  // kg m^2
    input.payload[6] = 0.03;
    input.payload[9] = 0.01;
    input.f_ext[2] = -15;
    input.f_ext[0] = 5;
  }

  void run(int steps) {
    for (int k = 0; k < steps; ++k) {
      samm_arm_step(&config, &state, &input, &output);
      double qdd[n];
      samm_arm::forward_dynamics(input.q, input.qd, output.tau, input.f_ext, input.payload, qdd);
      for (int i = 0; i < n; ++i) {
        input.qd[i] += config.period * qdd[i];
        input.q[i] += config.period * input.qd[i];
      }
    }
  }
};

TEST(ControllerRows, ReachThePoseUnderKnownForcesAndPayload) {
  static_assert(n == 9, "three of the base, six of the arm");
  Mobile mobile;
  mobile.input.command.kind = SAMM_ARM_START;
  mobile.input.command.sequence = 1;
  mobile.run(100);
  ASSERT_EQ(mobile.output.mode, SAMM_ARM_RUNNING);
  double p[3], R[9];
  samm_arm::forward_kinematics(mobile.input.q, p, R);
  samm_arm_command& command = mobile.input.command;
  command.kind = SAMM_ARM_MOVE_POINT;
  ++command.sequence;
  command.duration = 1;
  for (int i = 0; i < 3; ++i) command.position[i] = p[i] + (i == 2 ? -0.05 : 0.05);
  for (int i = 0; i < 9; ++i) command.rotation[i] = R[i];
  mobile.run(8000);
  EXPECT_EQ(mobile.output.mode, SAMM_ARM_RUNNING);
  EXPECT_EQ(mobile.output.refused, 0);
  EXPECT_EQ(mobile.output.unmet, 0);
  double reached[3], R_reached[9];
  samm_arm::forward_kinematics(mobile.input.q, reached, R_reached);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(reached[i], command.position[i], 1e-4) << i;
  // The row rx of the point's own axes is held: its turn about its own x axis.
  double turn = 0;
  for (int k = 0; k < 3; ++k) turn += R_reached[3 * k] * mobile.output.task_error[3 + k];
  EXPECT_NEAR(turn, 0, 1e-4);
  for (const double qd : mobile.input.qd) EXPECT_LT(std::fabs(qd), 0.02);
}

TEST(ControllerRows, HoldsTheRobotUnderKnownForcesAndPayload) {
  Mobile mobile;
  mobile.input.command.kind = SAMM_ARM_START;
  mobile.input.command.sequence = 1;
  mobile.run(1000);
  const double home[n] = {0.1, -0.2, 0.4, 0.3, -0.9, 0.6, 0.2, 0.8, -0.4};
  for (int i = 0; i < n; ++i) EXPECT_NEAR(mobile.input.q[i], home[i], 1e-9) << i;
}

// A payload that is told in the midst of holding changes no torque by more than its share of a
// step, and is compensated in the end.
TEST(ControllerRows, LeadTheTorqueToAnotherPayload) {
  Mobile mobile;
  mobile.input.command.kind = SAMM_ARM_START;
  mobile.input.command.sequence = 1;
  mobile.run(100);
  double before[n], worst = 0, whole = 0, first[n];
  for (int i = 0; i < n; ++i) before[i] = first[i] = mobile.output.tau[i];
  mobile.input.payload[0] = 6;
  mobile.input.payload[3] = 0.9;
  for (int k = 0; k < 300; ++k) {
    samm_arm_step(&mobile.config, &mobile.state, &mobile.input, &mobile.output);
    for (int i = 0; i < n; ++i) {
      worst = std::max(worst, std::fabs(mobile.output.tau[i] - before[i]));
      whole = std::max(whole, std::fabs(mobile.output.tau[i] - first[i]));
      before[i] = mobile.output.tau[i];
    }
  }
  EXPECT_GT(whole, 5);
  EXPECT_LE(worst, 0.0401 * whole);
  Mobile told;
  for (int i = 0; i < 10; ++i) told.input.payload[i] = mobile.input.payload[i];
  for (int i = 0; i < n; ++i) told.input.q[i] = mobile.input.q[i];
  told.run(1);
  EXPECT_LT(std::fabs(told.state.held[4] - mobile.state.held[4]), 1e-3);
}

/// Would catch: a torque that holds the robot at rest without the payload that was told.
TEST(ControllerRows, KnowWhatHoldsThePayloadAtRest) {
  Mobile mobile;
  for (double& each : mobile.input.f_ext) each = 0;
  mobile.run(1);
  const double still[n] = {};
  double wanted[n];
  samm_arm::inverse_dynamics(mobile.input.q, still, still, mobile.input.f_ext, mobile.input.payload,
                             wanted);
  for (int i = 0; i < n; ++i) EXPECT_NEAR(mobile.state.held[i], wanted[i], 1e-6) << i;
  EXPECT_GT(std::fabs(wanted[4]), 1);
}

/// Would catch: an arm whose joints are all measured, and which is let go since a number of its
/// payload, or of a force that is known, stays lost.
TEST(ControllerRows, HoldWithTheLastPayloadAndForceThatWereTold) {
  for (const bool payload : {true, false}) {
    Mobile mobile;
    mobile.input.command.kind = SAMM_ARM_START;
    mobile.input.command.sequence = 1;
    mobile.run(1000);
    const samm_arm_input sound = mobile.input;
    double qdd[n];
    for (int k = 0; k < 1000; ++k) {
      (payload ? mobile.input.payload[3] : mobile.input.f_ext[2]) = std::nan("");
      samm_arm_step(&mobile.config, &mobile.state, &mobile.input, &mobile.output);
      samm_arm::forward_dynamics(mobile.input.q, mobile.input.qd, mobile.output.tau, sound.f_ext,
                                 sound.payload, qdd);
      for (int i = 0; i < n; ++i) {
        mobile.input.qd[i] += mobile.config.period * qdd[i];
        mobile.input.q[i] += mobile.config.period * mobile.input.qd[i];
      }
    }
    EXPECT_EQ(mobile.output.faults, static_cast<unsigned>(SAMM_ARM_FAULT_MEASUREMENT));
    for (int i = 0; i < n; ++i) EXPECT_NEAR(mobile.input.q[i], sound.q[i], 1e-6) << i;
  }
}

/// Would catch: a robot that rests, of which nothing can be computed any more since the payload is
/// told so, whose torque is taken away without a fault and without brakes.
TEST(ControllerRows, BrakeWherePayloadsMakeTorquesInfinite) {
  Mobile mobile;
  mobile.run(50);
  EXPECT_EQ(mobile.output.faults, 0U);
  mobile.config.fade = 0;
  mobile.input.payload[0] = 1.7e308;
  for (int k = 0; k < 200 && mobile.output.faults == 0; ++k) {
    samm_arm_step(&mobile.config, &mobile.state, &mobile.input, &mobile.output);
  }
  EXPECT_EQ(mobile.output.faults, static_cast<unsigned>(SAMM_ARM_FAULT_TORQUE));
  EXPECT_EQ(mobile.output.brakes, 1);
  // What held it at rest goes on, and no torque at its limit.
  for (int k = 0; k < 200; ++k) {
    samm_arm_step(&mobile.config, &mobile.state, &mobile.input, &mobile.output);
  }
  for (int i = 0; i < n; ++i) {
    EXPECT_LE(std::fabs(mobile.output.tau[i]), 0.5 * mobile.config.torque[i]) << i;
  }
}

}  // namespace
}  // namespace treeline::tests
