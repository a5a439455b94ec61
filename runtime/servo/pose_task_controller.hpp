#pragma once

#include <array>
#include <cstddef>

#include "core/command_laws.hpp"
#include "servo/message.hpp"
#include "servo/pose_reference.hpp"
#include "servo/robot_proxy.hpp"
#include "servo/task_rows.hpp"

namespace treeline::servo {

/// The functions that PoseTaskController calls, for operational points in world axes: a struct as
/// for RobotFunctions, with kTaskRows in addition, and kTaskRowNames unless each point has six
/// rows.
template <class F>
concept PoseTaskFunctions = RobotFunctions<F> && F::kCoordinates ==
                            F::kVelocities&& requires(const double (&q)[F::kCoordinates],
                                                      const double (&qd)[F::kVelocities],
                                                      const double (&xdd)[F::kTaskRows],
                                                      double (&tau)[F::kVelocities],
                                                      double (&J)[F::kTaskRows * F::kVelocities],
                                                      double (&position)[3 * kTaskPoints<F>],
                                                      double (&rotation)[9 * kTaskPoints<F>]) {
  F::forward_kinematics(q, position, rotation);
  F::jacobian(q, J);
  F::control_torque(q, qd, qd, xdd, tau);
};

/// A posture of joint accelerations: qdd_0 = kp_i (q_advised - q) - kv_i qd per joint.
template <class F>
class AcceleratedPosture {
 public:
  static constexpr int nv = F::kVelocities;
  using Gains = std::array<core::Gains<double>, nv>;

  AcceleratedPosture(const Gains& gains) noexcept : gains_(gains) {}  // NOLINT: gains are it

  void advise(const StateOf<F>& state, const double (&advised)[nv],
              double (&qdd_0)[nv]) const noexcept {
    for (int i = 0; i < nv; ++i) {
      const core::Gains<double>& gains = gains_[static_cast<std::size_t>(i)];
      qdd_0[i] = gains.kp * (advised[i] - state.q[i]) - gains.kv * state.qd[i];
    }
  }

 private:
  Gains gains_;
};

/// Gains of a posture for joints alike, but ten times as fast for those that move no row of the
/// task at q, such as fingers. What accelerates the task pushes light ones with it.
template <PoseTaskFunctions F>
typename AcceleratedPosture<F>::Gains posture_gains(const double (&q)[F::kCoordinates],
                                                    const core::Gains<double>& gains) noexcept {
  constexpr int nv = F::kVelocities;
  double J[F::kTaskRows * nv];
  F::jacobian(q, J);
  typename AcceleratedPosture<F>::Gains all;
  for (int i = 0; i < nv; ++i) {
    bool moves = false;
    for (int row = 0; row < F::kTaskRows; ++row) moves = moves || J[row * nv + i] != 0;
    all[static_cast<std::size_t>(i)] = {moves ? gains.kp : 100 * gains.kp,
                                        moves ? gains.kv : 10 * gains.kv};
  }
  return all;
}

/// Operational-space control of poses, or of those of their rows that the task has (Chang
/// table 6.1), with a desired posture in the null space:
///   xdd_cmd = xdd_ref + kv (xd_ref - xd) + kp (x_ref - x), orientation by its rotation vector,
///   qdd_0   by `Posture`: joint accelerations, or the springs of `SpringPosture`.
/// Only for robots whose joints have one degree of freedom. On `start` every point holds its
/// present pose, and the desired posture is the present one unless it was set before.
template <PoseTaskFunctions F, class Posture = AcceleratedPosture<F>>
class PoseTaskController {
 public:
  static constexpr int kPoints = kTaskPoints<F>;
  static constexpr int nv = F::kVelocities;

  /// Desired and actual pose of a point at the last call of `control`.
  struct Tracking {
    PoseMotion wanted;
    double position[3] = {};
    double rotation[9] = {};
    double error[6] = {};  ///< desired minus actual, linear over angular
  };

  PoseTaskController(const core::Gains<double>& task, const Posture& posture) noexcept
      : task_(task), posture_(posture) {}

  void start(double, const StateOf<F>& state) noexcept {
    double positions[3 * kPoints];
    double rotations[9 * kPoints];
    F::forward_kinematics(state.q, positions, rotations);
    for (int k = 0; k < kPoints; ++k) {
      Tracking& point = tracking_[static_cast<std::size_t>(k)];
      take_pose(positions, rotations, k, point);
      references_[static_cast<std::size_t>(k)].hold(point.position, point.rotation);
    }
    if (!posture_set_) {
      for (int i = 0; i < nv; ++i) {
        advised_[i] = state.q[i];
      }
    }
  }

