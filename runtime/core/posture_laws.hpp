#pragma once
// Laws for the posture (Chang section 2.5): each adds a joint acceleration to qdd_0, the input of
// control_torque, which lets of their sum only that act which does not disturb the task. C++17,
// freestanding, fixed size; one-degree joints. Joint PD is `joint_law` in command_laws.hpp.
//
// A posture torque tau_0 is asked for by qdd_0 = forward_dynamics(q, qd, tau_0): then
// control_torque is J^T F + N^T tau_0 of Chang eq. 2.2. A law here is such a torque divided by the
// joint-space inertia, so that its gains are in 1/s^2 and 1/s for every robot.

#include "core/command_laws.hpp"
#include "core/prioritized_solve.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// qdd -= kv qd.
template <int N, class Real>
constexpr void add_damping(Real kv, const Real (&qd)[N], Real (&qdd)[N]) noexcept {
  for (int i = 0; i < N; ++i) {
    qdd[i] -= kv * qd[i];
  }
}

/// qdd -= dV/dq for a potential of the caller, V in rad^2/s^2: `gradient(q, out)` writes dV/dq.
template <int N, class Real, class Gradient>
inline void add_potential(const Gradient& gradient, const Real (&q)[N], Real (&qdd)[N]) noexcept {
  Real slope[N];
  gradient(q, slope);
  for (int i = 0; i < N; ++i) {
    qdd[i] -= slope[i];
  }
}

/// Subtracts the gradient of a potential of which only V(q) is known: central differences of `step`
/// (rad), exact for potentials up to the second degree.
template <int N, class Real, class Potential>
inline void add_potential_by_differences(const Potential& potential, Real step, const Real (&q)[N],
                                         Real (&qdd)[N]) noexcept {
  const auto potential_at = [&potential, &q](int joint, Real away) noexcept {
    Real moved[N];
    for (int i = 0; i < N; ++i) {
      moved[i] = i == joint ? q[i] + away : q[i];
    }
    return potential(moved);
  };
  for (int i = 0; i < N; ++i) {
    const Real above = potential_at(i, step);
    const Real below = potential_at(i, -step);
    qdd[i] -= (above - below) / (Real(2) * step);
  }
}

/// Keeps joints away from their limits: within `margin` (rad, positive) of a limit the acceleration
/// grows smoothly from 0 to `strength` (rad/s^2) at the limit, which it never exceeds; `kv` damps
/// by the same share. No effect farther away. Limits at infinity are allowed.
template <int N, class Real>
constexpr void add_limit_avoidance(const Real (&lower)[N], const Real (&upper)[N], Real margin,
                                   Real strength, Real kv, const Real (&q)[N], const Real (&qd)[N],
                                   Real (&qdd)[N]) noexcept {
  for (int i = 0; i < N; ++i) {
    const Real from_lower = smooth_step(Real(1) - (q[i] - lower[i]) / margin);
    const Real from_upper = smooth_step(Real(1) - (upper[i] - q[i]) / margin);
    const Real share = from_lower > from_upper ? from_lower : from_upper;
    qdd[i] += strength * (from_lower - from_upper) - kv * share * qd[i];
  }
}

/// The point of a convex polygon that is nearest to `point`: `point` itself when inside. K >= 3
/// corners x0 y0 x1 y1 ..., counter-clockwise, no two equal.
template <int twoK, class Real>
constexpr void nearest_in_polygon(const Real (&corners)[twoK], const Real (&point)[2],
                                  Real (&nearest)[2]) noexcept {
  static_assert(twoK >= 6 && twoK % 2 == 0, "a polygon has three corners or more");
  bool inside = true;
  Real least = Real(-1);
  Real best[2] = {point[0], point[1]};
  for (int k = 0; k < twoK; k += 2) {
    const int next = (k + 2) % twoK;
    const Real edge[2] = {corners[next] - corners[k], corners[next + 1] - corners[k + 1]};
    const Real from[2] = {point[0] - corners[k], point[1] - corners[k + 1]};
    inside = inside && edge[0] * from[1] - edge[1] * from[0] >= Real(0);
    const Real along =
        (edge[0] * from[0] + edge[1] * from[1]) / (edge[0] * edge[0] + edge[1] * edge[1]);
    const Real t = along > Real(0) ? (along < Real(1) ? along : Real(1)) : Real(0);
    const Real away[2] = {from[0] - t * edge[0], from[1] - t * edge[1]};
    const Real distance = away[0] * away[0] + away[1] * away[1];
    if (least < Real(0) || distance < least) {
      least = distance;
      best[0] = corners[k] + t * edge[0];
      best[1] = corners[k + 1] + t * edge[1];
    }
  }
  nearest[0] = inside ? point[0] : best[0];
  nearest[1] = inside ? point[1] : best[1];
}

/// Balance: brings the centre of mass over `goal` (its horizontal coordinates, m; for a support
/// polygon the `nearest_in_polygon`) by the smallest joint acceleration that gives it the
/// acceleration kp (goal - x) - kv xd. `J_com`: the two horizontal rows of the centre of mass's
/// Jacobian, m. Directions in which the joints move it by less than `least` (m per rad) are let go
/// smoothly.
template <int N, int twoN, class Real>
inline void add_balance(const Gains<Real>& gains, const Real (&goal)[2], const Real (&com)[2],
                        const Real (&J_com)[twoN], Real least, const Real (&qd)[N],
                        Real (&qdd)[N]) noexcept {
  static_assert(twoN == 2 * N, "J_com holds 2 x N numbers");
  Real A[4];
  for (int i = 0; i < 4; ++i) {
    A[i] = i % 3 == 0 ? least * least : Real(0);
  }
  Real missing[2] = {gains.kp * (goal[0] - com[0]), gains.kp * (goal[1] - com[1])};
  for (int row = 0; row < 2; ++row) {
    for (int i = 0; i < N; ++i) {
      missing[row] -= gains.kv * J_com[row * N + i] * qd[i];
      A[2 * row] += J_com[row * N + i] * J_com[i];
      A[2 * row + 1] += J_com[row * N + i] * J_com[N + i];
    }
  }
  prioritized_solve<2>(A, Real(1e-6), missing);
  add_task_torque<2, N>(J_com, missing, qdd);
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
