#pragma once
// Coordinates of limited_torque.hpp in which the cost is a sum of squares: M = L L^T, held rows and
// tasks triangular.

#include "core/limit_program.hpp"
#include "core/square_root.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core::steps {

/// `entries` less the sum over k of the numbers `factors`, `stride` apart, times the rows of
/// `columns`: eight columns at once, which stay in registers.
template <class Real>
inline void subtract_rows(const Real* factors, const Real* columns, int stride, int count,
                          Real* entries) noexcept {
  Lanes<Real, 8> left, row;
  load_lanes(entries, left);
  for (int k = 0; k < count; ++k) {
    load_lanes(columns + k * stride, row);
    subtract_lanes(factors[k * stride] * row, left);
  }
  store_lanes(left, entries);
}

/// L of M = L L^T, transposed, as the last columns of W.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::factor_mass(const Real (&M)[V * V]) noexcept {
  heaviest_ = Real(0);
  for (int i = 0; i < V; ++i) {
    Real* const row = W_ + i * kCols;
    const int diagonal = kMassAt + i;
    heaviest_ = larger_of(heaviest_, M[i * V + i]);
    for (int j = 0; j < kCols; ++j) row[j] = Real(0);
    for (int j = i; j < V; ++j) row[kMassAt + j] = M[i * V + j];
    const int first = diagonal / 8 * 8;
    for (int j = first; j < kCols; j += 8) {
      subtract_rows(W_ + diagonal, W_ + j, kCols, i, row + j);
    }
    const Real inverse = Real(1) / square_root(row[diagonal]);
    for (int j = first; j < kCols; ++j) row[j] = j < diagonal ? Real(0) : row[j] * inverse;
  }
}

/// L^-1 J^T of held rows and tasks.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::whiten(const Real (&J_s)[H * V],
                                       const Real (&J_t)[T * V]) noexcept {
  constexpr int kEnd = in_eights(kMassAt);
  for (int k = 0; k < V; ++k) {
    Real row[kEnd];
    for (Real& each : row) each = Real(0);
    for (int h = 0; h < Sizes::kHeld; ++h) row[kHeldAt + h] = J_s[h * V + k];
    for (int t = 0; t < Sizes::kTask; ++t) row[kTaskAt + t] = J_t[t * V + k];
    for (int j = kHeldAt / 8 * 8; j < kEnd; j += 8) {
      subtract_rows(W_ + kMassAt + k, W_ + j, kCols, k, row + j);
    }
    const Real inverse = Real(1) / W_[k * kCols + kMassAt + k];
    for (int j = kHeldAt; j < kMassAt; ++j) W_[k * kCols + j] = row[j] * inverse;
  }
}

/// Passive entries of M d_qdd that no force of a support balances vanish.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::relate_passive(const SupportLayout<Real, Sizes>& layout) noexcept {
  for (int k = 0; k < V; ++k) {
    Real* const row = W_ + k * kCols;
    for (int j = 0; j < P; ++j) {
      row[j] = Real(0);
      if (j >= Sizes::kPassive || !basis_.depends[j]) continue;
      row[j] = row[kMassAt + layout.passive[j]];
      for (int r = 0; r < basis_.rank; ++r) {
        row[j] -= basis_.relations[j * P + r] * row[kMassAt + layout.passive[basis_.carried[r]]];
      }
    }
  }
}

/// Reflects a so that equations concern its first entries only, tasks the next.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::reduce(const Real (&weights)[T]) noexcept {
  for (Real& each : squares_) each = Real(0);
  for (int k = 0; k < V; ++k) {
    for (int j = 0; j < kMassAt; ++j) squares_[j] += W_[k * kCols + j] * W_[k * kCols + j];
  }
  held_ = 0;
  task_ = 0;
  for (int j = 0; j < kMassAt; ++j) {
    const int at = held_ + task_;
    const Real least = kRankTolerance<Real> * square_root(squares_[j]);
    if (at >= V || !reflect<V, kCols>(W_, at, j, least)) continue;
    ++(j < kTaskAt ? held_ : task_);
  }
  weigh_task(weights);
}

