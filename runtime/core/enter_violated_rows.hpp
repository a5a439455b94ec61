#pragma once
// The course of the dual active-set method of quadratic_program.hpp: the row that is missed most
// enters, those whose multiplier would change its sign leave.

#include "core/active_row_factors.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core::steps {

/// Makes the rows of the start active that depend on no others, and drops those of the wrong sign.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::add_start() noexcept {
  RowSide first[kRows];
  for (int row = 0; row < kRows; ++row) {
    const bool starts = solution_.warm && solution_.sides[row] != RowSide::set_aside;
    first[row] = is_equation(row) ? RowSide::lower : starts ? solution_.sides[row] : RowSide::none;
    solution_.sides[row] = RowSide::none;
  }
  for (int pass = 0; pass < 2; ++pass) {
    const bool equations = pass == 0;
    for (int row = 0; row < kRows && count_ < N; ++row) {
      const Real bound = first[row] == RowSide::upper ? upper(row) : lower(row);
      if (first[row] == RowSide::none || is_equation(row) != equations || !is_finite(bound)) {
        continue;
      }
      project_normal(row, first[row]);
      const Real free = free_part();
      if (!depends(free)) add(row, first[row], free, Real(0));
    }
  }
  if (count_ > 0) settle();
}

/// Keeps the row if it is missed by more than those before, measured along its normal.
/// `terms_of()` is the sum of the sizes of its terms.
template <class Real, int N, int M>
template <class Terms>
void DualActiveSet<Real, N, M>::consider(int row, Real value, Real inverse_square,
                                         const Terms& terms_of, Violation& worst,
                                         Real& worst_square) const noexcept {
  const Real below = lower(row) - value;
  const Real above = value - upper(row);
  const bool is_below = below > above;
  const Real amount = is_below ? below : above;
  if (!(amount > Real(0)) || ignored_[row]) return;
  const Real square = amount * amount * inverse_square;
  if (!(square > worst_square)) return;
  const Real terms = terms_of() + size_of(is_below ? lower(row) : upper(row));
  if (!(amount > kRowTolerance<Real> * terms)) return;
  worst_square = square;
  worst = {row, is_below ? RowSide::lower : RowSide::upper, amount, kContradiction<Real> * terms};
}

template <class Real, int N, int M>
typename DualActiveSet<Real, N, M>::Violation DualActiveSet<Real, N, M>::most_violated()
    const noexcept {
  Violation worst;
  Real worst_square = Real(0);
  const Real(&x)[N] = solution_.x;
  for (int i = 0; i < N; ++i) {
    if (solution_.sides[i] != RowSide::none) continue;
    consider(
        i, x[i], Real(1), [&]() noexcept { return size_of(x[i]); }, worst, worst_square);
  }
  for (int i = 0; i < M; ++i) {
    if (solution_.sides[N + i] != RowSide::none) continue;
    const Real* const a = rows_.A + i * N;
    consider(
        N + i, dot_of<N>(a, x), inverse_squares_[i],
        [&]() noexcept { return dot_of_sizes<N>(a, x); }, worst, worst_square);
  }
  return worst;
}

/// The active row whose multiplier vanishes first, and at which step; -1 where none does.
template <class Real, int N, int M>
int DualActiveSet<Real, N, M>::first_to_leave(Real& step) const noexcept {
  int first = -1;
  for (int j = 0; j < count(); ++j) {
    if (!may_leave(j) || !(r_[j] > Real(0))) continue;
    const Real own = u_[j] / r_[j];
    if (first >= 0 && !(own < step)) continue;
    first = j;
    step = own;
  }
  return first;
}

/// One step towards making the row active. False when it is active, or set aside.
template <class Real, int N, int M>
bool DualActiveSet<Real, N, M>::take_step(const Violation& violation, Real& missing,
                                          Real& multiplier) noexcept {
  const Real free = free_part();
  const bool dependent = depends(free);
  solve_for_r();
  Real step = Real(0);
  const int leaving = first_to_leave(step);
  if (dependent && leaving < 0) {
    if (violation.amount > violation.tolerance) {
      set_aside(violation);
    } else {
      ignored_[violation.row] = true;
      settle();
    }
    return false;
  }
  const Real full = dependent ? Real(0) : missing / (free * free);
  const bool partial = dependent || (leaving >= 0 && step < full);
  if (!partial) step = full;
  if (!dependent) {
    Real along[N];
    for (int k = 0; k < N; ++k) along[k] = step * d_[k];
    add_rows(along, Jt_, count(), N, solution_.x);
  }
  for (int j = 0; j < count(); ++j) u_[j] -= step * r_[j];
  multiplier += step;
  if (!partial) {
    add(violation.row, violation.side, free, multiplier);
    return false;
  }
  if (!dependent) missing -= step * free * free;
  drop(leaving);
  return true;
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::enter(const Violation& violation) noexcept {
  project_normal(violation.row, violation.side);
  Real missing = violation.amount;
  Real multiplier = Real(0);
  do {
    if (left_ == 0) {
      settle();
      return;
    }
    --left_;
    ++solution_.iterations;
  } while (take_step(violation, missing, multiplier));
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::set_aside(const Violation& violation) noexcept {
  solution_.sides[violation.row] = RowSide::set_aside;
  if (solution_.conflicting_row < 0) solution_.conflicting_row = violation.row;
  solution_.status = QuadraticStatus::conflicting;
  settle();
}

/// Rows are taken in until none is missed by more than rounding, also after x was computed again
/// from the factors.
template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::solve() noexcept {
  add_start();
  bool settled = true;
  for (;;) {
    const Violation violation = most_violated();
    if (violation.row >= 0) {
      if (left_ == 0) {
        solution_.status = QuadraticStatus::limit;
        break;
      }
      enter(violation);
      settled = false;
    } else if (!settled) {
      settle();
      settled = true;
    } else {
      break;
    }
  }
  finish();
}

/// Whether x is on a side of both bounds: of NaN it is on none, which nothing else notices.
template <class Real, int N, int M>
bool DualActiveSet<Real, N, M>::is_comparable(int row) const noexcept {
  const Real(&x)[N] = solution_.x;
  const Real value = row < N ? x[row] : dot_of<N>(rows_.A + (row - N) * N, x);
  const bool below = value < lower(row) || value >= lower(row);
  return below && (value > upper(row) || value <= upper(row));
}

template <class Real, int N, int M>
void DualActiveSet<Real, N, M>::finish() noexcept {
  if (solution_.status == QuadraticStatus::limit) settle();
  correct();
  solution_.warm = true;
  for (int row = 0; row < kRows; ++row) solution_.multipliers[row] = Real(0);
  bool finite = true;
  for (int j = 0; j < count(); ++j) {
    const int row = active_[j];
    solution_.multipliers[row] = sign(solution_.sides[row]) * u_[j];
    finite = finite && is_finite(u_[j]);
  }
  for (int i = 0; i < N; ++i) finite = finite && is_finite(solution_.x[i]);
  for (int row = 0; row < kRows; ++row) finite = finite && is_comparable(row);
  if (!finite) give_up(solution_);
}

}  // namespace treeline::core::steps

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
