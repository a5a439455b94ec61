// The complete loop with a two-link arm: modes, messages, every fault, the safe state, no
// allocation. Would catch: a fault that is not detected or is overwritten, torque beyond limits in
// the safe state, messages that are applied late or lost, and hidden allocation in a cycle.
#include "servo/loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "allocation_counter.hpp"
#include "loop_rig.hpp"

namespace {

using namespace treeline::servo;  // NOLINT: all of it is under test
using namespace treeline::test;   // NOLINT: what it is tested with

TEST(ServoLoop, ControllerPreparesForEveryCycle) {
  Rig rig;
  rig.cycles(7);
  EXPECT_EQ(rig.controller.prepared, 7);
}

TEST(ServoLoop, IdleHoldsTheArmAgainstGravity) {
  Rig rig;
  rig.cycles(1000);
  EXPECT_EQ(rig.loop.mode(), Mode::idle);
  EXPECT_NEAR(rig.state().q[0], 0.2, 1e-9);
  EXPECT_NEAR(rig.state().q[1], 0.4, 1e-9);
}

TEST(ServoLoop, RunsStopsAndEnds) {
  Rig rig;
  rig.cycles(10);
  rig.send(MessageKind::start);
  rig.cycles(1000);
  EXPECT_EQ(rig.loop.mode(), Mode::running);
  // After t = 1 s of control (999 periods; the first cycle is at t = 0).
  EXPECT_NEAR(rig.state().q[0], 0.2 + 0.2 * (1.0 - std::cos(1.0)), 2e-5);
  EXPECT_EQ(rig.loop.control_times().count(), 1000U);
  rig.send(MessageKind::stop);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.mode(), Mode::stopping);
  rig.cycles(600);
  EXPECT_EQ(rig.loop.mode(), Mode::idle);
  EXPECT_LT(std::fabs(rig.state().qd[0]), 1e-3);
  rig.send(MessageKind::disconnect);
  EXPECT_FALSE(rig.loop.step(nobody));
  EXPECT_FALSE(rig.loop.fault());
}

TEST(ServoLoop, DisconnectingWhileRunningBrakesBeforeItEnds) {
  Rig rig;
  rig.send(MessageKind::start);
  rig.cycles(1000);
  rig.send(MessageKind::disconnect);
  int cycles = 0;
  while (rig.loop.step(nobody)) {
    ASSERT_LT(++cycles, 2000);
  }
  EXPECT_EQ(rig.loop.mode(), Mode::idle);
  EXPECT_GT(cycles, 10);
  EXPECT_LT(std::fabs(rig.state().qd[0]), 1e-3);
}

TEST(ServoLoop, AfterAFaultItBrakesBeforeItEnds) {
  Rig rig;
  rig.send(MessageKind::start);
  rig.cycles(1000);
  rig.send(MessageKind::emergency_stop);
  rig.send(MessageKind::disconnect);
  int cycles = 0;
  while (rig.loop.step(nobody)) {
    ASSERT_LT(++cycles, 2000);
  }
  EXPECT_EQ(rig.loop.mode(), Mode::faulted);
  EXPECT_LT(std::fabs(rig.state().qd[0]), 1e-3);
}

// A robot that reads NaN never comes to rest, but the loop ends nevertheless.
TEST(ServoLoop, EndsWithinTheLongestBraking) {
  Rig rig;
  RobotState<2, 2> broken = rig.initial;
  broken.qd[1] = std::numeric_limits<double>::quiet_NaN();
  rig.robot.set_state(broken);
  rig.send(MessageKind::disconnect);
  int cycles = 0;
  while (rig.loop.step(nobody)) {
    ASSERT_LT(++cycles, 6000);
  }
  EXPECT_NEAR(cycles, 5000, 2);
}

TEST(ServoLoop, OtherMessagesReachTheControllerAFewACycle) {
  Rig rig;
  for (int i = 0; i < 10; ++i) {
    rig.send(MessageKind::set_gains);
  }
  rig.cycles(1);
  EXPECT_EQ(rig.controller.applied, 4);
  rig.cycles(2);
  EXPECT_EQ(rig.controller.applied, 10);
}

TEST(ServoLoop, EmergencyStopOvertakesAndResetReturns) {
  Rig rig;
  rig.send(MessageKind::start);
  rig.cycles(500);
  rig.send(MessageKind::set_gains);
  rig.send(MessageKind::emergency_stop);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.mode(), Mode::faulted);
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::emergency_stop);
  rig.send(MessageKind::start);  // not from faulted
  rig.cycles(600);
  EXPECT_EQ(rig.loop.mode(), Mode::faulted);
  EXPECT_LT(std::fabs(rig.state().qd[0]), 1e-3);
  rig.send(MessageKind::reset);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.mode(), Mode::idle);
  EXPECT_FALSE(rig.loop.fault());
}