/// Unknowns of the task such that their squares are its cost: with K K^T = 1 + k^2 R D R^T, rows of
/// the task become K^-1 times what they are.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::weigh_task(const Real (&weights)[T]) noexcept {
  Real K[T * T];
  Real scales[T];
  for (int t = 0; t < T; ++t) {
    const Real square = squares_[kTaskAt + t];
    scales[t] =
        square > Real(0) ? weights[t] * kHierarchy<Real> * kHierarchy<Real> / square : Real(0);
  }
  for (int i = 0; i < task_; ++i) {
    Real* const row = W_ + (held_ + i) * kCols;
    for (int j = 0; j <= i; ++j) {
      const Real* const other = W_ + (held_ + j) * kCols;
      Real entry = i == j ? Real(1) : Real(0);
      for (int t = 0; t < T; ++t) entry += row[kTaskAt + t] * scales[t] * other[kTaskAt + t];
      K[i * T + j] = entry;
    }
  }
  for (int j = 0; j < task_; ++j) {
    K[j * T + j] = square_root(K[j * T + j]);
    for (int i = j + 1; i < task_; ++i) K[i * T + j] /= K[j * T + j];
    for (int i = j + 1; i < task_; ++i) {
      for (int k = j + 1; k <= i; ++k) K[i * T + k] -= K[i * T + j] * K[k * T + j];
    }
  }
  for (int i = 0; i < task_; ++i) {
    Real* const place = W_ + (held_ + i) * kCols + kTaskAt;
    Real row[T + V];
    for (int j = 0; j < T + V; ++j) row[j] = place[j];
    for (int m = 0; m < i; ++m) {
      const Real* const before = W_ + (held_ + m) * kCols + kTaskAt;
      const Real factor = K[i * T + m];
      for (int j = 0; j < T + V; ++j) row[j] -= factor * before[j];
    }
    const Real inverse = Real(1) / K[i * T + i];
    for (int j = 0; j < T + V; ++j) place[j] = row[j] * inverse;
  }
}

template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::set_up(const SupportLayout<Real, Sizes>& layout,
                                       const TorqueLimits<Real, Sizes>& limits,
                                       const Real (&M)[V * V], const Real (&J_s)[H * V],
                                       const Real (&J_t)[T * V]) noexcept {
  basis_.rank = 0;
  for (bool& each : basis_.depends) each = true;
  if (Sizes::kHeld > 0) {
    find_force_basis<V>(J_s, layout.passive, Sizes::kPassive, layout.force_weights, basis_);
  }
  factor_mass(M);
  whiten(J_s, J_t);
  relate_passive(layout);
  reduce(limits.task_weights);
  form_forces(layout);
}

/// d_f by unknowns: those that balance a motion, then those that carry nothing, then the slack.
/// Freedoms beyond those of ordinary states are left alone.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::form_forces(const SupportLayout<Real, Sizes>& layout) noexcept {
  const int moving = V - held_;
  const Real size = kHierarchy<Real> * square_root(heaviest_);
  Real carried[P * N];
  for (int r = 0; r < basis_.rank; ++r) {
    read_column(layout.passive[basis_.carried[r]], carried + r * N);
  }
  for (int h = 0; h < H; ++h) {
    Real* const row = forces_ + h * N;
    for (int n = 0; n < N; ++n) row[n] = Real(0);
    for (int r = 0; r < basis_.rank; ++r) {
      const Real factor = basis_.carry[h * P + r];
      for (int n = 0; n < N; ++n) row[n] += factor * carried[r * N + n];
    }
    for (int k = 0; k < H - basis_.rank && Sizes::kHeld > 0 && moving + k < Sizes::kFreedoms; ++k) {
      row[moving + k] = size * basis_.free[h * H + k];
    }
  }
}

/// M d_qdd at a velocity, by unknowns.
template <class Real, class Sizes>
void LimitProgram<Real, Sizes>::read_column(int velocity, Real* column) const noexcept {
  const int moving = V - held_ < Sizes::kFreedoms ? V - held_ : Sizes::kFreedoms;
  const Real* const first = W_ + held_ * kCols + kMassAt + velocity;
  for (int n = 0; n < N; ++n) column[n] = Real(0);
  for (int n = 0; n < moving; ++n) column[n] = first[n * kCols];
}

}  // namespace treeline::core::steps

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
