// Would catch: an emitted controller that the servo loop cannot run, messages that do not reach it,
// numbers of modes and messages that both have otherwise.
#include <gtest/gtest.h>

#include <cmath>

#include "puma_arm.hpp"
#include "puma_arm_controller.h"
#include "servo/emitted_controller.hpp"
#include "servo/loop.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::servo {
namespace {

struct Puma {
  static constexpr int kCoordinates = puma_arm::kCoordinates;
  static constexpr int kVelocities = puma_arm::kVelocities;
  static constexpr auto& inverse_dynamics = puma_arm::inverse_dynamics;
  static constexpr auto& forward_dynamics = puma_arm::forward_dynamics;
};

// Loops pass on the numbers of their modes and messages.
constexpr bool is(Mode mode, int number) {
  return static_cast<int>(mode) == number;
}
constexpr bool is(MessageKind kind, int number) {
  return static_cast<int>(kind) == number;
}
static_assert(is(Mode::idle, PUMA_ARM_IDLE) && is(Mode::running, PUMA_ARM_RUNNING) &&
              is(Mode::stopping, PUMA_ARM_STOPPING) && is(Mode::faulted, PUMA_ARM_FAULTED));
static_assert(is(MessageKind::emergency_stop, PUMA_ARM_EMERGENCY_STOP) &&
              is(MessageKind::stop, PUMA_ARM_STOP) && is(MessageKind::reset, PUMA_ARM_RESET) &&
              is(MessageKind::start, PUMA_ARM_START) &&
              is(MessageKind::move_point, PUMA_ARM_MOVE_POINT) &&
              is(MessageKind::set_posture, PUMA_ARM_MOVE_JOINTS) &&
              is(MessageKind::instruction, PUMA_ARM_KEEP_ALIVE) &&
              is(MessageKind::press, PUMA_ARM_PRESS) && is(MessageKind::comply, PUMA_ARM_COMPLY) &&
              is(MessageKind::lead_posture, PUMA_ARM_LEAD_JOINTS) &&
              is(MessageKind::lead_point, PUMA_ARM_LEAD_POINT) &&
              is(MessageKind::behave, PUMA_ARM_BEHAVE));

TEST(EmittedController, RunsInTheServoLoop) {
  StateOf<Puma> initial;
  for (int i = 0; i < 6; ++i) initial.q[i] = 0.2 * (i - 2);
  SimulatedRobot<Puma> robot(initial);
  EmittedController<puma_arm::Controller, Puma> controller;
  SimulatedClock clock;
  Mailbox mailbox;
  ServoLoop<Puma, SimulatedRobot<Puma>, EmittedController<puma_arm::Controller, Puma>,
            SimulatedClock>
      loop(LoopSettings{}, SafetyLimits<6, 6>{}, robot, controller, clock, mailbox);
  const auto run = [&](int cycles) {
    for (int k = 0; k < cycles; ++k) loop.step([](const auto&) {});
  };
  Message message;
  message.kind = MessageKind::start;
  ASSERT_TRUE(mailbox.push(message));
  run(20);
  EXPECT_EQ(loop.mode(), Mode::running);
  message.kind = MessageKind::set_posture;
  message.duration = 0.5;
  for (std::size_t i = 0; i < 6; ++i) message.values[i] = 0.1 * static_cast<double>(i) - 0.3;
  ASSERT_TRUE(mailbox.push(message));
  run(900);
  EXPECT_EQ(loop.mode(), Mode::running);
  EXPECT_EQ(controller.output().faults, 0U);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(controller.input().q[i], 0.1 * i - 0.3, 1e-4) << i;
}

}  // namespace
}  // namespace treeline::servo
