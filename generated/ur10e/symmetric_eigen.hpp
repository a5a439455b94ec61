#ifndef TREELINE_UR10E_SYMMETRIC_EIGEN_HPP
#define TREELINE_UR10E_SYMMETRIC_EIGEN_HPP
// Eigenvalues and eigenvectors of small symmetric matrices: Householder's reflections to three
// diagonals, then sweeps of QL with Wilkinson's shift. C++17, freestanding, fixed size, a fixed
// number of sweeps without a branch: same time for every matrix. Golub, Van Loan: Matrix
// Computations, 4th ed., sections 8.3.1 and 8.3.5.

#include "square_root.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace ur10e::detail {

/// A = sum_i values[i] v_i v_i^T.
template <int N, class Real>
struct SymmetricEigen {
  Real values[N];       ///< descending
  Real vectors[N * N];  ///< row i: the unit vector v_i
};

/// How many sweeps bring n x n matrices to rounding. Random matrices take 1.6 n; found by trying
/// graded, clustered, repeated and split ones, the worst of which takes up to 3 n, in float 2.5 n.
template <class Real>
constexpr int ql_sweeps(int n) noexcept {
  return n <= 1 ? 0 : n == 2 ? 2 : sizeof(Real) >= sizeof(double) ? 3 * n + 2 : 5 * n / 2;
}

namespace steps {

/// Square root; 0 for what rounding has made negative.
template <class Real>
inline Real root(Real x) noexcept {
  return square_root(x > Real(0) ? x : Real(0));
}

/// Square root of what cannot be negative.
template <class Real>
inline Real root_of_squares(Real x) noexcept {
  return square_root(x);
}

template <class Real>
constexpr Real absolute(Real x) noexcept {
  return x < Real(0) ? -x : x;
}

/// Squares below this have lost digits; no entry of this root matters beside 1.
template <class Real>
inline constexpr Real kLostSquare = Real(sizeof(Real) >= sizeof(double) ? 1e-280 : 1e-30);

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

/// Divides `A` by its largest entry, which is returned.
template <int N, class Real>
constexpr Real scale_to_one(Real (&A)[N * N]) noexcept {
  Real largest = kLostSquare<Real>;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j <= i; ++j) {
      const Real size = absolute(A[i * N + j]);
      largest = size > largest ? size : largest;
    }
  }
  const Real factor = Real(1) / largest;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j <= i; ++j) {
      A[i * N + j] = factor * A[i * N + j];
    }
  }
  return largest;
}

/// Turns column k of `A` below the diagonal onto its first entry by I - scale v v^T, with v in
/// entries k + 1 to N - 1. Returns that entry; `scale` is 0 where nothing is to be turned.
template <int N, class Real>
inline Real reflect_column(int k, const Real (&A)[N * N], Real (&v)[N], Real& scale) noexcept {
  Real square = Real(0);
  for (int i = k + 2; i < N; ++i) {
    v[i] = A[i * N + k];
    square += v[i] * v[i];
  }
  const Real first = A[(k + 1) * N + k];
  const Real length = root_of_squares(first * first + square);
  const bool turns = square > kLostSquare<Real>;
  v[k + 1] = first < Real(0) ? first - length : first + length;
  scale = turns ? Real(1) / (turns ? length * (length + absolute(first)) : Real(1)) : Real(0);
  return !turns ? first : first < Real(0) ? length : -length;
}

/// A <- H A H in the lower triangle of rows from k + 1, with H = I - scale v v^T.
template <int N, class Real>
constexpr void apply_reflection(int k, const Real (&v)[N], Real scale, Real (&A)[N * N]) noexcept {
  Real w[N];
  for (int i = k + 1; i < N; ++i) {
    w[i] = Real(0);
    for (int j = k + 1; j < i; ++j) {
      w[i] += A[i * N + j] * v[j];
      w[j] += A[i * N + j] * v[i];
    }
    w[i] += A[i * N + i] * v[i];
  }
  Real along = Real(0);
  for (int i = k + 1; i < N; ++i) {
    w[i] = scale * w[i];
    along += w[i] * v[i];
  }
  const Real part = Real(0.5) * scale * along;
  for (int i = k + 1; i < N; ++i) {
    w[i] -= part * v[i];
    for (int j = k + 1; j <= i; ++j) {
      A[i * N + j] -= v[i] * w[j] + w[i] * v[j];
    }
  }
}

/// V <- V H in rows from k + 1, where all before column k + 1 is 0.
template <int N, class Real>
constexpr void turn_vectors(int k, const Real (&v)[N], Real scale, Real (&V)[N * N]) noexcept {
  for (int row = k + 1; row < N; ++row) {
    Real sum = Real(0);
    for (int i = k + 1; i < N; ++i) {
      sum += V[row * N + i] * v[i];
    }
    sum = scale * sum;
    for (int i = k + 1; i < N; ++i) {
      V[row * N + i] -= sum * v[i];
    }
  }
}

