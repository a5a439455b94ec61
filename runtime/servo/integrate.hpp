#pragma once

#include <array>
#include <cmath>

#include "servo/robot_proxy.hpp"

namespace treeline::servo {

/// Index in q of the first of the 7 coordinates of each floating joint, ascending; there are nq -
/// nv such joints. All other joints have one coordinate per velocity.
template <int nq, int nv>
using FloatingJoints = std::array<int, static_cast<std::size_t>(nq - nv)>;

/// Computes dq/dt for coordinates `q` and velocities `qd`. A floating joint has position and
/// quaternion x y z w, and as velocity a body twist, linear over angular; its rates are R v and q
/// (w, 0) / 2.
template <int nq, int nv>
void coordinate_rates(const FloatingJoints<nq, nv>& floating, const double (&q)[nq],
                      const double (&qd)[nv], double (&rates)[nq]) noexcept {
  int iq = 0;
  int iv = 0;
  const auto copy_up_to = [&](int end) {
    for (; iq < end; ++iq, ++iv) {
      rates[iq] = qd[iv];
    }
  };
  for (const int start : floating) {
    copy_up_to(start);
    const double x = q[iq + 3];
    const double y = q[iq + 4];
    const double z = q[iq + 5];
    const double w = q[iq + 6];
    const double* v = qd + iv;
    const double* omega = qd + iv + 3;
    // R v = v + 2 w (u x v) + 2 u x (u x v), where u is the vector part of the quaternion.
    const double cross[3] = {y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]};
    rates[iq] = v[0] + 2.0 * (w * cross[0] + y * cross[2] - z * cross[1]);
    rates[iq + 1] = v[1] + 2.0 * (w * cross[1] + z * cross[0] - x * cross[2]);
    rates[iq + 2] = v[2] + 2.0 * (w * cross[2] + x * cross[1] - y * cross[0]);
    rates[iq + 3] = 0.5 * (w * omega[0] + y * omega[2] - z * omega[1]);
    rates[iq + 4] = 0.5 * (w * omega[1] + z * omega[0] - x * omega[2]);
    rates[iq + 5] = 0.5 * (w * omega[2] + x * omega[1] - y * omega[0]);
    rates[iq + 6] = -0.5 * (x * omega[0] + y * omega[1] + z * omega[2]);
    iq += 7;
    iv += 6;
  }
  copy_up_to(nq);
}

/// Restores unit length of the quaternions, which a Runge-Kutta step preserves only to its order.
template <int nq, int nv>
void normalise_quaternions(const FloatingJoints<nq, nv>& floating, double (&q)[nq]) noexcept {
  for (const int start : floating) {
    double* quaternion = q + start + 3;
    const double norm = std::sqrt(quaternion[0] * quaternion[0] + quaternion[1] * quaternion[1] +
                                  quaternion[2] * quaternion[2] + quaternion[3] * quaternion[3]);
    for (int i = 0; i < 4; ++i) {
      quaternion[i] /= norm;
    }
  }
}

/// Advances the state by `dt` seconds by one step of the classical fourth-order Runge-Kutta method.
/// `accelerations_at(q, qd, qdd)` writes the accelerations.
template <int nq, int nv, class Accelerations>
void integrate_runge_kutta(const FloatingJoints<nq, nv>& floating, double dt,
                           const Accelerations& accelerations_at,
                           RobotState<nq, nv>& state) noexcept {
  constexpr double kFractions[4] = {0.0, 0.5, 0.5, 1.0};
  constexpr double kWeights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
  double rates[nq] = {};
  double accelerations[nv] = {};
  RobotState<nq, nv> sum = state;
  for (int stage = 0; stage < 4; ++stage) {
    RobotState<nq, nv> at = state;
    for (int i = 0; i < nq; ++i) {
      at.q[i] += kFractions[stage] * dt * rates[i];
    }
    for (int i = 0; i < nv; ++i) {
      at.qd[i] += kFractions[stage] * dt * accelerations[i];
    }
    coordinate_rates<nq, nv>(floating, at.q, at.qd, rates);
    accelerations_at(at.q, at.qd, accelerations);
    for (int i = 0; i < nq; ++i) {
      sum.q[i] += kWeights[stage] * dt * rates[i];
    }
    for (int i = 0; i < nv; ++i) {
      sum.qd[i] += kWeights[stage] * dt * accelerations[i];
    }
  }
  normalise_quaternions<nq, nv>(floating, sum.q);
  state = sum;
}

/// Advances the state by one Runge-Kutta step of `dt` seconds under constant joint forces `tau`.
template <SimulatedFunctions F>
void integrate_runge_kutta(const FloatingJoints<F::kCoordinates, F::kVelocities>& floating,
                           const double (&tau)[F::kVelocities], double dt,
                           StateOf<F>& state) noexcept {
  const auto accelerations_at =
      [&tau](const double(&q)[F::kCoordinates], const double(&qd)[F::kVelocities],
             double(&qdd)[F::kVelocities]) noexcept { F::forward_dynamics(q, qd, tau, qdd); };
  integrate_runge_kutta<F::kCoordinates, F::kVelocities>(floating, dt, accelerations_at, state);
}

}  // namespace treeline::servo
