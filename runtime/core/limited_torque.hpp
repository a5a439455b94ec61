#pragma once
// Torques of motors within their limits, forces of supports within their friction cones. C++17,
// freestanding, no heap, a stated bound on the work.
//
// tau and f of an unlimited law obey M qdd + h = S^T tau + J_s^T f and J_s qdd + Jd_s qd = 0. All
// that can be changed about them keeps both:
//
//     M d_qdd = S^T d_tau + J_s^T d_f,   J_s d_qdd = 0.
//
// Of all changes that bring tau and f within their limits, the one of least cost is taken:
//
//     1/2 k^2 |d_xdd|^2_D + 1/2 d_qdd^T M d_qdd + 1/2 |d_z|^2 / (k^2 m) + penalty(slack)
//
// -d_xdd = -J_t d_qdd is what the task loses, D its effective masses, z the forces that carry
// nothing (internal forces of two feet). k is large, so that forces give way first, then the
// posture, then the task: the limit k -> infinity is the strict hierarchy of Escande, Mansard &
// Wieber (2014) with limits above tasks above the posture of Sentis & Khatib (2005) above forces.
// In that limit the costs of the unlimited law and those here have the same minimum: the unlimited
// law's gradient is J_t^T and J_s^T times its multipliers, which is constant where d_xdd is fixed.
// Where no limit is reached nothing is changed, to the bit.
//
// Torque limits can always be kept: any torques are followed by some motion. Where they leave no
// forces within the cones, all cones are widened by the same force, `slack`, as little as possible:
// an exact penalty, so that it is zero where forces within the cones exist.
//
// The quadratic program is one of least distance in coordinates x in which the cost is |x|^2. With
// M = L L^T and d_qdd = L^-T a, the rows J_s L^-T are triangularised by reflections of a, then
// those of the task; what is left is the posture. So there is no equation left, and as few unknowns
// as motors and internal forces.

#include "core/limit_coordinates.hpp"
#include "core/quadratic_program.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

namespace steps {

template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::limit(const SupportLayout<Real, Sizes>& layout,
                                      const TorqueLimits<Real, Sizes>& limits,
                                      const Real (&J_s)[H * V], const Real (&tau)[V],
                                      const Real (&f)[H]) noexcept {
  int row = 0;
  for (int v = 0; v < V && row < Sizes::kMotors; ++v) {
    if (is_passive(layout, v)) continue;
    Real a[N];
    read_column(v, a);
    for (int h = 0; h < Sizes::kHeld; ++h) {
      const Real factor = J_s[h * V + v];
      if (factor == Real(0)) continue;
      for (int n = 0; n < N; ++n) a[n] -= factor * forces_[h * N + n];
    }
    for (int n = 0; n < N; ++n) rows_.A[row * N + n] = a[n];
    rows_.lower[row] = -limits.torque[v] - tau[v];
    rows_.upper[row] = limits.torque[v] - tau[v];
    ++row;
  }
  add_cones(limits, f);
}

/// Rows of cones, and the slack with its penalty c s + c / (2 m g) s^2: c is above any multiplier
/// of the rows that costs of the task give rise to, per N.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::add_cones(const TorqueLimits<Real, Sizes>& limits,
                                          const Real (&f)[H]) noexcept {
  const Real weight = Real(10) * heaviest_;
  slack_ = square_root(weight / kSlackPenalty<Real>);
  for (int c = 0; c < Sizes::kCones; ++c) {
    const ConeRow<Real>& cone = limits.cones[c];
    Real a[N];
    Real room = cone.bound;
    for (int n = 0; n < N; ++n) a[n] = Real(0);
    for (int k = 0; k < cone.count; ++k) {
      const Real factor = cone.coefficients[k];
      room -= factor * f[cone.first + k];
      for (int n = 0; n < N; ++n) a[n] += factor * forces_[(cone.first + k) * N + n];
    }
    a[Sizes::kSlackAt] = -slack_;
    for (int n = 0; n < N; ++n) rows_.A[(Sizes::kMotors + c) * N + n] = a[n];
    rows_.lower[Sizes::kMotors + c] = -kNoLimit<Real>;
    rows_.upper[Sizes::kMotors + c] = room;
  }
  for (int n = 0; n < N; ++n) {
    rows_.lowest[n] = -kNoLimit<Real>;
    rows_.highest[n] = kNoLimit<Real>;
    center_[n] = Real(0);
  }
  rows_.lowest[Sizes::kSlackAt] = Real(0);
  center_[Sizes::kSlackAt] = -weight / slack_;
}

