#pragma once
// Robots with links that can be pulled and pushed, small enough for closed forms.

#include <algorithm>
#include <cmath>

#include "../servo/test_robots.hpp"
#include "drive/drive_controller.hpp"
#include "servo/integrate.hpp"

namespace treeline::test {

/// A carriage of 2 kg on slides along x, y and z, gravity 9.81 along -z, with a point at its
/// origin.
struct Gantry {
  static constexpr int kCoordinates = 3;
  static constexpr int kVelocities = 3;
  static constexpr int kPoints = 1;
  static constexpr int kTaskRows = 3;
  static constexpr int kLinks = 1;
  static constexpr bool kHasCenterOfMass = false;
  static constexpr servo::FloatingJoints<3, 3> kFloating = {};
  static constexpr drive::TaskRow kRows[] = {{0, 0}, {0, 1}, {0, 2}};
  static constexpr bool kLocalAxes[] = {false};
  static constexpr double kMass = 2.0;
  static constexpr double kWeight = 2.0 * 9.81;

  static void inverse_dynamics(const double (&)[3], const double (&)[3], const double (&qdd)[3],
                               double (&tau)[3]) noexcept {
    for (int i = 0; i < 3; ++i) tau[i] = kMass * qdd[i] + (i == 2 ? kWeight : 0.0);
  }
  static void forward_dynamics(const double (&)[3], const double (&)[3], const double (&tau)[3],
                               double (&qdd)[3]) noexcept {
    for (int i = 0; i < 3; ++i) qdd[i] = (tau[i] - (i == 2 ? kWeight : 0.0)) / kMass;
  }
  static void forward_kinematics(const double (&q)[3], double (&p)[3], double (&R)[9]) noexcept {
    std::copy_n(q, 3, p);
    for (int i = 0; i < 9; ++i) R[i] = i % 4 == 0 ? 1.0 : 0.0;
  }
  static void jacobian(const double (&)[3], double (&J)[9]) noexcept {
    for (int i = 0; i < 9; ++i) J[i] = i % 4 == 0 ? 1.0 : 0.0;
  }
  static void control_torque(const double (&q)[3], const double (&qd)[3], const double (&)[3],
                             const double (&xdd)[3], double (&tau)[3]) noexcept {
    inverse_dynamics(q, qd, xdd, tau);
  }
  static void link_frames(const double (&q)[3], double (&p)[3], double (&R)[9]) noexcept {
    forward_kinematics(q, p, R);
  }
  static void link_inverse_dynamics(const double (&q)[3], const double (&qd)[3],
                                    const double (&qdd)[3], const double (&f)[6],
                                    double (&tau)[3]) noexcept {
    inverse_dynamics(q, qd, qdd, tau);
    for (int i = 0; i < 3; ++i) tau[i] -= f[i];
  }
};

/// `TwoLink` without an operational point; the frames of its links are at the joints.
struct LinkedArm : TwoLink {
  static constexpr int kPoints = 0;
  static constexpr int kTaskRows = 0;
  static constexpr int kLinks = 2;
  static constexpr bool kHasCenterOfMass = false;
  static constexpr servo::FloatingJoints<2, 2> kFloating = {};

  static void link_frames(const double (&q)[2], double (&p)[6], double (&R)[18]) noexcept {
    const double at[6] = {0, 0, 0, std::cos(q[0]), 0, std::sin(q[0])};
    std::copy_n(at, 6, p);
    for (int link = 0; link < 2; ++link) {
      const double angle = link == 0 ? q[0] : q[0] + q[1];
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const double turn[9] = {c, 0, -s, 0, 1, 0, s, 0, c};
      std::copy_n(turn, 9, R + 9 * link);
    }
  }
  /// Forces are [force; moment] at the links' origins, on the links.
  static void link_inverse_dynamics(const double (&q)[2], const double (&qd)[2],
                                    const double (&qdd)[2], const double (&f)[12],
                                    double (&tau)[2]) noexcept {
    inverse_dynamics(q, qd, qdd, tau);
    // A positive angle lifts: the joints turn about -y. The elbow's force acts at its place.
    const double about_elbow = -f[10];
    const double about_shoulder =
        -f[4] + about_elbow + std::cos(q[0]) * f[8] - std::sin(q[0]) * f[6];
    tau[0] -= about_shoulder;
    tau[1] -= about_elbow;
  }
};

}  // namespace treeline::test
