#pragma once
// What a quadratic program of fixed size asks and answers, see quadratic_program.hpp.

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

enum class QuadraticStatus {
  solved,       ///< all rows hold
  conflicting,  ///< rows that conflict with others were set aside, see `sides`
  limit,        ///< the iterations were used up: x is the minimum over the active rows alone
  not_convex,   ///< H is not positive definite, or numbers do not fit or are none: x is zero
};

/// Which side of a row is active.
enum class RowSide : signed char { lower = -1, none = 0, upper = 1, set_aside = 2 };

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

/// The default bound on iterations.
constexpr int most_iterations(int n, int m) noexcept {
  return 4 * (n + m);
}

/// The most operations in one iteration: slacks of all rows, |A| |x| of those that are missed, J^T
/// n, a step, the rotations that drop a row, which take more than the reflection that adds one, and
/// x from the factors.
constexpr long flops_of_iteration(int n, int m) noexcept {
  return 4L * m * n + 20L * n * n + 16L * (n + m);
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
