// The PUMA's controller in float at 1 kHz, with its forward dynamics in place of the arm. The same
// source runs on boards that QEMU imitates and on the host: every cycle streams its state.
#include "board.hpp"
#include "firmware/servo.hpp"
#include "puma560_firmware.hpp"
#include "puma560_firmware_controller.h"
#include "record.hpp"

namespace robot = puma560_firmware;
using treeline::core::MessageKind;

namespace {

constexpr uint32_t kPeriod = 1000;  // of the clock, which counts microseconds

uint32_t microseconds = 0;
uint32_t now() {
  return microseconds;
}

using Servo = treeline::firmware::Servo<robot::Controller, uint32_t (*)(), 8, 24>;
using Command = Servo::Command;
static_assert(sizeof(Servo) <= 4096 - 1024, "a kilobyte is left for the stack");

Servo servo({kPeriod, kPeriod / 10, 3}, &now);

/// Leaves a command that has numbers or none.
template <int count>
void post(MessageKind kind, float duration, const float (&values)[count]) {
  Command command;
  command.kind = kind;
  command.duration = duration;
  for (int i = 0; i < count; ++i) command.values[i] = values[i];
  servo.post(command);
}

void move_tool() {
  float values[12];
  float position[3];
  float rotation[9];
  robot::forward_kinematics(servo.input().q, position, rotation);
  for (int i = 0; i < 3; ++i) values[i] = position[i];
  for (int i = 0; i < 9; ++i) values[3 + i] = rotation[i];
  values[0] -= 0.1F;
  values[2] += 0.15F;
  post(MessageKind::move_point, 0.8F, values);
}

/// The front end: what is asked for, and when.
void command(int tick) {
  constexpr float kNone[1] = {0};
  constexpr float kReach[6] = {0.9F, -0.4F, 0.1F, -0.5F, 0.9F, 0.6F};
  constexpr float kOver[6] = {-0.4F, -1.2F, 0.8F, 0.1F, 0.5F, 0.2F};
  constexpr float kHome[6] = {0.3F, -0.9F, 0.6F, 0.2F, 0.8F, -0.4F};
  if (tick == 100 || tick == 3010) post(MessageKind::start, 0, kNone);
  if (tick == 110) post(MessageKind::set_posture, 0.8F, kReach);
  if (tick == 1100) move_tool();
  if (tick == 2100) post(MessageKind::set_posture, 0.8F, kOver);
  if (tick == 3000) post(MessageKind::reset, 0, kNone);
  if (tick == 3020) post(MessageKind::set_posture, 0.8F, kHome);
  if (tick == 4000) post(MessageKind::stop, 0, kNone);
}

struct Plant {
  float q[6] = {0.3F, -0.9F, 0.6F, 0.2F, 0.8F, -0.4F};
  float qd[6] = {};

  void move(const float (&tau)[6]) {
    float qdd[6];
    robot::forward_dynamics(q, qd, tau, qdd);
    for (int i = 0; i < 6; ++i) {
      qd[i] += 0.001F * qdd[i];
      q[i] += 0.001F * qd[i];
    }
  }
};
Plant plant;

/// What the sensors read: the third encoder fails for 20 ms in the midst of a motion of the joints.
void measure(int tick) {
  const bool fails = tick >= 2300 && tick < 2320;
  for (int i = 0; i < 6; ++i) {
    servo.input().q[i] = fails && i == 2 ? __builtin_nanf("") : plant.q[i];
    servo.input().qd[i] = plant.qd[i];
  }
}

uintptr_t open(const char* name, uintptr_t length) {
  const uintptr_t arguments[3] = {reinterpret_cast<uintptr_t>(name), 5, length};
  return static_cast<uintptr_t>(ask_host(0x01, arguments));
}

void write(uintptr_t file, const void* from, uintptr_t bytes) {
  const uintptr_t arguments[3] = {file, reinterpret_cast<uintptr_t>(from), bytes};
  ask_host(0x05, arguments);
}

__attribute__((noinline)) void do_nothing() {
  __asm__ volatile("");
}

template <class Call>
__attribute__((noinline)) uint32_t count(const Call& call) {
  const uint64_t begun = begin_count();
  call();
  return static_cast<uint32_t>(end_count(begun));
}

constexpr uint32_t kPaint = 0x5a5aa5a5;

/// Bytes of stack that the first 200 cycles and the begin of a motion write to; 0 on the host.
template <class Call>
__attribute__((noinline)) uint32_t find_stack(const Call& call) {
#if defined(__arm__) || defined(__riscv)
  constexpr int kWords = 2048;
  volatile uint32_t* const top = stack_pointer();
  for (volatile uint32_t* at = top - kWords; at < top; ++at) *at = kPaint;
  call();
  volatile uint32_t* bottom = top - kWords;
  while (bottom < top && *bottom == kPaint) ++bottom;
  return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(top) -
                               reinterpret_cast<uintptr_t>(bottom));
#else
  call();
  return 0;
#endif
}

/// A cycle; returns its instructions beside those of the counting.
uint32_t run_cycle(int tick, uint32_t counting) {
  command(tick);
  measure(tick);
  uint32_t spent = 0;
  const uint32_t stack = find_stack([&] { spent = count([] { servo.tick(); }); });
  plant.move(servo.output().tau);
  microseconds += kPeriod;
  static uint32_t most_stack = 0;
  most_stack = stack > most_stack ? stack : most_stack;
  return ((spent - counting) & 0xfffff) | (most_stack << 20);
}

}  // namespace

// What compilers may call for copies and zeros of objects.
extern "C" {
void* memcpy(void* to, const void* from, size_t size) {
  for (size_t i = 0; i < size; ++i) {
    static_cast<volatile unsigned char*>(to)[i] = static_cast<const unsigned char*>(from)[i];
  }
  return to;
}
void* memset(void* to, int value, size_t size) {
  for (size_t i = 0; i < size; ++i) {
    static_cast<volatile unsigned char*>(to)[i] = static_cast<unsigned char>(value);
  }
  return to;
}
}

void run() {
  static const char states_name[] = STATES_FILE;
  static const char counts_name[] = COUNTS_FILE;
  const uintptr_t states = open(states_name, sizeof(states_name) - 1);
  const uintptr_t counts = open(counts_name, sizeof(counts_name) - 1);
  servo.begin();
  const uint32_t counting = count([] { do_nothing(); });
  const uint32_t size = sizeof(Servo);
  write(counts, &size, sizeof(size));
  for (int tick = 0; tick < kTicks; ++tick) {
    const uint32_t spent = run_cycle(tick, counting);
    write(counts, &spent, sizeof(spent));
    Record record;
    record.tick = tick;
    record.mode = servo.output().mode;
    record.faults = servo.output().faults;
    for (int i = 0; i < 6; ++i) {
      record.q[i] = plant.q[i];
      record.qd[i] = plant.qd[i];
      record.tau[i] = servo.output().tau[i];
    }
    write(states, &record, sizeof(record));
  }
}
