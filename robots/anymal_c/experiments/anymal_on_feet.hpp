#pragma once

#include <algorithm>
#include <array>

#include "anymal_simulated.hpp"
#include "servo/robot_on_ground.hpp"

namespace treeline::experiments {

/// Feet in the order of the scenes: left fore, right fore, left hind, right hind.
constexpr int kFeet = 4;

/// ANYmal on four feet (servo/robot_on_ground.hpp), each a point that touches the ground or not.
struct AnymalOnFeet {
  static constexpr int kCoordinates = anymal_simulated::kCoordinates;
  static constexpr int kVelocities = anymal_simulated::kVelocities;
  static constexpr servo::FloatingJoints<kCoordinates, kVelocities> kFloating = {0};
  static constexpr int kGroundPoints = kFeet;
  using Vectors = servo::CompliantGround<kGroundPoints>::Vectors;

  /// Forces of joints in the air.
  static void inverse_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&qdd)[kVelocities],
                               double (&tau)[kVelocities]) noexcept {
    const double none[6 * kFeet] = {};
    anymal_simulated::inverse_dynamics(q, qd, qdd, none, tau);
  }

  /// Where the feet are, m, world axes.
  static void place_feet(const double (&q)[kCoordinates], Vectors& x) noexcept {
    double position[3 * kFeet];
    double rotation[9 * kFeet];
    anymal_simulated::forward_kinematics(q, position, rotation);
    for (std::size_t foot = 0; foot < x.size(); ++foot) {
      std::copy_n(position + 3 * foot, 3, x[foot].begin());
    }
  }

  static void ground_points(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                            Vectors& x, Vectors& v) noexcept {
    double J[3 * kFeet * kVelocities];
    place_feet(q, x);
    anymal_simulated::jacobian(q, J);
    for (std::size_t row = 0; row < 3 * kFeet; ++row) {
      double velocity = 0.0;
      for (std::size_t k = 0; k < kVelocities; ++k) velocity += J[row * kVelocities + k] * qd[k];
      v[row / 3][row % 3] = velocity;
    }
  }

  /// Nothing else pushes.
  static void forward_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&tau)[kVelocities], const Vectors& forces,
                               const std::array<double, 3>& /*push*/,
                               double (&qdd)[kVelocities]) noexcept {
    double f_ext[6 * kFeet] = {};
    for (std::size_t foot = 0; foot < forces.size(); ++foot) {
      std::copy_n(forces[foot].begin(), 3, f_ext + 6 * foot);
    }
    anymal_simulated::forward_dynamics(q, qd, tau, f_ext, qdd);
  }
};

using AnymalState = servo::StateOf<AnymalOnFeet>;

}  // namespace treeline::experiments
