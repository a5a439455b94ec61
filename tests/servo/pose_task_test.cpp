// References compared with difference quotients, and the controller with two free-flying hands,
// whose task motion must obey the commanded error dynamics. Would catch: a rotation about the wrong
// axes, a velocity that is not the pose's derivative, swapped points, and a jump when a motion is
// replaced.
#include <gtest/gtest.h>

#include <cmath>

#include "servo/pose_reference.hpp"
#include "servo/pose_task_controller.hpp"
#include "servo/simulated_robot.hpp"
#include "servo/spring_posture.hpp"
#include "test_robots.hpp"

namespace {

using namespace treeline::servo;  // NOLINT: all of it is under test
using treeline::core::Gains;
using treeline::core::orientation_error;
using treeline::core::rotation_from_vector;
using treeline::test::TwoHands;

PoseReference turning() {
  const double from_vector[3] = {0.3, -0.2, 0.5};
  const double to_vector[3] = {-0.6, 0.8, 1.0};
  double from[9];
  double to[9];
  rotation_from_vector(from_vector, from);
  rotation_from_vector(to_vector, to);
  const double here[3] = {1.0, 2.0, 3.0};
  const double there[3] = {0.0, 2.5, 3.1};
  PoseReference reference;
  reference.move(10.0, here, from, there, to, 2.0);
  return reference;
}

TEST(PoseReference, VelocityAndAccelerationAreDerivatives) {
  const PoseReference reference = turning();
  const double h = 1e-5;
  for (double t = 10.1; t < 12.0; t += 0.2) {
    const PoseMotion before = reference.at(t - h);
    const PoseMotion now = reference.at(t);
    const PoseMotion after = reference.at(t + h);
    double turned[3];
    orientation_error(before.rotation, after.rotation, turned);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(now.velocity[i], (after.position[i] - before.position[i]) / (2 * h), 1e-8);
      EXPECT_NEAR(now.velocity[3 + i], turned[i] / (2 * h), 1e-8);
    }
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(now.acceleration[i], (after.velocity[i] - before.velocity[i]) / (2 * h), 1e-8);
    }
  }
}

TEST(PoseReference, BeginsAndEndsWhereItWasTold) {
  const PoseReference reference = turning();
  const PoseMotion begin = reference.at(9.0);
  const PoseMotion end = reference.at(13.0);
  EXPECT_EQ(begin.position[0], 1.0);
  EXPECT_NEAR(end.position[2], 3.1, 1e-15);
  const double to_vector[3] = {-0.6, 0.8, 1.0};
  double to[9];
  rotation_from_vector(to_vector, to);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(end.rotation[i], to[i], 1e-15);
  }
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(end.velocity[i], 0.0);
    EXPECT_EQ(begin.acceleration[i], 0.0);
  }
}

std::array<Gains<double>, 12> no_posture() {
  return {};
}

/// Runs the controller with simulated hands, without a loop.
void drive(PoseTaskController<TwoHands>& controller, SimulatedRobot<TwoHands>& robot, double from,
           double to) {
  const int cycles = static_cast<int>(std::lround((to - from) * 1000.0));
  for (int i = 0; i < cycles; ++i) {
    RobotState<12, 12> state;
    double tau[12];
    robot.read(state);
    controller.control(from + 0.001 * i, state, tau);
    robot.write(tau);
    robot.pass_time(0.001);
  }
}

TEST(PoseTaskController, AnErrorDiesOutAsItsGainsSay) {
  RobotState<12, 12> state;
  PoseTaskController<TwoHands> controller({100.0, 20.0}, no_posture());
  controller.start(0.0, state);
  state.q[1] = 0.01;  // left hand 10 mm to the left
  state.q[9] = 0.02;  // right hand turned 20 mrad about x
  SimulatedRobot<TwoHands> robot(state);
  drive(controller, robot, 0.0, 0.3);
  robot.read(state);
  // Critically damped from rest: (1 + w t) exp(-w t) with w = 10 /s, sampled at 1 kHz, so accurate
  // to about 1 %.
  const double left = (1.0 + 3.0) * std::exp(-3.0);
  EXPECT_NEAR(state.q[1] / 0.01, left, 0.01);
  EXPECT_NEAR(state.q[9] / 0.02, left, 0.01);
  EXPECT_NEAR(state.q[7], 0.0, 1e-12);
  EXPECT_NEAR(state.q[3], 0.0, 1e-12);
}

