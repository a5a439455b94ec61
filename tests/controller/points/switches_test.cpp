// Would catch, of emitted controllers of robots that they know: a command that is accepted in the
// midst of a motion by another law and ends in a fault; joints that are thrown where a law begins,
// or faster than their limits while they comply.
#include <gtest/gtest.h>

#include <random>

#include "controller/safe_state/plant.hpp"
#include "fr3_plant.hpp"
#include "fr3_points_controller.h"
#include "gantry_plant.hpp"
#include "gantry_points_controller.h"
#include "iiwa14_plant.hpp"
#include "iiwa14_points_controller.h"
#include "puma_plant.hpp"
#include "puma_points_controller.h"
#include "ur10e_plant.hpp"
#include "ur10e_points_controller.h"

namespace treeline::tests {
namespace {

/// A command and its kind of `NAME_kind`; `hold` is STOP, rest and START.
struct Told {
  const char* name;
  int kind;
};
constexpr int kStop = 2, kStart = 4, kComply = 10;
constexpr std::array kTold = {
    Told{"hold", kStart},    Told{"move joints", 6},  Told{"move point", 5},  Told{"press", 9},
    Told{"comply", kComply}, Told{"lead joints", 11}, Told{"lead point", 12}, Told{"stop", kStop}};

template <class Robot>
class Switches : public testing::Test {
 protected:
  using Vector = typename Robot::Vector;

  /// Within the limits, of joints that turn without end within a turn.
  static Vector anywhere(std::mt19937& rng) {
    typename Robot::Emitted::Config config;
    Robot::Emitted::default_config(config);
    Vector q;
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double lower = std::max(config.lower[i], -3.1), upper = std::min(config.upper[i], 3.1);
      const double room = 0.05 * (upper - lower);
      q[i] = std::uniform_real_distribution<double>(lower + room, upper - room)(rng);
    }
    return q;
  }

  /// Goals, poses and forces anywhere: what a command of any kind reads.
  static void draw(Robot& robot, std::mt19937& rng) {
    std::uniform_real_distribution<double> unit(-1, 1), seconds(0.05, 2), turn(-3, 3);
    auto& command = robot.input.command;
    const Vector goal = anywhere(rng);
    std::copy(goal.begin(), goal.end(), command.goal);
    for (double& x : command.position) x = unit(rng);
    const double angle = turn(rng), c = std::cos(angle), s = std::sin(angle);
    const double rotation[9] = {c, -s, 0, s, c, 0, 0, 0, 1};
    std::copy(std::begin(rotation), std::end(rotation), command.rotation);
    command.duration = seconds(rng);
    double direction[3] = {unit(rng), unit(rng), unit(rng)};
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    for (int i = 0; i < 3; ++i) command.direction[i] = direction[i] / length;
    command.force = 20 * unit(rng);
  }

  static void tell(Robot& robot, const Told& told, std::mt19937& rng) {
    draw(robot, rng);
    if (told.kind == kStart) {
      robot.send(kStop);
      robot.run(1.5);
    }
    if (told.kind > kComply) {
      robot.send(kComply);
      robot.step();
    }
    robot.send(told.kind);
    robot.step();
  }

  static void expect_no_fault(const Told& first, const Told& second, unsigned seed) {
    SCOPED_TRACE(testing::Message() << first.name << ", then " << second.name << ", seed " << seed);
    std::mt19937 rng(seed);
    Robot robot({}, anywhere(rng));
    robot.run(0.02);
    robot.send(kStart);
    robot.run(0.05);
    tell(robot, first, rng);
    robot.run(std::uniform_real_distribution<double>(0.1, 1.3)(rng));
    ASSERT_EQ(robot.output.faults, 0U);
    tell(robot, second, rng);
    robot.run(3);
    EXPECT_EQ(robot.output.faults, 0U);
  }
};

struct Fr3 : Plant<fr3_points::Controller, fr3_plant::forward_dynamics> {
  using Plant::Plant;
};
struct Iiwa14 : Plant<iiwa14_points::Controller, iiwa14_plant::forward_dynamics> {
  using Plant::Plant;
};
struct Ur10e : Plant<ur10e_points::Controller, ur10e_plant::forward_dynamics> {
  using Plant::Plant;
};
struct Puma : Plant<puma_points::Controller, puma_plant::forward_dynamics> {
  using Plant::Plant;
};
struct Gantry : Plant<gantry_points::Controller, gantry_plant::forward_dynamics> {
  using Plant::Plant;
};

using Robots = testing::Types<Fr3, Iiwa14, Ur10e, Puma, Gantry>;
TYPED_TEST_SUITE(Switches, Robots);

TYPED_TEST(Switches, OfEveryPairEndInNoFault) {
  unsigned seed = 0;
  for (const Told& first : kTold) {
    if (first.kind == kStop) continue;
    for (const Told& second : kTold) this->expect_no_fault(first, second, ++seed);
  }
}

// A tool that moves while it is told to press is led to rest from its motion, as by every other
// command. Would catch: a reference that stands at once, which the tool is thrown back to.
TEST(SwitchesOfATool, LeadItOnWhereItBeginsToPress) {
  std::mt19937 rng(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 60; ++k) {
    Puma robot({}, {0, -0.9, 0.6, 0, 0.5, 0});
    robot.run(0.02);
    robot.send(kStart);
    robot.run(0.05);
    auto& command = robot.input.command;
    for (std::size_t i = 0; i < Puma::n; ++i) command.goal[i] = robot.q[i] + unit(rng);
    command.duration = 1;
    robot.send(PUMA_POINTS_MOVE_JOINTS);
    robot.run(0.5);
    command.direction[2] = -1;
    command.force = 10;
    robot.send(PUMA_POINTS_PRESS);
    robot.step();
    ASSERT_EQ(robot.output.refused, 0);
    robot.run(0.3);
    EXPECT_EQ(robot.output.faults, 0U) << k;
  }
}

}  // namespace
}  // namespace treeline::tests
