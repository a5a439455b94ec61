#pragma once
// Eigenvalues and eigenvectors of small symmetric matrices by cyclic Jacobi rotations. C++17,
// freestanding, fixed size, a fixed number of sweeps: same time for every matrix.

#include "core/square_root.hpp"

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

template <class Real>
constexpr void turn_pair(Real c, Real s, Real& a, Real& b) noexcept {
  const Real kept = a;
  a = c * a - s * b;
  b = s * kept + c * b;
}

/// Turns rows and columns p, q of the symmetric `A` so that A_pq = 0, and rows p, q of `V` with
/// them. t = tan(angle) is the smaller root of t^2 + (A_qq - A_pp)/A_pq t - 1 = 0, written so that
/// nothing is divided by A_pq.
template <int N, class Real>
inline void rotate_pair(int p, int q, Real (&A)[N * N], Real (&V)[N * N]) noexcept {
  const Real difference = A[q * N + q] - A[p * N + p];
  const Real twice = Real(2) * A[p * N + q];
  const Real size = difference < Real(0) ? -difference : difference;
  const Real sum = size + root(difference * difference + twice * twice);
  const Real signed_twice = difference < Real(0) ? -twice : twice;
  const Real t = signed_twice / (sum > Real(0) ? sum : Real(1));
  const Real c = Real(1) / root(Real(1) + t * t);
  const Real s = t * c;
  for (int k = 0; k < N; ++k) {
    turn_pair(c, s, A[k * N + p], A[k * N + q]);
  }
  for (int k = 0; k < N; ++k) {
    turn_pair(c, s, A[p * N + k], A[q * N + k]);
    turn_pair(c, s, V[p * N + k], V[q * N + k]);
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

/// What `symmetric_eigen` finds, written where it is wanted; uses up `A`.
template <int N, class Real>
inline void diagonalise(Real (&A)[N * N], int sweeps, Real (&values)[N],
                        Real (&vectors)[N * N]) noexcept {
  for (int i = 0; i < N * N; ++i) {
    vectors[i] = i % (N + 1) == 0 ? Real(1) : Real(0);
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int p = 0; p < N - 1; ++p) {
      for (int q = p + 1; q < N; ++q) {
        rotate_pair<N>(p, q, A, vectors);
      }
    }
  }
  for (int i = 0; i < N; ++i) {
    values[i] = A[i * N + i];
  }
  sort_descending(values, vectors);
}

}  // namespace steps

/// How many sweeps bring N x N matrices to rounding: convergence is quadratic, so float needs
/// fewer.
template <class Real>
constexpr int jacobi_sweeps(int n) noexcept {
  return sizeof(Real) >= sizeof(double) ? 10 : n <= 2 ? 2 : n <= 4 ? 5 : n <= 6 ? 6 : 8;
}

/// The eigenvalues and vectors of the row-major symmetric `A`, both triangles of which are read.
/// Absolute errors of the values: a few roundings of the largest, for N up to about 30. A vector's
/// sign, and the basis of equal values, mean nothing.
template <int N, int NN, class Real>
inline SymmetricEigen<N, Real> symmetric_eigen(const Real (&A)[NN],
                                               int sweeps = jacobi_sweeps<Real>(N)) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  // Its transpose, which is A: of a plain copy compilers make a call of memcpy.
  Real work[NN];
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      work[i * N + j] = A[j * N + i];
    }
  }
  SymmetricEigen<N, Real> eigen;
  steps::diagonalise(work, sweeps, eigen.values, eigen.vectors);
  return eigen;
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
