#pragma once
// Strictly convex quadratic programs of fixed size: minimise 1/2 x^T H x + g^T x with lowest <= x
// <= highest and lower <= A x <= upper. C++17, freestanding, no heap, a stated bound on the work.
//
// emitted/quadratic_program.h has the method: it finds the point nearest to a centre. With H = L
// L^T and the active rows' normals n_j as columns of B it keeps
//
//     J = L^-T Q,   J^T B = (R; 0),   R upper triangular,
//
// from J = L^-T and the minimum without rows on. Dependent and nearly dependent rows are told apart
// by |J_2^T n| against |J^T n|, which has no unit. Any active set whose multipliers have the right
// sign is a start: the one of the last cycle saves what it has in common with this one's.
//
// Work: at most `most_iterations` steps, 4 (N + M) unless told otherwise, of which each adds or
// drops a row, and at most as many again and N that drop a row when x is found anew from the
// factors. Each takes at most `flops_of_iteration(N, M)` operations, with N in eights; what comes
// before, the factor of H and the rows of a warm start, takes at most 8 N^3. (Arnstrom, Bemporad &
// Axehill 2022 certify tighter bounds of one parametric program offline.)
//
// Conflicts: when a violated row depends on active rows that cannot leave, no x obeys all of them,
// and the violation is the least that the active rows permit. That row is set aside and the rest is
// solved. So x is always the minimum over rows that do not conflict.

#include "core/emitted_limits.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Rows lowest <= x <= highest and lower <= A x <= upper, A row-major. Infinite where there is no
/// limit; equal for an equation. Row i < N is a bound of x[i], row N + i is row i of A.
template <class Real, int N, int M>
struct QuadraticRows {
  Real lowest[N], highest[N];
  Real A[M * N];
  Real lower[M], upper[M];
};

/// H x + g = sum of multipliers[i] times row i: positive at the lower side, negative at the upper.
template <class Real, int N, int M>
struct QuadraticSolution {
  Real x[N];
  Real multipliers[N + M];
  RowSide
      sides[N + M];  ///< on entry, if `warm`: the rows to start with, those of the last solution
  bool warm;         ///< on entry: whether `sides` holds a start; true on return
  QuadraticStatus status;
  int conflicting_row;  ///< the first that was set aside, or -1
  int iterations;
};

namespace steps {

/// The program with unknowns in eights: those beyond N are free and stay at 0.
template <class Real, int N, int M>
class PaddedProgram {
  using Method = EmittedLimits<Real, ProgramSizes<N, M>>;
  static constexpr int kUnknowns = Method::TL_UNKNOWNS;

 public:
  PaddedProgram(const QuadraticRows<Real, N, M>& rows, int most) noexcept {
    for (int i = 0; i < kUnknowns; ++i) {
      rows_.lowest[i] = i < N ? rows.lowest[i] : -Method::TL_NO_LIMIT;
      rows_.highest[i] = i < N ? rows.highest[i] : Method::TL_NO_LIMIT;
      set_.center[i] = Real(0);
      for (int row = 0; row < M; ++row) {
        rows_.A[row * kUnknowns + i] = i < N ? rows.A[row * N + i] : Real(0);
      }
    }
    for (int row = 0; row < M; ++row) {
      rows_.lower[row] = rows.lower[row];
      rows_.upper[row] = rows.upper[row];
    }
    Method::tl_start_at_center(&set_, &rows_, most);
  }

  void set_center(const Real (&center)[N]) noexcept {
    for (int i = 0; i < N; ++i) set_.center[i] = set_.x[i] = center[i];
  }

