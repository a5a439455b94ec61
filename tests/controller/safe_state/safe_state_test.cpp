// Would catch, of emitted controllers with robots that are not quite what they know: an arm that
// creeps or sinks after an emergency stop, a stop or a fault, under a payload, other masses,
// friction, delay or encoders; braking that ends with one sensor; torque that steps; joints driven
// beyond their limits; brakes that nobody calls for.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "controller/safe_state/plant.hpp"
#include "fr3_plant.hpp"
#include "fr3_safe_controller.h"
#include "gantry_plant.hpp"
#include "gantry_safe_controller.h"
#include "iiwa14_plant.hpp"
#include "iiwa14_safe_controller.h"
#include "puma_plant.hpp"
#include "puma_safe_controller.h"
#include "ur10e_plant.hpp"
#include "ur10e_safe_controller.h"

namespace treeline::tests {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Fr3 : Plant<fr3_safe::Controller, fr3_plant::forward_dynamics> {
  static constexpr Vector kStart = {0, 0, 0, -1.6, 0, 1.8, 0};
  static constexpr Vector kGoal = {0.7, 0.5, -0.6, -0.9, 0.8, 2.6, 1.0};
  static constexpr double kRated = 3;  // kg
  /// What the law carries through a motion without knowing of it.
  static constexpr double kCarried = 1.2;
  using Plant::Plant;
};
struct Ur10e : Plant<ur10e_safe::Controller, ur10e_plant::forward_dynamics> {
  static constexpr Vector kStart = {0, -1.6, 1.6, -1.6, -1.6, 0};
  static constexpr Vector kGoal = {0.8, -1.0, 0.9, -1.0, -0.8, 1.0};
  static constexpr double kRated = 10;
  static constexpr double kCarried = 4;
  using Plant::Plant;
};
struct Iiwa14 : Plant<iiwa14_safe::Controller, iiwa14_plant::forward_dynamics> {
  static constexpr Vector kStart = {0, 0.6, 0, -1.2, 0, 0.9, 0};
  static constexpr Vector kGoal = {0.6, 1.0, -0.5, -0.7, 0.6, 0.3, 0.8};
  static constexpr double kRated = 14;
  static constexpr double kCarried = 5.6;
  using Plant::Plant;
};
struct Puma : Plant<puma_safe::Controller, puma_plant::forward_dynamics> {
  static constexpr Vector kStart = {0.3, -0.9, 0.6, 0.2, 0.8, -0.4};
  static constexpr Vector kGoal = {0.9, -0.4, 0.1, -0.4, 0.3, 0.4};
  static constexpr double kRated = 2.5;
  static constexpr double kCarried = 0.1;
  using Plant::Plant;
};
/// With a joint that turns without end, about to pass pi, and a joint that another follows.
struct Gantry : Plant<gantry_safe::Controller, gantry_plant::forward_dynamics> {
  static constexpr Vector kStart = {0, 2.9, 0.2};
  static constexpr Vector kGoal = {0.5, -2.6, 0.7};
  static constexpr double kRated = 5;
  static constexpr double kCarried = 2;
  using Plant::Plant;
};

template <class Robot>
class SafeState : public testing::Test {
 protected:
  static constexpr int n = Robot::n;

  /// In the midst of a motion of all joints.
  static Robot moving(const Imperfection& is) {
    Robot robot(is, Robot::kStart);
    robot.config.following = 1e9;  // an unknown payload leaves the reference
    robot.run(0.1);
    robot.send(4);  // START
    robot.run(0.1);
    for (int i = 0; i < n; ++i) {
      robot.input.command.goal[i] = Robot::kGoal[static_cast<std::size_t>(i)];
    }
    robot.input.command.duration = 1;
    robot.send(6);  // MOVE_JOINTS
    robot.run(0.5);
    EXPECT_EQ(robot.output.mode, 1);
    EXPECT_GT(robot.fastest(), 0.3);
    return robot;
  }