TEST(ServoLoop, PositionAndVelocityLimits) {
  Rig rig;
  rig.send(MessageKind::start);
  rig.cycles(10);
  RobotState<2, 2> beyond = rig.initial;
  beyond.q[1] = -2.1;
  rig.robot.set_state(beyond);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::position_limit);
  EXPECT_EQ(rig.loop.fault().index, 1);
  EXPECT_EQ(rig.loop.fault().limit, -2.0);
  // The first fault stays, because it is the cause.
  RobotState<2, 2> fast = rig.initial;
  fast.qd[0] = -6.0;
  rig.robot.set_state(fast);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::position_limit);
  rig.send(MessageKind::reset);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.mode(), Mode::faulted) << "still unsafe, faults again";
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::velocity_limit);
  EXPECT_EQ(describe(rig.loop.fault(), "shoulder").substr(0, 17), "shoulder moves at");
}

// Found 0.1 rad beyond its limit, a joint stays there after a reset without another fault, moves
// back within, and has its limit again; farther out is a fault.
TEST(ServoLoop, AJointBeyondItsLimitCanBeLedBack) {
  Rig rig;
  RobotState<2, 2> beyond = rig.initial;
  beyond.q[1] = -2.1;
  rig.robot.set_state(beyond);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::position_limit);
  rig.send(MessageKind::reset);
  rig.cycles(300);
  EXPECT_EQ(rig.loop.mode(), Mode::idle);
  rig.send(MessageKind::start);  // the controller swings upwards, back into the range
  rig.cycles(1200);
  EXPECT_EQ(rig.loop.mode(), Mode::running);
  EXPECT_GT(rig.state().q[1], -2.0);
  rig.robot.set_state(beyond);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::position_limit);
  EXPECT_EQ(rig.loop.fault().limit, -2.0);
  rig.send(MessageKind::reset);
  rig.cycles(1);
  beyond.q[1] = -2.11;
  rig.robot.set_state(beyond);
  rig.cycles(1);
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::position_limit);
}

TEST(ServoLoop, ExcessiveTorqueIsNotSent) {
  Rig rig;
  rig.send(MessageKind::start);
  rig.cycles(10);
  rig.controller.spoil = 100.0;
  double sent = 0.0;
  rig.loop.step([&](const Report<TwoLink>& report) { sent = report.tau[0]; });
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::torque_limit);
  EXPECT_LT(std::fabs(sent), 60.0);
}

TEST(ServoLoop, NotANumberFromControllerOrRobot) {
  Rig rig;
  rig.send(MessageKind::start);
  rig.cycles(10);
  rig.controller.spoil = std::numeric_limits<double>::quiet_NaN();
  rig.cycles(1);
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::torque_not_finite);
  EXPECT_NEAR(rig.state().q[0], 0.2, 1e-3) << "the robot never saw it";
  rig.controller.spoil = 0.0;
  rig.send(MessageKind::reset);
  rig.cycles(1);
  RobotState<2, 2> broken = rig.initial;
  broken.qd[1] = std::numeric_limits<double>::quiet_NaN();
  rig.robot.set_state(broken);
  double sent[2] = {1.0, 1.0};
  rig.loop.step([&](const Report<TwoLink>& report) {
    sent[0] = report.tau[0];
    sent[1] = report.tau[1];
    EXPECT_TRUE(std::isfinite(report.state.qd[1]));
    EXPECT_TRUE(std::isfinite(report.fault.value));
  });
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::state_not_finite);
  EXPECT_EQ(rig.loop.fault().index, 1);
  // What is left of the sensors says that the arm stands: its weight is held, and what was sent
  // last changes by no more than torques may in a cycle.
  const double none[2] = {};
  double weight[2];
  TwoLink::inverse_dynamics(rig.initial.q, none, none, weight);
  EXPECT_NEAR(sent[0], weight[0], 60.0 / 20);
  EXPECT_NEAR(sent[1], weight[1], 30.0 / 20);
}

TEST(ServoLoop, OneLateCycleIsForgivenFourInARowAreNot) {
  Rig rig;
  rig.send(MessageKind::start);
  rig.cycles(10);
  const auto late = [&](const Report<TwoLink>&) { rig.clock.advance(1'500'000); };
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(rig.loop.step(late));
  }
  rig.cycles(1);
  EXPECT_EQ(rig.loop.mode(), Mode::running);
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(rig.loop.step(late));
  }
  EXPECT_EQ(rig.loop.mode(), Mode::faulted);
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::deadline);
  EXPECT_EQ(rig.loop.cycle().skips(), 7U);
}

