// Would catch: a twin that does something else than the robot after it, a motion that goes on after
// a command that ends it, and a recorded motion that is not followed.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "linked_robots.hpp"
#include "rig.hpp"

namespace treeline::drive {
namespace {

using Rig = test::Rig<test::LinkedArm>;

/// What a person did, with times from the beginning.
void schedule(Rig& rig, double begin) {
  const auto at = [&](double time, const servo::Message& message) {
    ASSERT_TRUE(rig.loop().send_at(message, begin + time));
  };
  at(0.0, Rig::message(Instruction::begin_here, {}));
  at(0.1, Rig::message(Instruction::move_joint, {0, 0, 0.9}, 0.8));
  at(0.5, Rig::message(Instruction::move_joint, {1, 1, -0.4}, 0.5));
  for (int i = 0; i < 20; ++i) {
    at(1.2 + 0.033 * i, Rig::message(Instruction::drag_joint, {0, 0.9 - 0.02 * i}));
  }
}

// Two loops that begin in the same state at different times do the same, cycle by cycle. Times are
// sums of different numbers, so that they agree to the last digits only.
TEST(TimedMessages, DoTheSameInTwoLoops) {
  Rig twin({0.3, 0.8});
  Rig robot({0.3, 0.8});
  robot.run(0.737);
  schedule(twin, 0.05);
  schedule(robot, 0.787);
  twin.run(0.1);
  robot.run(0.1);
  double moved = 0.0;
  for (int i = 0; i < 3000; ++i) {
    twin.step();
    robot.step();
    for (int k = 0; k < 2; ++k) ASSERT_NEAR(twin.q(k), robot.q(k), 1e-9) << i;
    moved = std::max(moved, std::fabs(twin.q(0) - 0.3));
  }
  EXPECT_GT(moved, 0.5);
}

TEST(TimedMessages, AreForgottenWithTheNextCommand) {
  Rig rig({0.3, 0.8});
  schedule(rig, 0.05);
  rig.run(0.08);
  rig.send(Instruction::hold_all, {});
  rig.run(3.0);
  EXPECT_NEAR(rig.q(0), 0.3, 1e-6);
  EXPECT_NEAR(rig.q(1), 0.8, 1e-6);
}

TEST(TimedMessages, AreForgottenWithAnEmergencyStop) {
  Rig rig({0.3, 0.8});
  schedule(rig, 0.05);
  rig.command(servo::MessageKind::emergency_stop);
  rig.run(0.01);
  rig.command(servo::MessageKind::reset);
  rig.run(0.01);
  rig.command(servo::MessageKind::start);
  rig.run(3.0);
  EXPECT_NEAR(rig.q(0), 0.3, 1e-6);
  EXPECT_EQ(rig.head().fault_kind, 0);
}

/// Both joints along a sine of 0.4 rad and 2 s, in steps of 10 ms.
struct Sine {
  std::vector<double> times, q;
  Sine() {
    for (int i = 0; i <= 200; ++i) {
      times.push_back(5.0 + 0.01 * i);
      q.push_back(0.3 + at(0.01 * i));
      q.push_back(0.8 - at(0.01 * i));
    }
  }
  static double at(double time) { return 0.2 * (1 - std::cos(std::numbers::pi * time)); }
};

// Hermite segments with central slopes err by h^3 of the third derivative: below 1e-5 here; the law
// adds their jumps of acceleration.
TEST(Follow, RunsAlongARecordedMotion) {
  const Sine sine;
  Rig rig({0.6, 0.5}, [&](LoopOptions& options) {
    options.reference = {sine.times.data(), sine.q.data(), static_cast<int>(sine.times.size())};
  });
  rig.send(Instruction::follow, {}, 1.0);
  rig.step();  // the cycle that takes it
  const double begin = rig.head().time + 1.0;
  rig.run(1.0);
  EXPECT_NEAR(rig.q(0), 0.3, 1e-3);
  while (rig.head().time < begin + 1.99) {
    rig.step();
    const double wanted = Sine::at(rig.head().time - begin);
    ASSERT_NEAR(rig.q(0), 0.3 + wanted, 1e-3) << rig.head().time - begin;
    ASSERT_NEAR(rig.q(1), 0.8 - wanted, 1e-3);
    EXPECT_TRUE(rig.head().moving);
  }
  rig.run(1.0);
  EXPECT_FALSE(rig.head().moving);
  EXPECT_NEAR(rig.q(0), 0.3 + Sine::at(2.0), 1e-5);
}

TEST(Follow, EndsWithAnotherCommand) {
  const Sine sine;
  Rig rig({0.3, 0.8}, [&](LoopOptions& options) {
    options.reference = {sine.times.data(), sine.q.data(), static_cast<int>(sine.times.size())};
  });
  rig.send(Instruction::follow, {}, 0.5);
  rig.run(1.3);
  rig.take_step();
  rig.send(Instruction::hold_all, {});
  rig.run(0.5);
  EXPECT_LT(rig.take_step(), 8.0);  // of 30 N m: the lead's acceleration ends
  const double stopped = rig.q(0);
  rig.run(2.0);
  EXPECT_NEAR(rig.q(0), stopped, 1e-4);
  EXPECT_FALSE(rig.head().moving);
}

TEST(Follow, IsNothingWithoutAReference) {
  Rig rig({0.3, 0.8});
  rig.send(Instruction::follow, {});
  rig.run(1.0);
  EXPECT_NEAR(rig.q(0), 0.3, 1e-6);
}

}  // namespace
}  // namespace treeline::drive
