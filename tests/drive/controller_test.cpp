// Would catch: a goal that is not reached, a torque that steps where the control changes, a drag
// that goes on after its lease, a torque beyond its limit, a loop that allocates.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "../servo/allocation_counter.hpp"
#include "../servo/test_robots.hpp"
#include "drive/drive_loop.hpp"
#include "linked_robots.hpp"
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

/// Three slides along x, each on the one before, with 10, 1 and 0.1 kg at their ends. The last
/// one's place is the task.
struct Telescope {
  static constexpr int kCoordinates = 3;
  static constexpr int kVelocities = 3;
  static constexpr int kPoints = 1;
  static constexpr int kTaskRows = 1;
  static constexpr int kLinks = 0;
  static constexpr bool kHasCenterOfMass = false;
  static constexpr servo::FloatingJoints<3, 3> kFloating = {};
  static constexpr TaskRow kRows[] = {{0, 0}};
  static constexpr bool kLocalAxes[] = {false};
  static constexpr double kMasses[3] = {10, 1, 0.1};

  static void mass_matrix(const double (&)[3], double (&M)[9]) noexcept {
    for (int i = 0; i < 9; ++i) {
      const int further = std::max(i / 3, i % 3);
      M[i] = 0;
      for (int k = further; k < 3; ++k) M[i] += kMasses[k];
    }
  }
  static void inverse_dynamics(const double (&q)[3], const double (&)[3], const double (&qdd)[3],
                               double (&tau)[3]) noexcept {
    double M[9];
    mass_matrix(q, M);
    for (int i = 0; i < 3; ++i) {
      tau[i] = M[3 * i] * qdd[0] + M[3 * i + 1] * qdd[1] + M[3 * i + 2] * qdd[2];
    }
  }
  /// The force on each mass is that of its slide less that of the next one.
  static void forward_dynamics(const double (&)[3], const double (&)[3], const double (&tau)[3],
                               double (&qdd)[3]) noexcept {
    double before = 0;
    for (int i = 0; i < 3; ++i) {
      const double acceleration = (tau[i] - (i < 2 ? tau[i + 1] : 0)) / kMasses[i];
      qdd[i] = acceleration - before;
      before = acceleration;
    }
  }
  static void forward_kinematics(const double (&q)[3], double (&p)[3], double (&R)[9]) noexcept {
    const double at[3] = {q[0] + q[1] + q[2], 0, 0};
    const double turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::copy_n(at, 3, p);
    std::copy_n(turn, 9, R);
  }
  static void jacobian(const double (&)[3], double (&J)[3]) noexcept { std::fill_n(J, 3, 1.0); }
  /// A force on the last mass moves that one alone, whose inertia the task has.
  static void control_torque(const double (&q)[3], const double (&qd)[3],
                             const double (&posture)[3], const double (&xdd)[1],
                             double (&tau)[3]) noexcept {
    inverse_dynamics(q, qd, posture, tau);
    for (double& force : tau) {
      force += kMasses[2] * (xdd[0] - posture[0] - posture[1] - posture[2]);
    }
  }
};

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

/// What people do, in any order. Returns whether it is a drag.
template <class F>
bool do_something(Rig<F>& rig, std::mt19937& rng) {
  const auto between = [&rng](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(rng);
  };
  const int what = std::uniform_int_distribution<int>(0, 10)(rng);
  switch (what) {
    case 0:
    case 1:
      rig.send(Instruction::set_control, {std::floor(between(0, 3))});
      break;
    case 2:
      rig.send(Instruction::move_joint, {0, 0, between(-0.5, 1.2)}, between(0.6, 1.5));
      break;
    case 3:
      rig.send(Instruction::drag_joint, {1, between(0.5, 1.5)});
      break;
    case 4:
      rig.send(Instruction::move_point, {0, 1, between(-0.1, 0.1), 0, between(-0.1, 0.1)},
               between(0.6, 1.0));
      break;
    case 5:
      rig.send(Instruction::drag_point, {0, 0, between(1, 1.4), 0, between(0.8, 1.2)});
      break;
    case 6:
      rig.send(Instruction::release_point, {0});
      break;
    case 7:
      rig.send(Instruction::hold_point, {0});
      break;
    case 8:
      rig.send(Instruction::set_gains, {2, between(100, 400), between(20, 40)});
      break;
    case 9:
      rig.send(Instruction::pull_link, {1, 0.5, 0, 0, between(0.5, 1.5), 0, between(0.5, 1.5)});
      break;
    default:
      rig.send(Instruction::hold_all, {});
      break;
  }
  return what == 3 || what == 5;
}

