#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "puma_arm.hpp"
#include "puma_arm_controller.h"

namespace treeline::tests {

/// The controller with the PUMA that it drives: forward dynamics, semi-implicit Euler at the
/// controller's period.
class SimulatedArm {
 public:
  static constexpr int n = PUMA_ARM_JOINTS;

  SimulatedArm() {
    puma_arm_default_config(&config);
    for (int i = 0; i < n; ++i) input.q[i] = kHome[static_cast<std::size_t>(i)];
  }

  /// Sends a command with the next sequence number; it is taken in the next step.
  void send(puma_arm_kind kind) {
    input.command.kind = kind;
    ++input.command.sequence;
  }
  void move_joints(const std::array<double, 6>& goal, double duration) {
    for (int i = 0; i < n; ++i) input.command.goal[i] = goal[static_cast<std::size_t>(i)];
    input.command.duration = duration;
    send(PUMA_ARM_MOVE_JOINTS);
  }
  void move_point(const double (&position)[3], const double (&rotation)[9], double duration) {
    for (int i = 0; i < 3; ++i) input.command.position[i] = position[i];
    for (int i = 0; i < 9; ++i) input.command.rotation[i] = rotation[i];
    input.command.duration = duration;
    send(PUMA_ARM_MOVE_POINT);
  }
  void press(const double (&direction)[3], double force, double duration) {
    for (int i = 0; i < 3; ++i) input.command.direction[i] = direction[i];
    input.command.force = force;
    input.command.duration = duration;
    send(PUMA_ARM_PRESS);
  }

  void step() { puma_arm_step(&config, &state, &input, &output); }

  /// Lets the arm move for one period, under what the surroundings exert on joints.
  void move(const std::array<double, 6>& outside = {}) {
    double tau[n], qdd[n];
    for (int i = 0; i < n; ++i) tau[i] = output.tau[i] + outside[static_cast<std::size_t>(i)];
    puma_arm::forward_dynamics(input.q, input.qd, tau, qdd);
    for (int i = 0; i < n; ++i) {
      input.qd[i] += config.period * qdd[i];
      input.q[i] += config.period * input.qd[i];
    }
  }

  void run(double time) {
    for (int k = 0; k < static_cast<int>(std::lround(time / config.period)); ++k) {
      step();
      move();
    }
  }

  void pose(double (&position)[3], double (&rotation)[9]) const {
    puma_arm::forward_kinematics(input.q, position, rotation);
  }

  static constexpr std::array<double, 6> kHome = {0.3, -0.9, 0.6, 0.2, 0.8, -0.4};

  puma_arm_config config{};
  puma_arm_state state{};
  puma_arm_input input{};
  puma_arm_output output{};
};

/// Holds the joints for some time already.
inline SimulatedArm running() {
  SimulatedArm arm;
  arm.send(PUMA_ARM_START);
  arm.run(0.2);
  EXPECT_EQ(arm.output.mode, PUMA_ARM_RUNNING);
  return arm;
}

}  // namespace treeline::tests