  /// Runs the robot for two seconds, in which it has to come to rest and stay there.
  template <class Spoil>
  static void expect_rest(Robot robot, Spoil&& spoil, const char* what) {
    SCOPED_TRACE(what);
    const auto q = robot.q;
    const auto qd = robot.qd;
    typename Robot::Vector held{};
    double last[n];
    for (int i = 0; i < n; ++i) last[i] = robot.output.tau[i];
    for (int k = 0; k < 2000; ++k) {
      robot.step(spoil);
      for (int i = 0; i < n; ++i) {
        const double change = std::fabs(robot.output.tau[i] - last[i]);
        ASSERT_LE(change, 1.000001 * robot.config.torque_rate[i] * robot.config.period) << i;
        ASSERT_LE(std::fabs(robot.output.tau[i]), robot.config.torque[i]) << i;
        last[i] = robot.output.tau[i];
      }
      if (k == 1000) held = robot.q;
    }
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      // Where the reference stops, which brakes fully after 50 ms, and twice the reach of what
      // holds.
      const double stop = q[at] + qd[at] * (1 / robot.config.brake_damping + 0.025);
      EXPECT_NEAR(robot.q[at], stop, 2 * robot.config.hold_reach) << "joint " << i;
      EXPECT_NEAR(robot.q[at], held[at], 0.5 * robot.config.hold_reach) << "joint " << i;
      EXPECT_GT(robot.q[at], robot.config.lower[i]) << "joint " << i;
      EXPECT_LT(robot.q[at], robot.config.upper[i]) << "joint " << i;
    }
    EXPECT_LT(robot.fastest(), 0.02);
  }

  static std::vector<std::pair<const char*, Imperfection>> imperfections() {
    Imperfection heavy, light, loaded, rubbing, late, counted, blind, all;
    heavy.mass_scale = 1.1;
    light.mass_scale = 0.9;
    loaded.payload = Robot::kCarried;
    rubbing.friction = 0.03;
    late.delay = 2;
    counted.encoder = 5e-5;
    blind = {1.1, Robot::kCarried, 0.05, 0.03, 0, 5e-5, true};
    all = {1.1, Robot::kCarried, 0.05, 0.03, 2, 5e-5};
    return {{"as modelled", {}},         {"masses + 10 %", heavy},     {"masses - 10 %", light},
            {"unknown payload", loaded}, {"friction", rubbing},        {"two steps late", late},
            {"encoders", counted},       {"coordinates alone", blind}, {"all of them", all}};
  }
};

using Robots = testing::Types<Fr3, Ur10e, Iiwa14, Puma, Gantry>;
TYPED_TEST_SUITE(SafeState, Robots);

TYPED_TEST(SafeState, HoldsAfterAnEmergencyStop) {
  for (const auto& [name, is] : this->imperfections()) {
    TypeParam robot = this->moving(is);
    robot.send(0);  // EMERGENCY_STOP
    this->expect_rest(
        robot, [](auto&) {}, name);
    robot.run(1.5);
    EXPECT_EQ(robot.output.faults, 32U) << name;
    EXPECT_EQ(robot.output.brakes, 1) << name;
  }
}

TYPED_TEST(SafeState, HoldsTheRatedPayloadThatItDoesNotKnow) {
  Imperfection is;
  is.payload = TypeParam::kRated;
  TypeParam robot(is, TypeParam::kStart);
  for (int k = 0; k < 3000; ++k) {
    robot.step();
    for (int i = 0; i < TypeParam::n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      ASSERT_NEAR(robot.q[at], TypeParam::kStart[at], 2 * robot.config.hold_reach) << i;
    }
  }
  EXPECT_EQ(robot.output.faults, 0U);
  EXPECT_LT(robot.fastest(), 0.02);
}

TYPED_TEST(SafeState, BrakesWhereTheLawCannotCarryThePayload) {
  Imperfection is;
  is.payload = TypeParam::kRated;
  TypeParam robot(is, TypeParam::kStart);
  robot.run(0.5);
  robot.send(4);  // START
  robot.run(2);
  if (robot.output.mode == 1) return;  // it can
  EXPECT_EQ(robot.output.reason, 256U);
  EXPECT_LT(robot.fastest(), 0.02);
  for (int i = 0; i < TypeParam::n; ++i) {
    EXPECT_NEAR(robot.q[static_cast<std::size_t>(i)],
                TypeParam::kStart[static_cast<std::size_t>(i)], 1)
        << i;
  }
}

TYPED_TEST(SafeState, HoldsAfterAStop) {
  for (const auto& [name, is] : this->imperfections()) {
    TypeParam robot = this->moving(is);
    robot.send(2);  // STOP
    this->expect_rest(
        robot, [](auto&) {}, name);
    robot.run(2);
    EXPECT_EQ(robot.output.mode, 0) << name;
    EXPECT_EQ(robot.output.faults, 0U) << name;
    EXPECT_EQ(robot.output.brakes, 0) << name;
  }
}

