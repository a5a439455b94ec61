// Would catch: a goal that is not reached, a torque that steps where the control changes, a drag
// that goes on after its lease, a torque beyond its limit, a loop that allocates.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "../servo/allocation_counter.hpp"
#include "../servo/test_robots.hpp"
#include "drive/drive_loop.hpp"
#include "rig.hpp"

namespace treeline::drive {
namespace {

using test::kNone;

/// The arm of two links with its tip as a point that moves in x and z.
struct Arm : test::TwoLink {
  static constexpr int kPoints = 1;
  static constexpr int kTaskRows = 2;
  static constexpr int kLinks = 0;
  static constexpr bool kHasCenterOfMass = false;
  static constexpr servo::FloatingJoints<2, 2> kFloating = {};
  static constexpr TaskRow kRows[] = {{0, 0}, {0, 2}};
  static constexpr bool kLocalAxes[] = {false};

  static void forward_kinematics(const double (&q)[2], double (&p)[3], double (&R)[9]) noexcept {
    const double c = std::cos(q[0] + q[1]);
    const double s = std::sin(q[0] + q[1]);
    const double at[3] = {std::cos(q[0]) + c, 0, std::sin(q[0]) + s};
    const double turn[9] = {c, 0, -s, 0, 1, 0, s, 0, c};
    std::copy_n(at, 3, p);
    std::copy_n(turn, 9, R);
  }
  static void jacobian(const double (&q)[2], double (&J)[4]) noexcept {
    J[1] = -std::sin(q[0] + q[1]);
    J[0] = J[1] - std::sin(q[0]);
    J[3] = std::cos(q[0] + q[1]);
    J[2] = J[3] + std::cos(q[0]);
  }
  static void control_torque(const double (&q)[2], const double (&qd)[2], const double (&)[2],
                             const double (&xdd)[2], double (&tau)[2]) noexcept {
    double J[4];
    jacobian(q, J);
    const double w = qd[0] + qd[1];
    const double a[2] = {xdd[0] + std::cos(q[0]) * qd[0] * qd[0] + std::cos(q[0] + q[1]) * w * w,
                         xdd[1] + std::sin(q[0]) * qd[0] * qd[0] + std::sin(q[0] + q[1]) * w * w};
    const double d = J[0] * J[3] - J[1] * J[2];
    const double qdd[2] = {(J[3] * a[0] - J[1] * a[1]) / d, (J[0] * a[1] - J[2] * a[0]) / d};
    inverse_dynamics(q, qd, qdd, tau);
  }
};

/// A free body that is held by forces on itself.
struct Body : test::FreeBody {
  static constexpr int kPoints = 0;
  static constexpr int kTaskRows = 0;
  static constexpr int kLinks = 0;
  static constexpr bool kHasCenterOfMass = false;
  static constexpr servo::FloatingJoints<7, 6> kFloating = {0};
  /// Forward dynamics is affine in tau, by rows.
  static void inverse_dynamics(const double (&q)[7], const double (&qd)[6], const double (&qdd)[6],
                               double (&tau)[6]) noexcept {
    const double none[6] = {};
    double free[6];
    forward_dynamics(q, qd, none, free);
    for (int i = 0; i < 6; ++i) tau[i] = (i < 3 ? kMass : kInertia[i - 3]) * (qdd[i] - free[i]);
  }
};

template <class F>
using Rig = test::Rig<F>;

/// Joints go from -3 to 3, as the arm's and the body's do in these tests.
template <class F>
Rig<F> make_rig(std::vector<double> start, double torque_limit = kNone) {
  const std::array<double, F::kVelocities> torque = [&] {
    std::array<double, F::kVelocities> limits{};
    limits.fill(torque_limit);
    return limits;
  }();
  return Rig<F>(
      std::move(start), [&](LoopOptions& options) { options.torque = torque.data(); }, 3.0);
}

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

// The torque is about 30 N m. Motions that begin, are interrupted or change the control in full
// swing change it by little from one cycle to the next.
TEST(DriveController, TorquesHaveNoStep) {
  auto rig = make_rig<Arm>({0.3, 0.8});
  rig.take_step();
  const auto expect_smooth = [&](const char* when) {
    const double step = rig.take_step();
    EXPECT_LT(step, 1.0) << when;
  };
  rig.send(Instruction::move_point, {0, 0, 0.9, 0, 1.1}, 1.0);
  rig.run(0.4);
  expect_smooth("a point begins to move");
  rig.send(Instruction::move_point, {0, 0, 1.2, 0, 0.9}, 1.0);
  rig.run(0.4);
  expect_smooth("another goal in full swing");
  rig.send(Instruction::move_joint, {1, 0, 1.0}, 1.0);
  rig.run(0.4);
  expect_smooth("joint control in full swing");
  rig.send(Instruction::set_control, {2});
  rig.run(0.4);
  expect_smooth("gravity compensation in full swing");
  rig.send(Instruction::set_control, {1});
  rig.run(0.4);
  expect_smooth("task control");
  rig.send(Instruction::set_gains, {2, 400, 40});
  rig.send(Instruction::hold_all, {});
  rig.run(0.4);
  expect_smooth("other gains, and hold");
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

}  // namespace
}  // namespace treeline::drive