TEST(PoseTaskController, MovesOnePointAndReplacesTheMotionWithoutAJump) {
  RobotState<12, 12> state;
  SimulatedRobot<TwoHands> robot(state);
  PoseTaskController<TwoHands> controller({400.0, 40.0}, no_posture());
  controller.start(0.0, state);
  Message move;
  move.kind = MessageKind::move_point;
  move.index = 1;
  move.duration = 1.0;
  const double target[3] = {0.2, -0.4, 0.7};
  const double turn[3] = {0.3, 0.5, -0.4};
  double rotation[9];
  rotation_from_vector(turn, rotation);
  for (std::size_t i = 0; i < 3; ++i) {
    move.values[i] = target[i];
  }
  for (std::size_t i = 0; i < 9; ++i) {
    move.values[3 + i] = rotation[i];
  }
  controller.apply(0.0, move);
  drive(controller, robot, 0.0, 0.5);
  const PoseMotion halfway = controller.tracking(1).wanted;
  controller.apply(0.5, move);
  drive(controller, robot, 0.5, 0.501);
  EXPECT_NEAR(controller.tracking(1).wanted.position[0], halfway.position[0], 2e-3);
  drive(controller, robot, 0.501, 3.0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(controller.tracking(1).position[i], target[i], 1e-6);
    EXPECT_NEAR(controller.tracking(1).error[3 + i], 0.0, 1e-6);
    EXPECT_NEAR(controller.tracking(0).position[i], (i == 1 ? 0.5 : (i == 2 ? 1.0 : 0.0)), 1e-9);
  }
}

TEST(PoseTaskController, IgnoresWhatItCannotDo) {
  RobotState<12, 12> state;
  PoseTaskController<TwoHands> controller({400.0, 40.0}, no_posture());
  controller.start(0.0, state);
  Message move;
  move.kind = MessageKind::move_point;
  for (const int index : {-1, 2}) {
    move.index = index;
    move.duration = 1.0;
    controller.apply(0.0, move);
  }
  move.index = 0;
  move.duration = 0.0;
  controller.apply(0.0, move);
  double tau[12];
  controller.control(0.5, state, tau);
  EXPECT_EQ(controller.tracking(0).error[0], 0.0);
  EXPECT_EQ(controller.tracking(1).error[0], 0.0);
}

// The implicit law by hand, on two free balls whose inertia is 1 in x, y, z and 0.1 about an axis:
// (m + h d + h^2 k) qdd = k (q_advised - q - h qd) - d qd + push. Would catch: a damper that is not
// the joint's own, a push the wrong way, and a law that is not taken at the period's end.
TEST(SpringPosture, IsTheImplicitSpringOfEachJoint) {
  SpringSettings settings;
  settings.stiffness = 50.0;
  settings.margin = 0.2;
  settings.strength = 8.0;
  settings.period = 0.01;
  double lower[12];
  double upper[12];
  for (int i = 0; i < 12; ++i) {
    lower[i] = -1.0;
    upper[i] = 1.0;
  }
  const SpringPosture<TwoHands> posture(settings, lower, upper);
  RobotState<12, 12> state;
  double advised[12] = {};
  state.q[0] = 0.3;
  state.qd[0] = -0.4;
  advised[1] = 0.2;
  state.q[2] = 0.9;  // half of the margin: half of the push
  advised[2] = 0.9;
  state.q[9] = 0.1;  // about x, where the gimbals of a ball are independent
  double qdd[12];
  posture.advise(state, advised, qdd);
  const auto expected = [](double mass, double error, double rate, double push) {
    const double h = 0.01;
    const double k = 50.0;
    const double d = 2.0 * std::sqrt(k * mass);
    return (k * (error - h * rate) - d * rate + push) / (mass + h * d + h * h * k);
  };
  EXPECT_NEAR(qdd[0], expected(1.0, -0.3, -0.4, 0.0), 1e-12);
  EXPECT_NEAR(qdd[1], expected(1.0, 0.2, 0.0, 0.0), 1e-12);
  EXPECT_NEAR(qdd[2], expected(1.0, 0.0, 0.0, -4.0), 1e-12);
  EXPECT_NEAR(qdd[9], expected(0.1, -0.1, 0.0, 0.0), 1e-12);
  EXPECT_NEAR(qdd[5], 0.0, 1e-12);
}

// A spring that an explicit law could not bear: w h = 7.5 about the balls' axes at 300 Hz.
TEST(SpringPosture, ComesToRestWhereSpringsAreStiff) {
  SpringSettings settings;
  settings.stiffness = 5e5;
  settings.period = 1.0 / 300.0;
  double lower[12];
  double upper[12];
  for (int i = 0; i < 12; ++i) {
    lower[i] = -1.0;
    upper[i] = 1.0;
  }
  const SpringPosture<TwoHands> posture(settings, lower, upper);
  RobotState<12, 12> state;
  state.q[0] = 0.3;
  state.q[3] = 0.2;
  const double advised[12] = {};
  for (int i = 0; i < 300; ++i) {
    double qdd[12];
    posture.advise(state, advised, qdd);
    for (int j = 0; j < 12; ++j) {
      state.qd[j] += settings.period * qdd[j];
      state.q[j] += settings.period * state.qd[j];
      ASSERT_LT(std::fabs(state.q[j]), 0.31);
    }
  }
  EXPECT_NEAR(state.q[0], 0.0, 1e-6);
  EXPECT_NEAR(state.q[3], 0.0, 1e-6);
}

}  // namespace