/// T = V A V^T with the diagonal `d` and `e[i]` between d[i] and d[i + 1]. Reads the lower triangle
/// of `A` and uses it up.
template <int N, class Real>
inline void tridiagonalise(Real (&A)[N * N], Real (&d)[N], Real (&e)[N],
                           Real (&V)[N * N]) noexcept {
  for (int i = 0; i < N * N; ++i) {
    V[i] = i % (N + 1) == 0 ? Real(1) : Real(0);
  }
  Real v[N][N];
  Real scales[N];
  for (int k = 0; k < N - 2; ++k) {
    e[k] = reflect_column<N>(k, A, v[k], scales[k]);
    apply_reflection<N>(k, v[k], scales[k], A);
  }
  for (int k = N - 3; k >= 0; --k) {
    turn_vectors<N>(k, v[k], scales[k], V);
  }
  for (int k = 0; k < N; ++k) {
    d[k] = A[k * N + k];
  }
  if constexpr (N > 1) {
    e[N - 2] = A[N * N - 2];
  }
}

/// The eigenvalue of the first block that has not come apart: that of its upper left 2 x 2 which is
/// nearer to the upper left entry.
template <int N, class Real>
inline Real shift_of(const Real (&d)[N], const Real (&e)[N], Real negligible) noexcept {
  int top = 0;
  for (int i = N - 2; i >= 0; --i) {
    top = absolute(e[i]) > negligible ? i : top;
  }
  const Real beside = e[top];
  const Real part = Real(0.5) * (d[top + 1] - d[top]);
  const Real length = root_of_squares(part * part + beside * beside);
  const Real sum = part < Real(0) ? part - length : part + length;
  return d[top] - beside * (beside / (length > Real(0) ? sum : Real(1)));
}

/// One sweep of implicit QL over all blocks, rows of `V` with it. Where an `e` is negligible it
/// becomes 0, the rotation nothing, and the next block begins.
template <int N, class Real>
inline void sweep_up(Real (&d)[N], Real (&e)[N], Real negligible, Real (&V)[N * N]) noexcept {
  const Real shift = shift_of(d, e, negligible);
  Real c = Real(1);
  Real s = Real(1);
  Real change = Real(0);  // what d[i + 1] still has to lose
  Real left = Real(0);    // what e[i + 1] is if its block ends above it
  Real g = d[N - 1] - shift;
  bool begins = true;  // a block at d[i + 1]
  for (int i = N - 2; i >= 0; --i) {
    const bool splits = !(absolute(e[i]) > negligible);
    const Real held = splits ? Real(0) : e[i];
    const Real f = s * held;
    const Real b = c * held;
    const Real square = f * f + g * g;
    const bool turns = !splits && square > kLostSquare<Real>;
    const Real length = root_of_squares(square);
    const Real factor = Real(1) / (turns ? length : Real(1));
    c = (turns ? g : Real(1)) * factor;
    s = f * factor;
    e[i + 1] = splits || begins ? left : length;
    const Real kept = d[i + 1] - change;
    const Real r = (d[i] - kept) * s + Real(2) * c * b;
    change = s * r;
    d[i + 1] = kept + change;
    left = c * r - b;
    const Real anew = d[i] - shift;
    g = splits ? anew : left;
    for (int k = 0; k < N; ++k) {
      turn_pair(c, s, V[i * N + k], V[(i + 1) * N + k]);
    }
    s = splits ? Real(1) : s;
    begins = splits;
  }
  d[0] -= change;
  e[0] = left;
}

/// Eigenvalues and unit vectors as rows in no order; reads the lower triangle of `A` and uses it
/// up.
template <int N, class Real>
inline void diagonalise(Real (&A)[N * N], Real (&values)[N], Real (&vectors)[N * N]) noexcept {
  const Real largest = scale_to_one<N>(A);
  Real beside[N];
  tridiagonalise<N>(A, values, beside, vectors);
  if constexpr (N > 1) {
    const Real negligible = Real(4) * Format<Real>::kEpsilon;
    for (int sweep = 0; sweep < ql_sweeps<Real>(N); ++sweep) {
      sweep_up(values, beside, negligible, vectors);
    }
  }
  for (int i = 0; i < N; ++i) {
    values[i] = largest * values[i];
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
  // Its transpose, which is A: of a plain copy compilers make a call of memcpy.
  Real work[NN];
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      work[i * N + j] = A[j * N + i];
    }
  }
  SymmetricEigen<N, Real> eigen;
  steps::diagonalise<N>(work, eigen.values, eigen.vectors);
  steps::sort_descending(eigen.values, eigen.vectors);
  return eigen;
}

}  // namespace ur10e::detail

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif  // TREELINE_UR10E_SYMMETRIC_EIGEN_HPP