/// `Arm` with links that can be pulled, and a solution for its task that stays finite where the arm
/// is stretched: J^T (J J^T + 0.05)^-1, as a generated function would have its own.
struct PulledArm : Arm {
  static constexpr int kLinks = 2;
  static constexpr auto& link_frames = test::LinkedArm::link_frames;
  static constexpr auto& link_inverse_dynamics = test::LinkedArm::link_inverse_dynamics;

  static void control_torque(const double (&q)[2], const double (&qd)[2], const double (&)[2],
                             const double (&xdd)[2], double (&tau)[2]) noexcept {
    double J[4];
    jacobian(q, J);
    const double w = qd[0] + qd[1];
    const double a[2] = {xdd[0] + std::cos(q[0]) * qd[0] * qd[0] + std::cos(q[0] + q[1]) * w * w,
                         xdd[1] + std::sin(q[0]) * qd[0] * qd[0] + std::sin(q[0] + q[1]) * w * w};
    const double A = J[0] * J[0] + J[1] * J[1] + 0.05;
    const double B = J[0] * J[2] + J[1] * J[3];
    const double C = J[2] * J[2] + J[3] * J[3] + 0.05;
    const double d = A * C - B * B;
    const double f[2] = {(C * a[0] - B * a[1]) / d, (A * a[1] - B * a[0]) / d};
    const double qdd[2] = {J[0] * f[0] + J[2] * f[1], J[1] * f[0] + J[3] * f[1]};
    inverse_dynamics(q, qd, qdd, tau);
  }
};

/// The largest change of a torque within one cycle that neither the cycle before nor the one after
/// has: a step, and no slope. Of the changes of three cycles, the newest last.
double isolated_step(const std::array<double, 3>& changes) {
  return std::fabs(changes[1]) - std::max(std::fabs(changes[0]), std::fabs(changes[2]));
}

// 2000 commands in any order, every 20 to 150 ms, in full swing. Torques are up to 100 N m and may
// change by some N m within a millisecond. A hand that drags far ahead begins with the largest
// jerk, 1250 rad/s^3 at 2 rad/s; nothing else makes a step.
TEST(DriveController, NoCommandMakesAStep) {
  std::mt19937 rng(11);
  auto rig = make_rig<PulledArm>({0.3, 0.8});
  std::array<std::array<double, 3>, 2> changes{};
  std::array<double, 2> last{rig.tau(0), rig.tau(1)};
  for (int i = 0; i < 2000; ++i) {
    const bool is_drag = do_something(rig, rng);
    double largest = 0.0;
    const int cycles = std::uniform_int_distribution<int>(20, 150)(rng);
    for (int cycle = 0; cycle < cycles; ++cycle) {
      rig.step();
      for (std::size_t k = 0; k < 2; ++k) {
        const double now = rig.tau(static_cast<int>(k));
        changes[k] = {changes[k][1], changes[k][2], now - std::exchange(last[k], now)};
        largest = std::max(largest, isolated_step(changes[k]));
      }
    }
    ASSERT_LT(largest, is_drag ? 3.0 : 0.8) << "after command " << i;
    ASSERT_EQ(rig.head().fault_kind, 0) << i;
  }
}

}  // namespace
}  // namespace treeline::drive
