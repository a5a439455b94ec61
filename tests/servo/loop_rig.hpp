#pragma once
// A two-link arm under the servo loop, for tests of the loop and of what runs it.

#include <gtest/gtest.h>

#include <cmath>

#include "servo/loop.hpp"
#include "servo/simulated_robot.hpp"
#include "test_robots.hpp"

namespace treeline::test {

using servo::LoopSettings;
using servo::Mailbox;
using servo::Message;
using servo::MessageKind;
using servo::Report;
using servo::RobotState;
using servo::SafetyLimits;
using servo::ServoLoop;
using servo::SimulatedClock;
using servo::SimulatedRobot;

/// Follows a sinusoid about its initial state by computed torque.
struct Swing {
  double begin = 0.0;
  double centre[2] = {};
  double spoil = 0.0;  ///< added to the first torque
  int applied = 0;
  int prepared = 0;
  void prepare() { ++prepared; }
  void start(double time, const RobotState<2, 2>& state) {
    begin = time;
    centre[0] = state.q[0];
    centre[1] = state.q[1];
  }
  void apply(double, const Message&) { ++applied; }
  void control(double time, const RobotState<2, 2>& state, double (&tau)[2]) const {
    const double wanted = 0.2 * (1.0 - std::cos(time - begin));
    double qdd[2];
    for (int i = 0; i < 2; ++i) {
      qdd[i] = 0.2 * std::cos(time - begin) + 20.0 * (0.2 * std::sin(time - begin) - state.qd[i]) +
               100.0 * (centre[i] + wanted - state.q[i]);
    }
    TwoLink::inverse_dynamics(state.q, state.qd, qdd, tau);
    tau[0] += spoil;
  }
};

inline const auto nobody = [](const Report<TwoLink>&) {};

/// An arm, its loop and its front end.
struct Rig {
  RobotState<2, 2> initial{{0.2, 0.4}, {0.0, 0.0}};
  SimulatedRobot<TwoLink> robot{initial};
  Swing controller;
  SimulatedClock clock;
  Mailbox mailbox;
  SafetyLimits<2, 2> limits;
  LoopSettings settings;
  ServoLoop<TwoLink, SimulatedRobot<TwoLink>, Swing, SimulatedClock> loop{
      settings, make_limits(), robot, controller, clock, mailbox};

  static SafetyLimits<2, 2> make_limits() {
    SafetyLimits<2, 2> limits;
    limits.lower = {-2.0, -2.0};
    limits.upper = {2.0, 2.0};
    limits.velocity = {5.0, 5.0};
    limits.torque = {60.0, 30.0};
    return limits;
  }
  void send(MessageKind kind) { ASSERT_TRUE(mailbox.push(servo::message_of(kind))); }
  void cycles(int count) {
    for (int i = 0; i < count; ++i) {
      ASSERT_TRUE(loop.step(nobody));
    }
  }
  RobotState<2, 2> state() const {
    RobotState<2, 2> now;
    robot.read(now);
    return now;
  }
};

}  // namespace treeline::test
