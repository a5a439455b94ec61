#pragma once
// Robots that are driven by closed forms of their dynamics.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "../servo/test_robots.hpp"
#include "drive/drive_controller.hpp"
#include "rig.hpp"

namespace treeline::test {

/// The arm of two links with its tip as a point that moves in x and z.
struct PlanarArm : TwoLink {
  static constexpr int kPoints = 1;
  static constexpr int kTaskRows = 2;
  static constexpr int kLinks = 0;
  static constexpr bool kHasCenterOfMass = false;
  static constexpr servo::FloatingJoints<2, 2> kFloating = {};
  static constexpr drive::TaskRow kRows[] = {{0, 0}, {0, 2}};
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
  /// J qdd of joints that accelerate the tip so.
  static std::array<double, 2> without_bias(const double (&q)[2], const double (&qd)[2],
                                            const double (&xdd)[2]) noexcept {
    const double w = qd[0] + qd[1];
    return {xdd[0] + std::cos(q[0]) * qd[0] * qd[0] + std::cos(q[0] + q[1]) * w * w,
            xdd[1] + std::sin(q[0]) * qd[0] * qd[0] + std::sin(q[0] + q[1]) * w * w};
  }
  static void control_torque(const double (&q)[2], const double (&qd)[2], const double (&)[2],
                             const double (&xdd)[2], double (&tau)[2]) noexcept {
    double J[4];
    jacobian(q, J);
    const auto a = without_bias(q, qd, xdd);
    const double d = J[0] * J[3] - J[1] * J[2];
    const double qdd[2] = {(J[3] * a[0] - J[1] * a[1]) / d, (J[0] * a[1] - J[2] * a[0]) / d};
    inverse_dynamics(q, qd, qdd, tau);
  }
};

/// A free body that is held by forces on itself.
struct HeldBody : FreeBody {
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
  static constexpr drive::TaskRow kRows[] = {{0, 0}};
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

/// Joints go from -3 to 3, as the arm's and the body's do in these tests.
template <class F>
Rig<F> make_rig(std::vector<double> start, double torque_limit = kNone) {
  const std::array<double, F::kVelocities> torque = [&] {
    std::array<double, F::kVelocities> limits{};
    limits.fill(torque_limit);
    return limits;
  }();
  return Rig<F>(
      std::move(start), [&](drive::LoopOptions& options) { options.torque = torque.data(); }, 3.0);
}

}  // namespace treeline::test