// The process is stopped for 1.5 s, for instance in a debugger, while it waits or within a cycle.
// The arm would pass 360 rad under a torque that stays, and its limits within a second.
TEST(ServoLoop, AStallIsAFaultAndMovesNoSimulatedRobotForLong) {
  for (const bool within : {false, true}) {
    Rig rig;
    rig.send(MessageKind::start);
    rig.cycles(1000);
    const RobotState<2, 2> before = rig.state();
    if (!within) rig.clock.advance(1'500'000'000);
    ASSERT_TRUE(rig.loop.step([&](const Report<TwoLink>&) {
      if (within) rig.clock.advance(1'500'000'000);
    }));
    EXPECT_EQ(rig.loop.mode(), Mode::faulted);
    EXPECT_EQ(rig.loop.fault().kind, FaultKind::stalled);
    EXPECT_NEAR(rig.loop.fault().value, 1.5, 2e-3);
    rig.cycles(1000);
    for (int i = 0; i < 2; ++i) {  // 50 ms pass, and then it brakes
      EXPECT_NEAR(rig.state().q[i], before.q[i], 0.1) << i;
      EXPECT_LT(std::fabs(rig.state().qd[i]), 1e-3) << i;
    }
  }
}

/// A robot that can be put back, as simulated ones can that were lost.
struct Restored : SimulatedRobot<TwoLink> {
  using SimulatedRobot::SimulatedRobot;
  void restore() { set_state({{0.5, 0.5}, {0.0, 0.0}}); }
};

TEST(ServoLoop, AResetRestoresARobotThatOffersIt) {
  Rig rig;
  Restored robot({{2.5, 0.4}, {0.0, 0.0}});
  ServoLoop<TwoLink, Restored, Swing, SimulatedClock> loop{
      {}, Rig::make_limits(), robot, rig.controller, rig.clock, rig.mailbox};
  loop.step(nobody);
  EXPECT_EQ(loop.fault().kind, FaultKind::position_limit);
  rig.send(MessageKind::reset);
  for (int i = 0; i < 100; ++i) loop.step(nobody);
  EXPECT_EQ(loop.mode(), Mode::idle);
  RobotState<2, 2> now;
  robot.read(now);
  EXPECT_NEAR(now.q[0], 0.5, 0.02);  // what was borne elsewhere is not what is borne here
}

// Motors that bear little more than the weight swing for ever about a reference that is too stiff
// for them, where torques may change so fast only.
TEST(ServoLoop, WeakArmsComeToRestToo) {
  std::mt19937 rng(5);
  const auto between = [&rng](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(rng);
  };
  for (int draw = 0; draw < 200; ++draw) {
    SCOPED_TRACE(draw);
    const double strength = std::exp(between(std::log(1.3), std::log(20.0)));
    SafetyLimits<2, 2> limits;
    limits.torque = {29.5 * strength, 9.81 * strength};
    SimulatedRobot<TwoLink> robot(
        {{between(-3, 3), between(-3, 3)}, {between(-1, 1), between(-1, 1)}});
    Swing controller;
    SimulatedClock clock;
    Mailbox mailbox;
    ServoLoop<TwoLink, SimulatedRobot<TwoLink>, Swing, SimulatedClock> loop{
        {}, limits, robot, controller, clock, mailbox};
    for (int i = 0; i < 3000; ++i) loop.step(nobody);
    RobotState<2, 2> now;
    robot.read(now);
    EXPECT_LT(std::fabs(now.qd[0]), 0.01) << strength;
    EXPECT_LT(std::fabs(now.qd[1]), 0.01) << strength;
  }
}

TEST(ServoLoop, EndsWhenTheRobotIsGone) {
  Rig rig;
  rig.send(MessageKind::start);
  rig.cycles(10);
  rig.robot.disconnect();
  EXPECT_FALSE(rig.loop.step(nobody));
  EXPECT_EQ(rig.loop.fault().kind, FaultKind::robot_gone);
}

TEST(ServoLoop, AllocatesNothing) {
  Rig rig;
  const long before = treeline::test::allocation_count();
  rig.mailbox.push(message_of(MessageKind::start));
  for (int i = 0; i < 100; ++i) {
    rig.loop.step(nobody);
  }
  rig.mailbox.push(message_of(MessageKind::emergency_stop));
  for (int i = 0; i < 100; ++i) {
    rig.loop.step(nobody);
  }
  EXPECT_EQ(treeline::test::allocation_count(), before);
}

}  // namespace
