#pragma once

#include <algorithm>
#include <array>

#include "core/orientation.hpp"
#include "humanoid24_push.hpp"
#include "humanoid24_pushed.hpp"
#include "servo/robot_on_ground.hpp"

namespace treeline::experiments {

/// The humanoid on the corners of its soles (servo/robot_on_ground.hpp), pushed at its chest. The
/// root link carries both soles, left corners come first.
struct HumanoidOnSoles {
  static constexpr int kCoordinates = humanoid24_push::kCoordinates;
  static constexpr int kVelocities = humanoid24_push::kVelocities;
  static constexpr servo::FloatingJoints<kCoordinates, kVelocities> kFloating = {0};
  static constexpr int kGroundPoints = 8;
  using Vectors = servo::CompliantGround<kGroundPoints>::Vectors;
  static constexpr auto& inverse_dynamics = humanoid24_push::inverse_dynamics;

  /// Edges of the soles in the root link's frame (README.md), m.
  static constexpr double kHeel = -0.065, kToe = 0.193, kInside = 0.045, kOutside = 0.135;
  static constexpr double kCorners[kGroundPoints][2] = {
      {kHeel, kInside},  {kToe, kInside},  {kHeel, kOutside},  {kToe, kOutside},
      {kHeel, -kInside}, {kToe, -kInside}, {kHeel, -kOutside}, {kToe, -kOutside}};

  static void rotation_of(const double (&q)[kCoordinates], double (&R)[9]) noexcept {
    const double quaternion[4] = {q[3], q[4], q[5], q[6]};
    core::rotation_from_quaternion(quaternion, R);
  }

  static void ground_points(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                            Vectors& x, Vectors& v) noexcept {
    double R[9];
    rotation_of(q, R);
    for (std::size_t corner = 0; corner < x.size(); ++corner) {
      const double(&r)[2] = kCorners[corner];
      const double velocity[3] = {qd[0] - qd[5] * r[1], qd[1] + qd[5] * r[0],
                                  qd[2] + qd[3] * r[1] - qd[4] * r[0]};
      for (std::size_t i = 0; i < 3; ++i) {
        x[corner][i] = q[i] + R[3 * i] * r[0] + R[3 * i + 1] * r[1];
        v[corner][i] = 0.0;
        for (std::size_t k = 0; k < 3; ++k) v[corner][i] += R[3 * i + k] * velocity[k];
      }
    }
  }

  static void forward_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&tau)[kVelocities], const Vectors& forces,
                               const std::array<double, 3>& push,
                               double (&qdd)[kVelocities]) noexcept {
    double R[9];
    rotation_of(q, R);
    double f_ext[12] = {};  // on the soles in the root's axes, then on the chest
    for (std::size_t corner = 0; corner < forces.size(); ++corner) {
      double force[3] = {};
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) force[i] += R[3 * k + i] * forces[corner][k];
      }
      const double(&r)[2] = kCorners[corner];
      const double moment[3] = {r[1] * force[2], -r[0] * force[2],
                                r[0] * force[1] - r[1] * force[0]};
      for (std::size_t i = 0; i < 3; ++i) {
        f_ext[i] += force[i];
        f_ext[3 + i] += moment[i];
      }
    }
    std::copy(push.begin(), push.end(), f_ext + 6);
    humanoid24_pushed::forward_dynamics(q, qd, tau, f_ext, qdd);
  }
};

}  // namespace treeline::experiments
