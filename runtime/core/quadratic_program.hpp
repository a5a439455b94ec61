#pragma once
// Strictly convex quadratic programs of fixed size: minimise 1/2 x^T H x + g^T x with lowest <= x
// <= highest and lower <= A x <= upper. C++17, freestanding, no heap, a stated bound on the work.
//
// The dual active-set method of Goldfarb & Idnani (Math. Programming 27, 1983). It starts at the
// minimum without rows and makes one violated row active after the other; rows whose multiplier
// would change its sign leave. With H = L L^T and the active rows' normals n_j as columns of B,
//
//     J = L^-T Q,   J^T B = (R; 0),   R upper triangular,
//
// where Q is orthogonal: Householder reflections add a row, Givens rotations take one out. So
// dependent and nearly dependent rows are told apart by |J_2^T n| against |J^T n|, which has no
// unit. Any active set whose multipliers have the right sign is a start: the one of the last cycle
// saves what it has in common with this one's.
//
// Work: at most `most_iterations` steps, 4 (N + M) unless told otherwise, of which each adds or
// drops a row, and at most as many again and N that drop a row when x is found anew from the
// factors. Each takes at most `flops_of_iteration(N, M)` operations; what comes before, the factor
// of H and the rows of a warm start, takes at most 8 N^3. (Arnstrom, Bemporad & Axehill 2022
// certify tighter bounds of one parametric program offline.)
//
// Conflicts: when a violated row depends on active rows that cannot leave, no x obeys all of them,
// and the violation is the least that the active rows permit. That row is set aside and the rest is
// solved. So x is always the minimum over rows that do not conflict.

#include "core/enter_violated_rows.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Minimises 1/2 x^T H x + g^T x over `rows`; H row-major, symmetric, positive definite, of which
/// the lower triangle is read. The answer is unique, so that another start changes it by rounding
/// only; the same start gives the same bits.
template <class Real, int N, int M>
inline void solve_quadratic_program(const Real (&H)[N * N], const Real (&g)[N],
                                    const QuadraticRows<Real, N, M>& rows,
                                    QuadraticSolution<Real, N, M>& solution,
                                    int iterations = most_iterations(N, M)) noexcept {
  steps::DualActiveSet<Real, N, M> method(rows, solution, iterations);
  if (method.start(H, g)) {
    method.solve();
    return;
  }
  solution.iterations = 0;
  steps::give_up(solution);
}

/// The x nearest to `center` over `rows`: minimises |x - center|^2 / 2.
template <class Real, int N, int M>
inline void solve_least_distance(const Real (&center)[N], const QuadraticRows<Real, N, M>& rows,
                                 QuadraticSolution<Real, N, M>& solution,
                                 int iterations = most_iterations(N, M)) noexcept {
  steps::DualActiveSet<Real, N, M> method(rows, solution, iterations);
  method.start_at(center);
  method.solve();
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
