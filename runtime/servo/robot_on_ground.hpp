#pragma once

#include <algorithm>
#include <array>

#include "servo/compliant_ground.hpp"
#include "servo/integrate.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::servo {

/// Functions of a robot some of whose points may touch the ground: their positions and velocities
/// in world axes, and the accelerations under forces on them, world axes, and a push elsewhere.
template <class F>
concept GroundedFunctions = requires(const StateOf<F>& state, const double (&q)[F::kCoordinates],
                                     const double (&qd)[F::kVelocities],
                                     const double (&tau)[F::kVelocities],
                                     const std::array<double, 3>& push,
                                     double (&qdd)[F::kVelocities],
                                     typename CompliantGround<F::kGroundPoints>::Vectors& x) {
  F::ground_points(q, qd, x, x);
  F::forward_dynamics(q, qd, tau, x, push, qdd);
};

/// A simulated robot, a proxy, that nothing holds but the ground, which only pushes. Torques are
/// constant between writes. Each call of `pass_time` integrates in `substeps` steps.
template <GroundedFunctions F>
class RobotOnGround {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;
  using Floating = FloatingJoints<nq, nv>;
  using Ground = CompliantGround<F::kGroundPoints>;

  RobotOnGround(const StateOf<F>& state, int substeps, const Floating& floating,
                const GroundMaterial& material = {}) noexcept
      : state_(state), substeps_(substeps), floating_(floating), ground_(material) {
    slide_springs();
  }

  bool connected() const noexcept { return true; }
  void read(StateOf<F>& state) const noexcept { state = state_; }
  void write(const double (&tau)[nv]) noexcept {
    std::copy(std::begin(tau), std::end(tau), std::begin(tau_));
  }
  void pass_time(double seconds) noexcept {
    const auto accelerations_at = [this](const double(&q)[nq], const double(&qd)[nv],
                                         double(&qdd)[nv]) noexcept {
      F::forward_dynamics(q, qd, tau_, forces_at(q, qd), push_, qdd);
    };
    for (int step = 0; step < substeps_; ++step) {
      integrate_runge_kutta<nq, nv>(floating_, seconds / substeps_, accelerations_at, state_);
      slide_springs();
    }
  }

  /// Pushes with this force (N, world axes) from now on.
  void push(const std::array<double, 3>& force) noexcept { push_ = force; }
  /// Forces of the ground on the points, N, world axes.
  typename Ground::Vectors ground_forces() const noexcept { return forces_at(state_.q, state_.qd); }
  /// Way that points have slid along the ground, all together, m.
  double slipped() const noexcept { return ground_.slipped(); }

 private:
  typename Ground::Vectors forces_at(const double (&q)[nq], const double (&qd)[nv]) const noexcept {
    typename Ground::Vectors x, v;
    F::ground_points(q, qd, x, v);
    return ground_.forces(x, v);
  }
  void slide_springs() noexcept {
    typename Ground::Vectors x, v;
    F::ground_points(state_.q, state_.qd, x, v);
    ground_.slide_springs(x);
  }

  StateOf<F> state_;
  double tau_[nv] = {};
  std::array<double, 3> push_{};
  int substeps_;
  Floating floating_;
  Ground ground_;
};

}  // namespace treeline::servo