  /// J = L^-T and the minimum without rows. False where H is not positive definite.
  bool set_cost(const Real (&H)[N * N], const Real (&g)[N]) noexcept {
    Real L[N * N];
    for (int j = 0; j < N; ++j) {
      for (int i = j; i < N; ++i) {
        Real entry = H[i * N + j];
        for (int k = 0; k < j; ++k) entry -= L[i * N + k] * L[j * N + k];
        if (i == j) {
          if (!(entry > Format<Real>::kEpsilon * H[j * N + j]) || !Method::tl_is_finite(entry)) {
            return false;
          }
          L[j * N + j] = square_root(entry);
        } else {
          L[i * N + j] = entry / L[j * N + j];
        }
      }
    }
    // Row k of Jt is L^-1 e_k: zero before entry k.
    for (int i = 0; i < N; ++i) {
      for (int k = 0; k <= i; ++k) {
        Real entry = i == k ? Real(1) : Real(0);
        for (int j = k; j < i; ++j) entry -= L[i * N + j] * set_.Jt[j * kUnknowns + k];
        set_.Jt[i * kUnknowns + k] = entry / L[i * N + i];
      }
    }
    Real padded[kUnknowns];
    for (int i = 0; i < kUnknowns; ++i) padded[i] = i < N ? g[i] : Real(0);
    Real center[N];
    for (Real& each : center) each = Real(0);
    for (int k = 0; k < N; ++k) {
      const Real along = Method::tl_dot(&set_.Jt[k * kUnknowns], padded);
      for (int i = 0; i < N; ++i) center[i] -= along * set_.Jt[k * kUnknowns + i];
    }
    set_center(center);
    return true;
  }

  void solve(QuadraticSolution<Real, N, M>& solution) noexcept {
    for (int row = 0; row < Method::TL_ALL_ROWS; ++row) set_.sides[row] = Method::TL_FREE;
    for (int row = 0; row < N + M; ++row) {
      set_.sides[place(row)] = static_cast<int>(solution.sides[row]);
    }
    Method::tl_solve_rows(&set_, &rows_, solution.warm);
    solution.warm = true;
    solution.status = static_cast<QuadraticStatus>(set_.status);
    solution.iterations = set_.iterations;
    solution.conflicting_row = -1;
    for (int i = 0; i < N; ++i) solution.x[i] = set_.x[i];
    for (int row = N + M - 1; row >= 0; --row) {
      solution.sides[row] = static_cast<RowSide>(set_.sides[place(row)]);
      solution.multipliers[row] = Real(0);
      if (solution.sides[row] == RowSide::set_aside) solution.conflicting_row = row;
    }
    if (solution.status == QuadraticStatus::not_convex) return;
    for (int j = 0; j < set_.count; ++j) {
      const int active = set_.active[j];
      solution.multipliers[active < N ? active : active - kUnknowns + N] =
          Method::tl_sign_of(set_.sides[active]) * set_.u[j];
    }
  }

 private:
  static constexpr int place(int row) noexcept { return row < N ? row : row - N + kUnknowns; }

  typename Method::TlRowsOfLimits rows_;
  typename Method::TlActiveSet set_;
};

}  // namespace steps

/// Minimises 1/2 x^T H x + g^T x over `rows`; H row-major, symmetric, positive definite, of which
/// the lower triangle is read. The answer is unique, so that another start changes it by rounding
/// only; the same start gives the same bits.
template <class Real, int N, int M>
inline void solve_quadratic_program(const Real (&H)[N * N], const Real (&g)[N],
                                    const QuadraticRows<Real, N, M>& rows,
                                    QuadraticSolution<Real, N, M>& solution,
                                    int iterations = most_iterations(N, M)) noexcept {
  steps::PaddedProgram<Real, N, M> program(rows, iterations);
  if (program.set_cost(H, g)) {
    program.solve(solution);
    return;
  }
  for (Real& each : solution.x) each = Real(0);
  for (Real& each : solution.multipliers) each = Real(0);
  for (RowSide& each : solution.sides) each = RowSide::none;
  solution.status = QuadraticStatus::not_convex;
  solution.conflicting_row = -1;
  solution.iterations = 0;
}

/// The x nearest to `center` over `rows`: minimises |x - center|^2 / 2.
template <class Real, int N, int M>
inline void solve_least_distance(const Real (&center)[N], const QuadraticRows<Real, N, M>& rows,
                                 QuadraticSolution<Real, N, M>& solution,
                                 int iterations = most_iterations(N, M)) noexcept {
  steps::PaddedProgram<Real, N, M> program(rows, iterations);
  program.set_center(center);
  program.solve(solution);
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
