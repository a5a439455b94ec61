// Would catch, of emitted controllers that change the set of tasks that they do: torques that step
// where a set changes; tasks that are taken up with a jerk, or where the point was long ago; points
// that are not led and whose error is a fault, or hides that of others; commands for points that
// nothing leads; forces that go on without their task.
#include <gtest/gtest.h>

#include <random>

#include "controller/safe_state/plant.hpp"
#include "fr3_behaves.hpp"
#include "fr3_behaves_controller.h"
#include "fr3_plant.hpp"
#include "puma_behaves.hpp"
#include "puma_behaves_controller.h"
#include "puma_plant.hpp"

namespace treeline::tests {
namespace {

constexpr int kRunning = FR3_BEHAVES_RUNNING;

struct Fr3 : Plant<fr3_behaves::Controller, fr3_plant::forward_dynamics> {
  static constexpr Vector kHome = {0, 0, 0, -1.6, 0, 1.8, 0};
  static constexpr int kBehaviours = 6;
  static constexpr int kFree = 5;  ///< all but the last leave the arm a freedom
  static constexpr int kPoints = FR3_BEHAVES_POINTS;
  static constexpr auto& forward_kinematics = fr3_behaves::forward_kinematics;
  using Plant::Plant;
};
struct Puma : Plant<puma_behaves::Controller, puma_plant::forward_dynamics> {
  static constexpr Vector kHome = {0.3, -0.9, 0.6, 0.2, 0.8, -0.4};
  static constexpr int kBehaviours = 2;
  static constexpr int kFree = 2;
  static constexpr int kPoints = PUMA_BEHAVES_POINTS;
  static constexpr auto& forward_kinematics = puma_behaves::forward_kinematics;
  using Plant::Plant;
};

enum Point { kPlace, kTurn, kElbow };

template <class Robot>
Robot running() {
  Robot robot({}, Robot::kHome);
  robot.run(0.02);
  robot.send(FR3_BEHAVES_START);
  robot.run(0.05);
  EXPECT_EQ(robot.output.mode, kRunning);
  return robot;
}

template <class Robot>
struct Poses {
  double positions[3 * Robot::kPoints], rotations[9 * Robot::kPoints];
};

template <class Robot>
Poses<Robot> poses(const Robot& robot) {
  Poses<Robot> found;
  double q[Robot::n];
  std::copy(robot.q.begin(), robot.q.end(), q);
  Robot::forward_kinematics(q, found.positions, found.rotations);
  return found;
}

/// Tells the robot to behave so within `duration`, s. Returns why not, 0 if it does.
template <class Robot>
int behave(Robot& robot, int behaviour, double duration) {
  robot.input.command.point = behaviour;
  robot.input.command.duration = duration;
  robot.send(FR3_BEHAVES_BEHAVE);
  robot.step();
  return robot.output.refused;
}

/// Leads a point from where it is by `way`, m. Returns why not.
template <class Robot>
int move(Robot& robot, int point, std::array<double, 3> way, double duration) {
  const Poses<Robot> now = poses(robot);
  auto& command = robot.input.command;
  command.point = point;
  command.duration = duration;
  for (int i = 0; i < 3; ++i) {
    command.position[i] = now.positions[3 * point + i] + way[static_cast<std::size_t>(i)];
  }
  std::copy_n(now.rotations + 9 * point, 9, command.rotation);
  robot.send(FR3_BEHAVES_MOVE_POINT);
  robot.step();
  return robot.output.refused;
}

template <class Robot>
double distance(const Poses<Robot>& a, const Poses<Robot>& b, int point) {
  double sum = 0;
  for (int i = 3 * point; i < 3 * point + 3; ++i) {
    sum += std::pow(a.positions[i] - b.positions[i], 2);
  }
  return std::sqrt(sum);
}

/// Angle between the axes of a point, rad.
template <class Robot>
double angle(const Poses<Robot>& a, const Poses<Robot>& b, int point) {
  double trace = 0;
  for (int i = 9 * point; i < 9 * point + 9; ++i) trace += a.rotations[i] * b.rotations[i];
  return std::acos(std::min(1.0, (trace - 1) / 2));
}

/// The largest change of a torque from one step to the next within `seconds`, N m.
template <class Robot>
double largest_step(Robot& robot, double seconds) {
  double most = 0;
  for (int k = 0; k < static_cast<int>(seconds / Robot::kPeriod); ++k) {
    const auto before = robot.output;
    robot.step();
    for (int i = 0; i < Robot::n; ++i) {
      most = std::max(most, std::fabs(robot.output.tau[i] - before.tau[i]));
    }
  }
  return most;
}

TEST(Behaviours, BeginWithTheFirstAndHoldWhatItLeads) {
  Fr3 robot = running<Fr3>();
  EXPECT_EQ(robot.output.behaviour, FR3_BEHAVES_BEHAVIOUR_CARRY);
  const auto before = poses(robot);
  EXPECT_EQ(move(robot, kPlace, {0.1, 0.05, -0.1}, 1), 0);
  robot.run(2);
  const auto after = poses(robot);
  EXPECT_NEAR(distance(before, after, kPlace), 0.15, 1e-3);
  EXPECT_LT(angle(before, after, kTurn), 1e-3);
  EXPECT_EQ(robot.output.faults, 0U);
}

// The hand is led to a place and turns on the way as it likes, further than any error of a point
// may be.
TEST(Behaviours, LeaveAloneWhatTheyDoNotLeadAndTakeItUpWhereItIs) {
  Fr3 robot = running<Fr3>();
  robot.config.following = 0.1;
  const auto begun = poses(robot);
  ASSERT_EQ(behave(robot, FR3_BEHAVES_BEHAVIOUR_REACH, 0.3), 0);
  ASSERT_EQ(move(robot, kPlace, {0.1, 0.1, -0.15}, 1.5), 0);
  robot.run(4);
  ASSERT_EQ(robot.output.mode, kRunning) << robot.output.faults;
  ASSERT_EQ(robot.output.unmet, 0);
  const auto left = poses(robot);
  ASSERT_NEAR(distance(begun, left, kPlace), std::sqrt(0.0425), 1e-3);
  ASSERT_GT(angle(begun, left, kTurn), 2 * robot.config.following);
  ASSERT_EQ(behave(robot, FR3_BEHAVES_BEHAVIOUR_CARRY, 0.5), 0);
  robot.run(2);
  EXPECT_EQ(robot.output.faults, 0U);
  EXPECT_LT(angle(left, poses(robot), kTurn), 1e-3);
}

// A change at once is a step in torque; one that takes half a second, at most 15/8 of two
// thousandths of it in a step of time: a twentieth leaves room for what moves the arm besides.
TEST(Behaviours, ChangeWithoutAStepInTorque) {
  std::mt19937 rng(5);
  std::uniform_int_distribution<int> any(0, Fr3::kBehaviours - 1);
  int judged = 0;
  for (int k = 0; k < 30; ++k) {
    SCOPED_TRACE(k);
    Fr3 robot = running<Fr3>();
    const int first = any(rng), second = any(rng);
    ASSERT_EQ(behave(robot, first, 0.1), 0);
    robot.run(0.4);
    for (double& x : robot.qd) x += 0.05;  // somebody bumps into the arm
    robot.run(0.02);
    Fr3 at_once = robot;
    const auto before = at_once.output;
    behave(at_once, second, Fr3::kPeriod);
    double step = 0;
    at_once.step();
    for (int i = 0; i < Fr3::n; ++i) {
      step = std::max(step, std::fabs(at_once.output.tau[i] - before.tau[i]));
    }
    const double usual = largest_step(*std::make_unique<Fr3>(robot), 0.1);
    ASSERT_EQ(behave(robot, second, 0.5), 0);
    if (step < 20 * usual) continue;
    ++judged;
    EXPECT_LT(largest_step(robot, 0.6), step / 20 + usual);
    EXPECT_EQ(robot.output.faults, 0U);
  }
  EXPECT_GT(judged, 5);
}

TEST(Behaviours, RefuseWhatTheyDoNotLead) {
  Fr3 robot({}, Fr3::kHome);
  robot.run(0.02);
  EXPECT_EQ(behave(robot, FR3_BEHAVES_BEHAVIOUR_LOOK, 0.1), FR3_BEHAVES_REFUSED_MODE);
  robot = running<Fr3>();
  ASSERT_EQ(behave(robot, FR3_BEHAVES_BEHAVIOUR_LOOK, 0.1), 0);
  EXPECT_EQ(robot.output.behaviour, FR3_BEHAVES_BEHAVIOUR_LOOK);
  EXPECT_EQ(move(robot, kPlace, {0.1, 0, 0}, 1), FR3_BEHAVES_REFUSED_BEHAVIOUR);
  EXPECT_EQ(move(robot, kTurn, {0, 0, 0}, 1), 0);
  EXPECT_EQ(behave(robot, -1, 0.1), FR3_BEHAVES_REFUSED_BEHAVIOUR);
  EXPECT_EQ(behave(robot, Fr3::kBehaviours, 0.1), FR3_BEHAVES_REFUSED_BEHAVIOUR);
  EXPECT_EQ(behave(robot, FR3_BEHAVES_BEHAVIOUR_ALL, 0), FR3_BEHAVES_REFUSED_DURATION);
  EXPECT_EQ(robot.output.behaviour, FR3_BEHAVES_BEHAVIOUR_LOOK);
  robot.config.behaviour_share[1] = 1.5;
  robot.step();
  EXPECT_EQ(robot.output.faults, static_cast<unsigned>(FR3_BEHAVES_FAULT_CONFIG));
  std::int32_t index = 0;
  EXPECT_EQ(fr3_behaves_check_config(&robot.config, &index), FR3_BEHAVES_CONFIG_BEHAVIOUR_SHARE);
  EXPECT_EQ(index, 1);
}

TEST(Behaviours, EndThePressThatTheyDoNotLead) {
  Fr3 robot = running<Fr3>();
  auto& command = robot.input.command;
  command.point = kPlace;
  command.direction[2] = -1;
  command.force = 10;
  command.duration = 0.2;
  robot.input.force[2] = -10;  // what it presses gives way
  robot.send(FR3_BEHAVES_PRESS);
  robot.run(0.4);
  ASSERT_EQ(robot.state.pressing, 1);
  ASSERT_EQ(behave(robot, FR3_BEHAVES_BEHAVIOUR_REST, 0.3), 0);
  EXPECT_EQ(robot.state.pressing, 0);
  robot.run(1);
  EXPECT_EQ(robot.output.faults, 0U);
  ASSERT_EQ(behave(robot, FR3_BEHAVES_BEHAVIOUR_CARRY, 0.3), 0);
  robot.run(0.4);
  EXPECT_EQ(robot.state.pressing, 0);
}

// A hand that is always led is blocked: half a second after its reference stands that is a fault.
TEST(Behaviours, DoNotHideThatAnotherPointIsBlocked) {
  Puma robot = running<Puma>();
  ASSERT_EQ(move(robot, 0, {0.3, 0, 0}, 0.6), 0);
  const auto stuck = robot.q;
  for (int k = 0; k < 3000 && robot.output.mode == kRunning; ++k) {
    robot.step();
    robot.q = stuck;
    robot.qd = {};
  }
  EXPECT_EQ(robot.output.faults, static_cast<unsigned>(PUMA_BEHAVES_FAULT_FOLLOWING));
}

template <class Robot>
class AnyBehaviours : public testing::Test {};
using Robots = testing::Types<Fr3, Puma>;
TYPED_TEST_SUITE(AnyBehaviours, Robots);

/// Behaviours, the first `behaviours` of them, motions of joints and of what is led, forces,
/// compliance and stops, at any time. Ways that an elbow can go: at its highest it is blocked.
/// Returns the faults.
template <class Robot>
unsigned run_among_others(unsigned seed, int behaviours) {
  constexpr int kOthers[] = {FR3_BEHAVES_MOVE_JOINTS, FR3_BEHAVES_COMPLY, FR3_BEHAVES_START,
                             FR3_BEHAVES_PRESS};
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> unit(-1, 1), seconds(0.05, 1);
  std::uniform_int_distribution<int> behaviour(0, behaviours - 1), other(0, 3);
  std::uniform_int_distribution<int> point(0, Robot::kPoints - 1);
  Robot robot = running<Robot>();
  for (int k = 0; k < 6 && robot.output.faults == 0; ++k) {
    if (k % 2 == 0) {
      const int next = behaviour(rng);
      EXPECT_EQ(behave(robot, next, seconds(rng)), 0);
      robot.run(seconds(rng));
      const int led = point(rng);
      const double x = 0.06 * unit(rng), y = 0.06 * unit(rng), z = 0.06 * unit(rng);
      move(robot, led, {x, y, z}, 0.5);
    } else {
      auto& command = robot.input.command;
      for (std::size_t i = 0; i < Robot::n; ++i) {
        command.goal[i] = Robot::kHome[i] + 0.4 * unit(rng);
      }
      command.duration = seconds(rng);
      command.direction[2] = 1;
      command.force = 10 * unit(rng);
      const int kind = kOthers[other(rng)];
      if (kind == FR3_BEHAVES_START) {
        robot.send(FR3_BEHAVES_STOP);
        robot.run(1);
      }
      robot.send(kind);
    }
    robot.run(seconds(rng));
  }
  return robot.output.faults;
}

TYPED_TEST(AnyBehaviours, AmongOtherCommandsEndInNoFault) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    EXPECT_EQ(run_among_others<TypeParam>(seed, TypeParam::kFree), 0U) << seed;
  }
}

// A wrist that passes its singularity turns within milliseconds; its motion is given up next to a
// limit of position that the slower stop of other joints would lead it through.
TEST(Behaviours, StopAJointWithinTheRoomThatItHas) {
  for (const unsigned seed : {407U, 766U, 1139U, 1183U}) {
    EXPECT_EQ(run_among_others<Puma>(seed, Puma::kFree), 0U) << seed;
  }
}

// Seven rows on seven joints where the elbow can only be lifted by joints that turn against each
// other: exactly followed, they would be asked for 8000 rad/s2.
TEST(Behaviours, YieldWhereJointsWouldBeThrown) {
  for (const unsigned seed : {49U, 67U, 77U, 205U, 352U, 416U, 478U}) {
    EXPECT_EQ(run_among_others<Fr3>(seed, Fr3::kBehaviours), 0U) << seed;
  }
}

}  // namespace
}  // namespace treeline::tests
