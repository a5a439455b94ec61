#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/command_laws.hpp"
#include "core/ldlt.hpp"
#include "servo/message.hpp"
#include "servo/pose_reference.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::experiments {

/// Posture in the null space: qdd_0 = M^-1 (K (q_start - q) - D qd), K and D springs and dampers of
/// the joints. It consists of springs and not of accelerations. Springs have a potential in the
/// null space, so the posture comes to rest at its minimum. Accelerations k_i (q_start - q) with
/// different k_i have none and can be unstable there.
template <class F>
class JointSprings {
 public:
  static constexpr int nv = F::kVelocities;

  /// `springs` are in N m/rad or N/m. `damping_ratio` relates to each joint's spring with its own
  /// inertia.
  JointSprings(const std::array<double, nv>& springs, double damping_ratio) noexcept
      : springs_(springs), damping_ratio_(damping_ratio) {}

  void start(const servo::StateOf<F>& state) noexcept {
    for (int i = 0; i < nv; ++i) {
      advised_[i] = state.q[i];
    }
  }

  /// qdd_0 is zero if M cannot be factored.
  void advise(const servo::StateOf<F>& state, double (&qdd_0)[nv]) const noexcept {
    double M[nv * nv];
    F::mass_matrix(state.q, M);
    for (int i = 0; i < nv; ++i) {
      const double spring = springs_[static_cast<std::size_t>(i)];
      const double damper = 2.0 * damping_ratio_ * std::sqrt(spring * M[i * nv + i]);
      qdd_0[i] = spring * (advised_[i] - state.q[i]) - damper * state.qd[i];
    }
    const bool regular = core::ldlt_factor<nv>(M);
    core::ldlt_solve<nv>(M, qdd_0);
    for (int i = 0; i < nv; ++i) {
      qdd_0[i] = regular ? qdd_0[i] : 0.0;
    }
  }

 private:
  std::array<double, nv> springs_;
  double damping_ratio_;
  double advised_[nv] = {};
};

/// The posture of robots whose joints are all taken by the task: none.
template <class F>
struct NoPosture {
  void start(const servo::StateOf<F>&) const noexcept {}
  void advise(const servo::StateOf<F>&, double (&qdd_0)[F::kVelocities]) const noexcept {
    std::fill(std::begin(qdd_0), std::end(qdd_0), 0.0);
  }
};

/// Operational-space control of one object in several hands (Chang table 7.1) with commanded
/// internal forces and a desired posture in the null space:
///   xdd = xdd_ref + kv (xd_ref - xd) + kp (x_ref - x), orientation by its rotation vector.
/// On `start` the object holds its present pose; move_point for point 0 moves it.
template <class F, class Posture = JointSprings<F>>
class ObjectTaskController {
 public:
  static constexpr int nv = F::kVelocities;

  /// The object at the last call of `control`.
  struct Tracking {
    servo::PoseMotion wanted;
    double position[3] = {};
    double rotation[9] = {};
    double error[6] = {};          ///< desired minus actual, linear over angular
    double drift[F::kDrift] = {};  ///< of each further grasp relative to the first
  };

  ObjectTaskController(const core::Gains<double>& task, const Posture& posture,
                       const std::array<double, F::kInternal>& internal) noexcept
      : task_(task), posture_(posture) {
    std::copy(internal.begin(), internal.end(), internal_);
  }

  void start(double, const servo::StateOf<F>& state) noexcept {
    observe(state);
    reference_.hold(tracking_.position, tracking_.rotation);
    posture_.start(state);
  }

  void apply(double time, const servo::Message& message) noexcept {
    if (message.kind != servo::MessageKind::move_point || message.index != 0 ||
        !(message.duration > 0.0)) {
      return;
    }
    double position[3];
    double rotation[9];
    for (std::size_t i = 0; i < 3; ++i) {
      position[i] = message.values[i];
    }
    for (std::size_t i = 0; i < 9; ++i) {
      rotation[i] = message.values[3 + i];
    }
    const servo::PoseMotion from = reference_.at(time);
    reference_.move(time, from.position, from.rotation, position, rotation, message.duration);
  }

  void control(double time, const servo::StateOf<F>& state,
               double (&tau)[F::kVelocities]) noexcept {
    observe(state);
    tracking_.wanted = reference_.at(time);
    core::pose_error(tracking_.position, tracking_.rotation, tracking_.wanted.position,
                     tracking_.wanted.rotation, tracking_.error);
    double xdd[6];
    core::tracking_law(task_, tracking_.error, velocity_, tracking_.wanted.velocity,
                       tracking_.wanted.acceleration, xdd);
    double qdd_0[nv];
    posture_.advise(state, qdd_0);
    F::object_control_torque(state.q, state.qd, qdd_0, xdd, internal_, tau);
  }

  const Tracking& tracking() const noexcept { return tracking_; }

 private:
  void observe(const servo::StateOf<F>& state) noexcept {
    double drift_rate[F::kDrift];
    F::object_state(state.q, state.qd, tracking_.position, tracking_.rotation, velocity_,
                    tracking_.drift, drift_rate);
  }

  core::Gains<double> task_;
  Posture posture_;
  double internal_[F::kInternal] = {};
  servo::PoseReference reference_;
  Tracking tracking_;
  double velocity_[6] = {};
};

}  // namespace treeline::experiments