// Motors that cannot slow down as fast as the reference must not swing the robot afterwards: FR3
// was, in one of a hundred stops, to twice a joint's largest speed.
TYPED_TEST(SafeState, SlowsDownFromAnyMotion) {
  constexpr unsigned kSeed = 11;
  std::mt19937 rng(kSeed);
  std::uniform_real_distribution<double> unit(0, 1);
  const TypeParam first({}, TypeParam::kStart);
  const auto draw_pose = [&] {
    for (int tries = 0; tries < 1000; ++tries) {
      typename TypeParam::Vector q;
      for (std::size_t i = 0; i < q.size(); ++i) {
        const double lower = std::max(first.config.lower[i], -2.5);
        const double upper = std::min(first.config.upper[i], 2.5);
        q[i] = lower + (0.1 + 0.8 * unit(rng)) * (upper - lower);
      }
      TypeParam held({}, q);
      held.step();
      bool bears = true;
      for (int i = 0; i < TypeParam::n; ++i) {
        bears = bears && std::fabs(held.output.tau[i]) < 0.8 * held.config.torque[i];
      }
      if (bears) return q;
    }
    ADD_FAILURE() << "no pose that the motors bear";
    return TypeParam::kStart;
  };
  for (int stop = 0; stop < 300; ++stop) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << ", stop " << stop);
    TypeParam robot({}, draw_pose());
    robot.run(0.1);
    robot.send(4);  // START
    robot.run(0.1);
    const auto goal = draw_pose();
    std::copy(goal.begin(), goal.end(), robot.input.command.goal);
    const double duration = 0.3 + 2.7 * unit(rng);
    robot.input.command.duration = duration;
    robot.send(6);  // MOVE_JOINTS
    robot.run(duration * unit(rng));
    ASSERT_EQ(robot.output.faults, 0U);
    robot.send(stop % 2 == 0 ? 0 : 2);  // EMERGENCY_STOP, STOP
    double most = 0;
    for (int k = 0; k < 2000; ++k) {
      robot.step();
      for (int i = 0; i < TypeParam::n; ++i) {
        const double speed = std::fabs(robot.qd[static_cast<std::size_t>(i)]);
        most = std::max(most, speed / robot.config.speed[i]);
      }
    }
    // Half of the margin beyond which a speed is a fault.
    EXPECT_LT(most, 1.05);
    EXPECT_EQ(robot.output.faults & ~32U, 0U);
    EXPECT_LT(robot.fastest(), 0.02);
  }
}

TYPED_TEST(SafeState, BrakesByWhatIsLeftOfASensor) {
  for (int joint = 0; joint < TypeParam::n; ++joint) {
    Imperfection is;
    is.payload = TypeParam::kCarried;
    TypeParam robot = this->moving(is);
    this->expect_rest(
        robot, [&](auto& input) { input.q[joint] = kNaN; }, "q is lost");
    this->expect_rest(
        robot, [&](auto& input) { input.qd[joint] = kNaN; }, "qd is lost");
    robot.step([&](auto& input) { input.qd[joint] = kNaN; });
    EXPECT_EQ(robot.output.faults, 1U);
    EXPECT_EQ(robot.output.brakes, 1) << "in the step that sees it";
  }
}

TYPED_TEST(SafeState, CallsForBrakesWhereASensorFreezesOrJumps) {
  for (int joint = 0; joint < TypeParam::n; ++joint) {
    TypeParam robot = this->moving({});
    TypeParam jumped = robot;
    jumped.step([&](auto& input) { input.q[joint] += 0.08; });
    EXPECT_EQ(jumped.output.faults & 128U, 128U) << joint;
    EXPECT_EQ(jumped.output.brakes, 1) << joint;
    const double q = robot.input.q[joint];
    const double qd = robot.input.qd[joint];
    if (std::fabs(qd) < 0.6)
      continue;  // it creeps: 0.05 rad in a tenth of a second are not reached
    int steps = 0;
    while (robot.output.faults == 0 && steps < 500) {
      robot.step([&](auto& input) { input.q[joint] = q; });
      ++steps;
    }
    EXPECT_LT(steps, 200) << joint;
    EXPECT_EQ(robot.output.brakes, 1) << joint;
  }
}

