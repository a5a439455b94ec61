#pragma once
// The headers of runtime/emitted for eigenvalues, small systems and damped control, as members of a
// class of any number type and any sizes. C++17, freestanding.

#include <stdbool.h>
#include <stdint.h>

#include "core/sin_cos.hpp"
#include "core/square_root.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// How many sweeps bring n x n matrices to rounding. Random matrices take 1.6 n; found by trying
/// graded, clustered, repeated and split ones, the worst of which takes up to 3 n, in float 2.5 n.
template <class Real>
constexpr int ql_sweeps(int n) noexcept {
  return n <= 1 ? 0 : n == 2 ? 2 : sizeof(Real) >= sizeof(double) ? 3 * n + 2 : 5 * n / 2;
}

/// How many numbers describe the rotations of so many sweeps; arrays have at least one entry.
constexpr int count_rotations(int n, int sweeps) noexcept {
  return n > 1 ? 2 * (n - 1) * sweeps : 1;
}

/// Thresholds of the method.
template <class Real>
struct DampedNumbers {
  /// Squares below this have lost digits; no entry of this root matters beside 1.
  static constexpr Real kLostSquare = Real(sizeof(Real) >= sizeof(double) ? 1e-280 : 1e-30);
  /// Nothing beside 1.
  static constexpr Real kNegligible = Real(4 * Format<Real>::kEpsilon);
  /// Rounding beside 1 in an eigenvalue.
  static constexpr Real kUnresolved = Real(64 * Format<Real>::kEpsilon);
};

#define TL_INLINE static inline

/// Everything of runtime/emitted/damped_solve.h, for matrices of N rows and robots with
/// `velocities`.
template <class Number, int N, int velocities = 1>
struct EmittedDamped {
  using real = Number;
  using Numbers = DampedNumbers<real>;
  static constexpr real TL_ZERO = real(0), TL_HALF = real(0.5), TL_ONE = real(1), TL_TWO = real(2);
  static constexpr int32_t TL_TASK_ROWS = N, TL_VELOCITIES = velocities,
                           TL_SWEEPS = ql_sweeps<real>(N),
                           TL_ROTATIONS = count_rotations(N, TL_SWEEPS);
  static constexpr real TL_LOST_SQUARE = Numbers::kLostSquare, TL_NEGLIGIBLE = Numbers::kNegligible,
                        TL_UNRESOLVED = Numbers::kUnresolved;

  static real tl_square_root(real x) { return square_root(x); }
  static real tl_root(real x) { return square_root(x > TL_ZERO ? x : TL_ZERO); }

#include "emitted/damped_solve.h"
};

#undef TL_INLINE

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
