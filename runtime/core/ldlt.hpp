#pragma once
// Small symmetric positive definite systems: A = L D L^T with L unit lower triangular. C++17,
// freestanding, fixed size, no square root, no branch on data.

#include "core/emitted_damped.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Factors the row-major symmetric `A` in place: L below the diagonal, D on it; what lies above the
/// diagonal is neither read nor written. Returns whether every pivot is positive (false for NaN
/// too); when not, the factors are meaningless.
template <int N, int NN, class Real>
inline bool ldlt_factor(Real (&A)[NN]) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  return EmittedDamped<Real, N>::tl_ldlt_factor(A);
}

/// Solves A x = b in place (`x` holds b on entry) with the factors of `ldlt_factor`.
template <int N, int NN, class Real>
inline void ldlt_solve(const Real (&factors)[NN], Real (&x)[N]) noexcept {
  static_assert(NN == N * N, "the factors hold N x N numbers");
  EmittedDamped<Real, N>::tl_ldlt_solve(factors, x);
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