TYPED_TEST(SafeState, SaysWhenItIsDraggedAway) {
  TypeParam robot = this->moving({});
  robot.send(2);  // STOP
  robot.run(1.5);
  ASSERT_EQ(robot.output.mode, 0);
  // Somebody who is stronger pulls joint 0 along.
  const double from = robot.q[0];
  while (robot.output.faults == 0 && robot.q[0] < from + 0.4) {
    robot.q[0] += 2e-4;
    robot.qd[0] = 0.2;
    const double pulled = robot.q[0];
    robot.step();
    robot.q[0] = pulled;
  }
  EXPECT_EQ(robot.output.faults, 64U);
  EXPECT_EQ(robot.output.reason, 64U);
  EXPECT_EQ(robot.output.brakes, 1);
  EXPECT_LT(robot.q[0] - from, 2.5 * robot.config.hold_reach);
}

TYPED_TEST(SafeState, FaultsWhereAJointIsBlocked) {
  TypeParam robot(Imperfection{}, TypeParam::kStart);
  robot.run(0.1);
  robot.send(4);
  robot.run(0.1);
  for (int i = 0; i < TypeParam::n; ++i) {
    robot.input.command.goal[i] = TypeParam::kStart[static_cast<std::size_t>(i)];
  }
  robot.input.command.goal[0] = TypeParam::kStart[0] + 0.25;
  robot.input.command.duration = 0.5;
  robot.send(6);
  for (int k = 0; k < 1600; ++k) {
    robot.step();
    robot.q[0] = TypeParam::kStart[0];
    robot.qd[0] = 0;
  }
  EXPECT_EQ(robot.output.faults & 256U, 256U);
}

TYPED_TEST(SafeState, TurnsTheShortWayRound) {
  if constexpr (std::is_same_v<TypeParam, Gantry>) {
    TypeParam robot = this->moving({});
    robot.run(1);
    EXPECT_NEAR(robot.q[1], 2 * M_PI - 2.6, 1e-3);
    // An encoder that counts from -pi to pi.
    const auto wrapped = [](auto& input) { input.q[1] = std::remainder(input.q[1], 2 * M_PI); };
    TypeParam other = this->moving({});
    TypeParam plain = other;
    for (int k = 0; k < 1000; ++k) {
      other.step(wrapped);
      plain.step();
      for (int i = 0; i < TypeParam::n; ++i) {
        ASSERT_NEAR(other.output.tau[i], plain.output.tau[i], 1e-9) << k;
      }
    }
    EXPECT_EQ(other.output.faults, 0U);
  }
}

TYPED_TEST(SafeState, TrustsNoConfiguration) {
  const TypeParam robot = this->moving({});
  const auto expect_caught = [&](auto change, int field, int index) {
    TypeParam spoilt = robot;
    change(spoilt.config);
    std::int32_t where = -1;
    EXPECT_EQ(TypeParam::Emitted::check_config(spoilt.config, where), field);
    EXPECT_EQ(where, index);
    const auto torque = robot.config;
    for (int k = 0; k < 1500; ++k) {
      spoilt.step();
      for (int i = 0; i < TypeParam::n; ++i) {
        ASSERT_LE(std::fabs(spoilt.output.tau[i]), torque.torque[i]) << field;
      }
    }
    EXPECT_EQ(spoilt.output.faults, 512U) << field;
    EXPECT_LT(spoilt.fastest(), 1e-2) << field;
  };
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {kNaN, inf, -1.0, -1e5}) {
    expect_caught([&](auto& config) { config.torque[1] = bad; }, 5, 1);
    expect_caught([&](auto& config) { config.speed[0] = bad; }, 4, 0);
    expect_caught([&](auto& config) { config.brake_damping = bad; }, 20, 0);
    expect_caught([&](auto& config) { config.joint_damping[2] = bad; }, 10, 2);
    expect_caught([&](auto& config) { config.period = bad; }, 1, 0);
  }
  expect_caught([&](auto& config) { config.lower[0] = kNaN; }, 2, 0);
  expect_caught([&](auto& config) { config.upper[1] = config.lower[1]; }, 3, 1);
  expect_caught([&](auto& config) { config.saturation = 2; }, 27, 0);
  expect_caught([&](auto& config) { config.stale_ticks = -1; }, 28, 0);
  expect_caught([&](auto& config) { config.joint_frequency[0] = 600; }, 9, 0);
}

}  // namespace
}  // namespace treeline::tests
