// Would catch: a goal that is not reached, a drag that goes on after its lease, a torque beyond its
// limit, a loop that allocates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "../servo/allocation_counter.hpp"
#include "drive/drive_loop.hpp"
#include "driven_robots.hpp"
#include "linked_robots.hpp"
#include "rig.hpp"

namespace treeline::drive {
namespace {

using test::make_rig;
using test::Rig;
using Arm = test::PlanarArm;
using Body = test::HeldBody;
using test::Telescope;

TEST(DriveController, JointsArriveWhenTheyShould) {
  auto rig = make_rig<Arm>({0.3, 0.8});
  rig.send(Instruction::move_joint, {1, 0, 1.5}, 1.0);
  rig.run(0.5);
  EXPECT_NEAR(rig.q(1), 1.15, 2e-3);  // halfway by symmetry of the polynomial
  rig.run(0.6);
  EXPECT_NEAR(rig.q(1), 1.5, 1e-4);
  EXPECT_NEAR(rig.q(0), 0.3, 1e-4);
  rig.send(Instruction::move_joint, {1, 1, -0.2}, 0.5);
  rig.run(1.0);
  EXPECT_NEAR(rig.q(1), 1.3, 1e-5);
  rig.send(Instruction::move_joint, {0, 0, 7.0});  // beyond the limit: to the limit
  rig.run(12.0);
  EXPECT_NEAR(rig.q(0), 3.0, 1e-4);
  EXPECT_EQ(rig.head().fault_kind, 0);
}

TEST(DriveController, PointsArrive) {
  auto rig = make_rig<Arm>({0.3, 0.8});
  rig.send(Instruction::move_point, {0, 0, 0.9, 0, 1.1}, 1.0);
  rig.run(1.5);
  EXPECT_NEAR(std::cos(rig.q(0)) + std::cos(rig.q(0) + rig.q(1)), 0.9, 1e-5);
  EXPECT_NEAR(std::sin(rig.q(0)) + std::sin(rig.q(0) + rig.q(1)), 1.1, 1e-5);
}

// All slides share the way, as springs of one stiffness do. By accelerations alone, which the task
// withholds in the metric of energy, the last and lightest one would go nearly all of it.
TEST(DriveController, APostureIsHeldBySpringsOfOneStiffness) {
  Rig<Telescope> rig({0, 0, 0}, {}, 3.0);
  rig.send(Instruction::move_point, {0, 0, 0.6, 0, 0}, 1.0);
  rig.run(5.0);
  EXPECT_NEAR(rig.q(0) + rig.q(1) + rig.q(2), 0.6, 1e-6);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(rig.q(i), 0.2, 0.01) << i;  // the lightest yields 6 % more: h D against 0.1 kg
  }
  EXPECT_EQ(rig.head().fault_kind, 0);
}

// A goal beyond the arm's reach leads it into its singularity, where the law above divides by 0.
TEST(DriveController, GoalsOutOfReachKeepLimits) {
  constexpr double kSpeed = 2.0;  // rad/s
  const std::array<double, 2> velocity{kSpeed, kSpeed};
  Rig<Arm> rig(
      {0.3, 0.8}, [&](LoopOptions& options) { options.velocity = velocity.data(); }, 3.0);
  rig.send(Instruction::move_point, {0, 0, 2.5, 0, 0.5}, 0.5);
  double fastest = 0;
  for (int i = 0; i < 3000; ++i) {
    rig.step();
    fastest = std::max({fastest, std::fabs(rig.qd(0)), std::fabs(rig.qd(1))});
  }
  EXPECT_GT(fastest, 0.5 * kSpeed);  // else nothing was tried
  EXPECT_LT(fastest, kSpeed);
  EXPECT_EQ(rig.head().fault_kind, 0);
  rig.send(Instruction::move_joint, {0, 0, 0.3});
  rig.send(Instruction::move_joint, {1, 0, 0.8});
  rig.run(4.0);
  rig.send(Instruction::move_point, {0, 0, 0.9, 0, 1.1}, 1.0);
  rig.run(1.5);
  EXPECT_NEAR(std::cos(rig.q(0)) + std::cos(rig.q(0) + rig.q(1)), 0.9, 1e-5);
  EXPECT_NEAR(std::sin(rig.q(0)) + std::sin(rig.q(0) + rig.q(1)), 1.1, 1e-5);
}

// A motion asks for more torque than there is. It comes late, and arrives.
TEST(DriveController, ATaskBeyondTheTorqueArrivesLater) {
  const std::array<double, 2> velocity{3.0, 3.0};
  const std::array<double, 2> torque{30.0, 8.0};  // 23.2 and 4.5 N m hold the arm
  const auto change = [&](LoopOptions& options) {
    options.velocity = velocity.data();
    options.torque = torque.data();
  };
  Rig<Arm> rig({0.3, 0.8}, change, 3.0);
  rig.send(Instruction::move_point, {0, 0, 1.0, 0, 1.5}, 0.2);
  bool saturated = false;
  for (int i = 0; i < 4000; ++i) {
    rig.step();
    saturated = saturated || rig.head().saturated;
  }
  EXPECT_TRUE(saturated);  // else nothing was tried
  EXPECT_EQ(rig.head().fault_kind, 0);
  EXPECT_NEAR(std::cos(rig.q(0)) + std::cos(rig.q(0) + rig.q(1)), 1.0, 1e-4);
  EXPECT_NEAR(std::sin(rig.q(0)) + std::sin(rig.q(0) + rig.q(1)), 1.5, 1e-4);
}

// A point is led along a circle around the base until the first joint is at its limit.
TEST(DriveController, ATaskEndsAtALimitOfPosition) {
  Rig<Arm> rig({0.3, 0.8}, {}, 1.2);
  rig.send(Instruction::move_point, {0, 0, -0.2, 0, 1.9}, 1.0);  // asks for q0 = 1.38
  rig.run(4.0);
  EXPECT_EQ(rig.head().fault_kind, 0);
  EXPECT_NEAR(rig.q(0), 1.2, 0.02);
  EXPECT_LT(rig.q(0), 1.2 + 1e-3);
}

TEST(DriveController, AFloatingBaseMovesAndTurns) {
  auto rig = make_rig<Body>({0, 0, 0, 0, 0, 0, 1});
  rig.send(Instruction::move_point, {-1, 1, 0.5, -0.2, 0.3}, 1.0);
  rig.send(Instruction::turn_point, {-1, 1, 0, 0, std::numbers::pi / 2}, 1.0);
  rig.run(1.5);
  EXPECT_NEAR(rig.q(0), 0.5, 1e-4);
  EXPECT_NEAR(rig.q(1), -0.2, 1e-4);
  EXPECT_NEAR(rig.q(2), 0.3, 1e-4);
  EXPECT_NEAR(rig.q(5), std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(rig.q(6), std::sqrt(0.5), 1e-4);
}

// Led for half a second towards a far goal, then silence: obeyed for 125 ms, then a glide to rest.
TEST(DriveController, ADragEndsWithItsLease) {
  auto rig = make_rig<Arm>({0.3, 0.8});
  for (int i = 0; i < 15; ++i) {
    rig.send(Instruction::drag_joint, {0, 2.9});
    rig.run(0.033);
  }
  rig.run(kLease - 0.033);
  const double at_end = rig.at(Rig<Arm>::kLayout.goal);
  EXPECT_GT(at_end, 0.6);
  rig.run(0.5);
  const double rest = rig.at(Rig<Arm>::kLayout.goal);
  EXPECT_LT(rest, at_end + 0.6);
  EXPECT_LT(rest, 2.5);
  rig.run(1.0);
  EXPECT_EQ(rig.at(Rig<Arm>::kLayout.goal), rest);
  EXPECT_NEAR(rig.q(0), rest, 1e-5);
  EXPECT_FALSE(rig.head().moving);
}

// 19.6 N m hold the arm's weight where it is stretched; limits of 25 N m cut what a fast motion
// takes, and the robot still arrives.
TEST(DriveController, CutsTorquesToTheirLimits) {
  auto rig = make_rig<Arm>({1.2, 1.0}, 25.0);
  rig.send(Instruction::move_joint, {0, 0, 1.6}, 0.3);
  double largest = 0.0;
  bool cut = false;
  for (int i = 0; i < 4000; ++i) {
    rig.run(0.001);
    largest = std::max(largest, std::fabs(rig.at(Rig<Arm>::kLayout.tau)));
    cut = cut || rig.head().saturated;
  }
  EXPECT_LE(largest, 25.0);
  EXPECT_TRUE(cut);
  EXPECT_EQ(rig.head().fault_kind, 0);
  EXPECT_NEAR(rig.q(0), 1.6, 1e-3);
}

// Messages for what does not exist change nothing.
TEST(DriveController, IgnoresWhatDoesNotExist) {
  auto rig = make_rig<Arm>({0.3, 0.8});
  for (const double index : {-7.0, -1.0, 1.0, 2.0, 1e6}) {
    rig.send(Instruction::move_point, {index, 0, 5, 5, 5}, 1.0);
    rig.send(Instruction::drag_point, {index, 0, 5, 5, 5});
    rig.send(Instruction::release_point, {index});
    rig.send(Instruction::pull_link, {index, 0, 0, 0, 9, 9, 9});
    rig.run(0.01);
  }
  rig.send(Instruction::move_joint, {2, 0, 1.0}, 0.1);
  rig.send(Instruction::move_joint, {-1, 0, 1.0}, 0.1);
  rig.run(1.0);
  EXPECT_NEAR(rig.q(0), 0.3, 1e-5);
  EXPECT_NEAR(rig.q(1), 0.8, 1e-5);
}

TEST(DriveController, AllocatesNothing) {
  auto rig = make_rig<Arm>({0.3, 0.8});
  const long before = test::allocation_count();
  for (int i = 0; i < 50; ++i) {
    rig.send(Instruction::drag_point, {0, 0, 0.9, 0, 1.1});
    rig.send(Instruction::move_joint, {1, 0, 1.5}, 0.2);
    rig.run(0.02);
  }
  EXPECT_EQ(test::allocation_count(), before);
}

// Wherever it begins within its limits, the robot is held there, in every control.
TEST(DriveController, StartsFromAnywhereWithinTheLimits) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> anywhere(-3.0, 3.0);
  for (int i = 0; i < 40; ++i) {
    const double elbow = i % 5 == 0 ? 3.0 : anywhere(rng);  // at the limit at times
    const double shoulder = i % 7 == 0 ? -3.0 : anywhere(rng);
    auto rig = make_rig<test::LinkedArm>({shoulder, elbow});
    rig.run(1.0);
    EXPECT_EQ(rig.head().fault_kind, 0) << shoulder << ' ' << elbow;
    EXPECT_NEAR(rig.q(0), shoulder, 1e-6);
    EXPECT_NEAR(rig.q(1), elbow, 1e-6);
  }
}

// A robot that is found beyond its limits is in a fault. After a reset it is led back by each of
// the ways in which a joint moves, and then the limits hold again.
TEST(DriveController, LeadsBackFromBeyondALimit) {
  const auto begin = [] {
    auto rig = std::make_unique<Rig<test::LinkedArm>>(make_rig<test::LinkedArm>({3.3, -3.4}));
    EXPECT_EQ(rig->head().fault_kind, static_cast<int>(servo::FaultKind::position_limit));
    rig->command(servo::MessageKind::reset);
    rig->run(0.01);
    rig->command(servo::MessageKind::start);
    rig->run(0.5);
    EXPECT_EQ(rig->head().fault_kind, 0);
    return rig;
  };
  auto moved = begin();
  EXPECT_NEAR(moved->q(0), 3.3, 1e-6);  // it stays until it is told to come
  moved->send(Instruction::move_joint, {0, 0, 2.5}, 1.0);
  moved->send(Instruction::move_joint, {1, 1, 0.6}, 1.0);
  moved->run(1.5);
  EXPECT_NEAR(moved->q(0), 2.5, 1e-4);
  EXPECT_NEAR(moved->q(1), -2.8, 1e-4);
  auto dragged = begin();
  for (int i = 0; i < 90; ++i) {
    dragged->send(Instruction::drag_joint, {0, 2.0});
    dragged->run(0.033);
  }
  EXPECT_LT(dragged->q(0), 2.5);
  EXPECT_EQ(dragged->head().fault_kind, 0);
  auto yielding = begin();  // under a hand both joints come back by themselves
  yielding->send(Instruction::set_control, {2});
  yielding->run(3.0);
  EXPECT_LT(yielding->q(0), 3.0);
  EXPECT_GT(yielding->q(1), -3.0);
  EXPECT_EQ(yielding->head().fault_kind, 0);
  moved->run(0.1);
  EXPECT_EQ(moved->head().fault_kind, 0);
}

}  // namespace
}  // namespace treeline::drive
