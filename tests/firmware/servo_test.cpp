// Would catch: a firmware loop whose torque is not the controller's, commands lost or out of order,
// late calls that do not stop the robot, modes that are not those of the big loop.
#include "firmware/servo.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "puma_arm.hpp"
#include "puma_arm_controller.h"
#include "servo/message.hpp"
#include "servo/state_machine.hpp"

namespace treeline::firmware {
namespace {

using core::MessageKind;
using core::Mode;

static_assert(std::is_same_v<servo::Mode, core::Mode>, "one state machine");
static_assert(std::is_same_v<servo::MessageKind, core::MessageKind>, "one set of messages");

struct Clock {
  uint32_t* time;
  uint32_t operator()() const { return *time; }
};

struct Loop {
  uint32_t time = 0xfffffff0;  // wraps soon
  Servo<puma_arm::Controller, Clock, 4, 20> servo{Timing{1000, 100, 3}, Clock{&time}};

  Loop() {
    servo.begin();
    const double home[6] = {0.3, -0.9, 0.6, 0.2, 0.8, -0.4};
    for (int i = 0; i < 6; ++i) servo.input().q[i] = home[i];
  }
  bool post(MessageKind kind) {
    decltype(servo)::Command command;
    command.kind = kind;
    return servo.post(command);
  }
  void run(int ticks, uint32_t period = 1000) {
    for (int k = 0; k < ticks; ++k) {
      servo.tick();
      time += period;
    }
  }
};

TEST(FirmwareServo, GivesTheControllersTorque) {
  Loop loop;
  puma_arm_config config;
  puma_arm_default_config(&config);
  puma_arm_state state{};
  puma_arm_input input{};
  puma_arm_output output{};
  for (int i = 0; i < 6; ++i) input.q[i] = loop.servo.input().q[i];
  decltype(loop.servo)::Command command;
  command.kind = MessageKind::set_posture;
  command.duration = 0.4;
  // The arm stands still, so the reference stays near enough not to be missed.
  for (int i = 0; i < 6; ++i) {
    command.values[i] = input.command.goal[i] = input.q[i] + 0.02 * i;
  }
  for (int k = 0; k < 300; ++k) {
    if (k == 10) {
      loop.post(MessageKind::start);
      input.command.kind = PUMA_ARM_START;
      ++input.command.sequence;
    }
    if (k == 20) {
      loop.servo.post(command);
      input.command.kind = PUMA_ARM_MOVE_JOINTS;
      input.command.duration = 0.4;
      ++input.command.sequence;
    }
    loop.run(1);
    puma_arm_step(&config, &state, &input, &output);
    for (int i = 0; i < 6; ++i) ASSERT_EQ(loop.servo.output().tau[i], output.tau[i]) << k;
  }
  EXPECT_EQ(loop.servo.mode(), Mode::running);
  EXPECT_EQ(loop.servo.delays().largest(), 0U);
  EXPECT_EQ(loop.servo.delays().count(), 299U);
}

TEST(FirmwareServo, TakesTheMostUrgentCommandFirst) {
  Loop loop;
  loop.post(MessageKind::start);
  loop.run(1);
  EXPECT_EQ(loop.servo.mode(), Mode::running);
  EXPECT_TRUE(loop.post(MessageKind::instruction));
  EXPECT_TRUE(loop.post(MessageKind::instruction));
  EXPECT_TRUE(loop.post(MessageKind::stop));
  EXPECT_TRUE(loop.post(MessageKind::emergency_stop));
  EXPECT_FALSE(loop.post(MessageKind::instruction));  // full
  loop.run(1);
  EXPECT_EQ(loop.servo.mode(), Mode::faulted);
}

TEST(FirmwareServo, StopsWhereItIsCalledTooLateTooOften) {
  Loop loop;
  loop.post(MessageKind::start);
  loop.run(5);
  loop.run(3, 1500);  // the next three calls are late
  loop.run(2);
  EXPECT_EQ(loop.servo.mode(), Mode::running);
  loop.run(6, 1500);
  EXPECT_EQ(loop.servo.mode(), Mode::faulted);
  EXPECT_TRUE(loop.servo.missed_deadlines());
  EXPECT_EQ(loop.servo.output().faults, static_cast<uint32_t>(PUMA_ARM_FAULT_EMERGENCY));
  loop.post(MessageKind::reset);
  loop.run(2);
  EXPECT_EQ(loop.servo.mode(), Mode::idle);
  EXPECT_FALSE(loop.servo.missed_deadlines());
  EXPECT_EQ(loop.servo.delays().largest(), 500U);
}

}  // namespace
}  // namespace treeline::firmware
