#pragma once
// Eigenvalues and eigenvectors of small symmetric matrices by runtime/emitted/symmetric_eigen.h.
// C++17, freestanding, fixed size, same time for every matrix.

#include "core/emitted_damped.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// A = sum_i values[i] v_i v_i^T.
template <int N, class Real>
struct SymmetricEigen {
  Real values[N];       ///< descending
  Real vectors[N * N];  ///< row i: the unit vector v_i
};

namespace steps {

/// Square root; 0 for what rounding has made negative.
template <class Real>
inline Real root(Real x) noexcept {
  return square_root(x > Real(0) ? x : Real(0));
}

/// Exchanges `a` and `b` or leaves them, in the same time.
template <class Real>
constexpr void exchange_if(bool condition, Real& a, Real& b) noexcept {
  const Real kept = a;
  a = condition ? b : a;
  b = condition ? kept : b;
}

/// Eigenvalues and unit vectors as rows, in no order, of `A`, whose lower triangle is read.
template <int N, class Real>
inline void decompose(const Real (&A)[N * N], Real (&values)[N], Real (&vectors)[N * N]) noexcept {
  using Method = EmittedDamped<Real, N>;
  typename Method::TlTurns turns;
  for (int j = 0; j < N; ++j) {
    for (int i = j; i < N; ++i) {  // by columns: of rows compilers make calls of memcpy
      turns.reflections[i * N + j] = A[i * N + j];
    }
  }
  for (int i = 0; i < N * N; ++i) {
    vectors[i] = i % (N + 1) == 0 ? Real(1) : Real(0);
  }
  Method::tl_diagonalise(&turns, values);
  for (int k = N - 3; k >= 0; --k) {
    for (int row = k + 1; row < N; ++row) {
      Method::tl_reflect(k, turns.reflections, turns.scales[k], &vectors[row * N]);
    }
  }
  const Real* rotation = turns.rotations;
  for (int sweep = 0; sweep < Method::TL_SWEEPS; ++sweep) {
    for (int i = N - 2; i >= 0; --i) {
      const Real c = *rotation++;
      const Real s = *rotation++;
      for (int k = i * N; k < (i + 1) * N; ++k) {
        const Real kept = vectors[k];
        vectors[k] = c * kept - s * vectors[k + N];
        vectors[k + N] = s * kept + c * vectors[k + N];
      }
    }
  }
}

/// Exchanges pairs until the values descend.
template <int N, class Real>
constexpr void sort_descending(Real (&values)[N], Real (&vectors)[N * N]) noexcept {
  for (int end = N - 1; end > 0; --end) {
    for (int i = 0; i < end; ++i) {
      const bool ascends = values[i] < values[i + 1];
      exchange_if(ascends, values[i], values[i + 1]);
      for (int k = 0; k < N; ++k) {
        exchange_if(ascends, vectors[i * N + k], vectors[(i + 1) * N + k]);
      }
    }
  }
}

}  // namespace steps

/// The eigenvalues and vectors of the row-major symmetric `A`, whose lower triangle is read.
/// Absolute errors of the values: a few roundings of the largest, for N up to about 30. A vector's
/// sign, and the basis of equal values, mean nothing.
template <int N, int NN, class Real>
inline SymmetricEigen<N, Real> symmetric_eigen(const Real (&A)[NN]) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  SymmetricEigen<N, Real> eigen;
  steps::decompose<N>(A, eigen.values, eigen.vectors);
  steps::sort_descending(eigen.values, eigen.vectors);
  return eigen;
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