  /// Applies a message. move_point starts from the pose that is desired at `time`. Messages for
  /// points or sizes that do not exist are ignored.
  void apply(double time, const Message& message) noexcept {
    if (message.kind == MessageKind::move_point && message.index >= 0 && message.index < kPoints &&
        message.duration > 0.0) {
      move(time, message);
    } else if (message.kind == MessageKind::set_posture && nv <= kMessageNumbers) {
      posture_set_ = true;
      for (int i = 0; i < nv; ++i) {
        advised_[i] = message.values[static_cast<std::size_t>(i)];
      }
    } else if (message.kind == MessageKind::set_gains) {
      task_ = {message.values[0], message.values[1]};
    }
  }

  void control(double time, const StateOf<F>& state, double (&tau)[F::kVelocities]) noexcept {
    double positions[3 * kPoints];
    double rotations[9 * kPoints];
    double J[F::kTaskRows * nv];
    F::forward_kinematics(state.q, positions, rotations);
    F::jacobian(state.q, J);
    double xdd_cmd[F::kTaskRows];
    for (int k = 0; k < kPoints; ++k) {
      command_point(time, positions, rotations, J, state, k, xdd_cmd);
    }
    double qdd_0[nv];
    posture_.advise(state, advised_, qdd_0);
    F::control_torque(state.q, state.qd, qdd_0, xdd_cmd, tau);
  }

  /// Compares points with their references, see `find_left_behind`.
  template <class Visit>
  void compare(double time, Visit&& visit) const noexcept {
    constexpr std::array<bool, static_cast<std::size_t>(kPoints)> kLocalAxes{};
    constexpr auto kCompared = compared_rows<kLocalAxes.size()>(kRows, kLocalAxes);
    for (std::size_t k = 0; k < kCompared.size(); ++k) {
      visit(away_of(tracking_[k].error, kCompared[k]), -1, time - references_[k].start_time(),
            references_[k].duration());
    }
  }

  /// Loads the functions of a cycle into the caches, where F has a `prefetch` that does so. Without
  /// it the loop has no reason to wake earlier.
  void prepare() const noexcept requires requires { F::prefetch(); }
  { F::prefetch(); }

  const Tracking& tracking(int point) const noexcept {
    return tracking_[static_cast<std::size_t>(point)];
  }

 private:
  static void take_pose(const double* positions, const double* rotations, int k,
                        Tracking& point) noexcept {
    for (int i = 0; i < 3; ++i) {
      point.position[i] = positions[3 * k + i];
    }
    for (int i = 0; i < 9; ++i) {
      point.rotation[i] = rotations[9 * k + i];
    }
  }

  void move(double time, const Message& message) noexcept {
    double position[3];
    double rotation[9];
    for (std::size_t i = 0; i < 3; ++i) {
      position[i] = message.values[i];
    }
    for (std::size_t i = 0; i < 9; ++i) {
      rotation[i] = message.values[3 + i];
    }
    PoseReference& reference = references_[static_cast<std::size_t>(message.index)];
    const PoseMotion from = reference.at(time);
    reference.move(time, from.position, from.rotation, position, rotation, message.duration);
  }

  void command_point(double time, const double* positions, const double* rotations, const double* J,
                     const StateOf<F>& state, int k, double (&xdd_cmd)[F::kTaskRows]) noexcept {
    Tracking& point = tracking_[static_cast<std::size_t>(k)];
    take_pose(positions, rotations, k, point);
    point.wanted = references_[static_cast<std::size_t>(k)].at(time);
    core::pose_error(point.position, point.rotation, point.wanted.position, point.wanted.rotation,
                     point.error);
    double velocity[6] = {};
    for (int row = 0; row < F::kTaskRows; ++row) {
      const TaskRow& of = kRows[static_cast<std::size_t>(row)];
      for (int i = 0; of.point == k && i < nv; ++i) {
        velocity[of.axis] += J[row * nv + i] * state.qd[i];
      }
    }
    double acceleration[6];
    core::tracking_law(task_, point.error, velocity, point.wanted.velocity,
                       point.wanted.acceleration, acceleration);
    for (int row = 0; row < F::kTaskRows; ++row) {
      const TaskRow& of = kRows[static_cast<std::size_t>(row)];
      if (of.point == k) xdd_cmd[row] = acceleration[of.axis];
    }
  }

  static constexpr auto kRows = task_rows_of<F>();

  core::Gains<double> task_;
  Posture posture_;
  std::array<PoseReference, static_cast<std::size_t>(kPoints)> references_;
  std::array<Tracking, static_cast<std::size_t>(kPoints)> tracking_{};
  double advised_[nv] = {};
  bool posture_set_ = false;
};

}  // namespace treeline::servo
