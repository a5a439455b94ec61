#pragma once
// How quadratic_program.hpp keeps J and R as rows become active or leave, and x and the multipliers
// by them.

#include "core/dual_active_set.hpp"
#include "core/square_root.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core::steps {

template <class Real, int N, int M>
bool DualActiveSet<Real, N, M>::start(const Real (&H)[N * N], const Real (&g)[N]) noexcept {
  Real L[N * N];
  for (int j = 0; j < N; ++j) {
    for (int i = j; i < N; ++i) {
      Real entry = H[i * N + j];
      for (int k = 0; k < j; ++k) entry -= L[i * N + k] * L[j * N + k];
      if (i == j) {
        if (!(entry > Format<Real>::kEpsilon * H[j * N + j]) || !is_finite(entry)) return false;
        L[j * N + j] = square_root(entry);
      } else {
        L[i * N + j] = entry / L[j * N + j];
      }
    }
  }
  // Row k of Jt is L^-1 e_k: zero before entry k.
  for (int i = 0; i < N * N; ++i) Jt_[i] = Real(0);
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k <= i; ++k) {
      Real entry = i == k ? Real(1) : Real(0);
      for (int j = k; j < i; ++j) entry -= L[i * N + j] * Jt_[j * N + k];
      Jt_[i * N + k] = entry / L[i * N + i];
    }
  }
  for (int i = 0; i < N; ++i) x0_[i] = Real(0);
  for (int k = 0; k < N; ++k) {
    const Real along = dot_of<N>(Jt_ + k * N, g);
    for (int i = 0; i < N; ++i) x0_[i] -= along * Jt_[k * N + i];
  }
  begin();
  return true;
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::start_at(const Real (&center)[N]) noexcept {
  for (int i = 0; i < N * N; ++i) Jt_[i] = Real(0);
  for (int i = 0; i < N; ++i) {
    Jt_[i * N + i] = Real(1);
    x0_[i] = center[i];
  }
  begin();
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::begin() noexcept {
  for (int i = 0; i < N; ++i) solution_.x[i] = x0_[i];
  solution_.status = QuadraticStatus::solved;
  solution_.conflicting_row = -1;
  solution_.iterations = 0;
}

/// d = J^T n of the row's normal.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::project_normal(int row, RowSide side) noexcept {
  for (int k = 0; k < N; ++k) {
    const Real along = row < N ? Jt_[k * N + row] : dot_of<N>(Jt_ + k * N, rows_.A + (row - N) * N);
    d_[k] = sign(side) * along;
  }
}

/// |J_2^T n|: how far the normal is from those of active rows, in the metric of H^-1.
template <class Real, int N, int M>
Real DualActiveSet<Real, N, M>::free_part() const noexcept {
  Real square = Real(0);
  for (int k = count(); k < N; ++k) square += d_[k] * d_[k];
  return square_root(square);
}

template <class Real, int N, int M>
bool DualActiveSet<Real, N, M>::depends(Real free) const noexcept {
  if (count_ == N) return true;
  return !(free > kDependent<Real> * square_root(dot_of<N>(d_, d_)));
}

/// r = R^-1 d_1: how the multipliers of active rows change with that of the new one.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::solve_for_r() noexcept {
  for (int i = 0; i < count(); ++i) r_[i] = d_[i];
  for (int j = count() - 1; j >= 0; --j) {
    r_[j] /= R_[j * N + j];
    for (int i = 0; i < j; ++i) r_[i] -= R_[i * N + j] * r_[j];
  }
}

/// Reflects J_2 so that J_2^T n is along its first column.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::add(int row, RowSide side, Real free, Real multiplier) noexcept {
  const int at = count_ < N ? count_ : N - 1;
  const Real first = d_[at];
  const Real to = first > Real(0) ? -free : free;
  Real v[N];
  Real sum[N];
  for (int k = 0; k < N; ++k) {
    v[k] = d_[k];
    sum[k] = Real(0);
  }
  v[at] -= to;
  const Real scale = Real(1) / (free * (free + size_of(first)));
  add_rows(v, Jt_, at, N, sum);
  for (int k = at; k < N; ++k) {
    const Real along = scale * v[k];
    for (int i = 0; i < N; ++i) Jt_[k * N + i] -= along * sum[i];
  }
  for (int k = 0; k < at; ++k) R_[k * N + at] = d_[k];
  R_[at * N + at] = to;
  u_[at] = multiplier;
  active_[at] = row;
  solution_.sides[row] = side;
  ++count_;
}

/// Takes an active row out; rotates J, R and d.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::drop(int index) noexcept {
  solution_.sides[active_[index]] = RowSide::none;
  for (bool& each : ignored_) each = false;
  --count_;
  const int left = count_ < N - 1 ? count_ : N - 1;
  const int first = index < 0 ? 0 : index;
  for (int j = first; j < left; ++j) {
    active_[j] = active_[j + 1];
    u_[j] = u_[j + 1];
    for (int i = 0; i <= j + 1 && i < N; ++i) R_[i * N + j] = R_[i * N + j + 1];
  }
  for (int k = first; k < left; ++k) {
    Real* const upper_row = R_ + k * N;
    Real* const lower_row = upper_row + N;
    const Real length = square_root(upper_row[k] * upper_row[k] + lower_row[k] * lower_row[k]);
    const Real c = upper_row[k] / length;
    const Real s = lower_row[k] / length;
    const auto turn = [c, s](Real& a, Real& b) noexcept {
      const Real turned = c * a + s * b;
      b = c * b - s * a;
      a = turned;
    };
    for (int j = k; j < left; ++j) turn(upper_row[j], lower_row[j]);
    for (int i = 0; i < N; ++i) turn(Jt_[k * N + i], Jt_[(k + 1) * N + i]);
    turn(d_[k], d_[k + 1]);
  }
}

/// Moves x along the active rows until they hold, and changes their multipliers accordingly: R^T y
/// = b - B^T x, x += J_1 y, u += R^-1 y.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::correct() noexcept {
  for (int j = 0; j < count(); ++j) {
    const int row = active_[j];
    const bool is_upper = solution_.sides[row] == RowSide::upper;
    const Real value = row < N ? solution_.x[row] : dot_of<N>(rows_.A + (row - N) * N, solution_.x);
    Real y = is_upper ? value - upper(row) : lower(row) - value;
    for (int i = 0; i < j; ++i) y -= R_[i * N + j] * r_[i];
    r_[j] = y / R_[j * N + j];
  }
  add_rows(r_, Jt_, 0, count(), solution_.x);
  for (int j = count() - 1; j >= 0; --j) {
    r_[j] /= R_[j * N + j];
    for (int i = 0; i < j; ++i) r_[i] -= R_[i * N + j] * r_[j];
    u_[j] += r_[j];
  }
}

/// x and the multipliers of the active rows from the factors.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::find_multipliers() noexcept {
  for (int i = 0; i < N; ++i) solution_.x[i] = x0_[i];
  for (int j = 0; j < count(); ++j) u_[j] = Real(0);
  correct();
}

/// The minimum over the active rows, without those whose multiplier has the wrong sign.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::settle() noexcept {
  for (;;) {
    find_multipliers();
    int worst = -1;
    for (int j = 0; j < count(); ++j) {
      if (!may_leave(j) || !(u_[j] < Real(0))) continue;
      if (worst < 0 || u_[j] < u_[worst]) worst = j;
    }
    if (worst < 0) return;
    drop(worst);
    ++solution_.iterations;
  }
}

}  // namespace treeline::core::steps

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