/// tau and f with their changes, and torques within their limits to the last bit.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::solve(const SupportLayout<Real, Sizes>& layout,
                                      const TorqueLimits<Real, Sizes>& limits, Real (&tau)[V],
                                      Real (&f)[H], LimitedTorque<Real, Sizes>& result) noexcept {
  solve_least_distance(center_, rows_, result.program);
  const Real(&x)[N] = result.program.x;
  result.status = result.program.status;
  result.iterations = result.program.iterations;
  result.slack = larger_of(slack_ * x[Sizes::kSlackAt], Real(0));
  for (int t = 0; t < T; ++t) {
    result.lost[t] = Real(0);
    for (int i = 0; i < task_; ++i) result.lost[t] -= W_[(held_ + i) * kCols + kTaskAt + t] * x[i];
  }
  for (int h = 0; h < Sizes::kHeld; ++h) f[h] += dot_of<N>(forces_ + h * N, x);
  int row = 0;
  for (int v = 0; v < V && row < Sizes::kMotors; ++v) {
    if (is_passive(layout, v)) continue;
    tau[v] = clipped(tau[v] + dot_of<N>(rows_.A + row * N, x), limits.torque[v]);
    ++row;
  }
}

/// Whether all that can be limited is within its limits, but for rounding of cones.
template <class Real, class Sizes>
inline bool is_within(const TorqueLimits<Real, Sizes>& limits,
                      const Real (&tau)[Sizes::kVelocities],
                      const Real (&f)[one_or(Sizes::kHeld)]) noexcept {
  bool within = true;
  for (int v = 0; v < Sizes::kVelocities; ++v) within &= size_of(tau[v]) <= limits.torque[v];
  for (int c = 0; c < Sizes::kCones; ++c) {
    const ConeRow<Real>& cone = limits.cones[c];
    Real value = Real(0);
    for (int k = 0; k < cone.count; ++k) value += cone.coefficients[k] * f[cone.first + k];
    within &= value <= cone.bound;
  }
  return within;
}

template <class Real, class Sizes>
inline void report_unlimited(LimitedTorque<Real, Sizes>& result) noexcept {
  result.limited = false;
  result.status = QuadraticStatus::solved;
  result.slack = Real(0);
  result.iterations = 0;
  for (Real& each : result.lost) each = Real(0);
  result.program.warm = false;
}

template <int count, class Real>
inline bool all_finite(const Real* numbers) noexcept {
  bool finite = true;
  for (int i = 0; i < count; ++i) finite &= is_finite(numbers[i]);
  return finite;
}

}  // namespace steps

/// Changes `tau` and `f` of an unlimited law as little as their limits permit. `matrices(M, J_s,
/// J_t)` writes the mass matrix, the Jacobian of the held rows and that of the task rows, and is
/// called only where a limit is exceeded. Torques are within their limits whatever happens; where
/// numbers do not fit the type they are clipped only, and the status is `not_convex`.
template <class Real, class Sizes, class Matrices>
inline void limit_torque(const SupportLayout<Real, Sizes>& layout,
                         const TorqueLimits<Real, Sizes>& limits, const Matrices& matrices,
                         Real (&tau)[Sizes::kVelocities], Real (&f)[one_or(Sizes::kHeld)],
                         LimitedTorque<Real, Sizes>& result) noexcept {
  constexpr int V = Sizes::kVelocities;
  constexpr int H = one_or(Sizes::kHeld);
  if (steps::is_within(limits, tau, f)) {
    steps::report_unlimited(result);
    return;
  }
  steps::LimitProgram<Real, Sizes> program;
  Real M[V * V];
  Real J_s[H * V];
  Real J_t[one_or(Sizes::kTask) * V];
  matrices(M, J_s, J_t);
  Real changed_tau[V];
  Real changed_f[H];
  for (int v = 0; v < V; ++v) changed_tau[v] = tau[v];
  for (int h = 0; h < H; ++h) changed_f[h] = f[h];
  program.set_up(layout, limits, M, J_s, J_t);
  program.limit(layout, limits, J_s, tau, f);
  program.solve(layout, limits, changed_tau, changed_f, result);
  result.limited = true;
  if (!steps::all_finite<V>(changed_tau) || !steps::all_finite<H>(changed_f)) {
    steps::report_unlimited(result);
    result.limited = true;
    result.status = QuadraticStatus::not_convex;
    for (int v = 0; v < V; ++v) tau[v] = steps::clipped(tau[v], limits.torque[v]);
    return;
  }
  for (int v = 0; v < V; ++v) tau[v] = changed_tau[v];
  for (int h = 0; h < H; ++h) f[h] = changed_f[h];
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
