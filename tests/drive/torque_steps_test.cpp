// Would catch: a torque that steps where a command, the control or a gain changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "drive/drive_loop.hpp"
#include "driven_robots.hpp"
#include "linked_robots.hpp"

namespace treeline::drive {
namespace {

using test::make_rig;
using test::Rig;
using Arm = test::PlanarArm;

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
    const auto a = without_bias(q, qd, xdd);
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
// jerk, 1250 rad/s^3 at 2 rad/s; nothing else makes a step. Of 60000 commands two had more than 0.8
// N m: 1.1 on a slope, long after a command, and 1.3 a millisecond after a pull.
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
    ASSERT_LT(largest, is_drag ? 3.0 : 1.5) << "after command " << i;
    ASSERT_EQ(rig.head().fault_kind, 0) << i;
  }
}

}  // namespace
}  // namespace treeline::drive
