#pragma once
// Eigenvalues and eigenvectors of small symmetric matrices: Householder's reflections to three
// diagonals, then sweeps of QL with Wilkinson's shift. C++17, freestanding, fixed size, a fixed
// number of sweeps without a branch: same time for every matrix. Golub, Van Loan: Matrix
// Computations, 4th ed., sections 8.3.1 and 8.3.5.

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

/// How many sweeps bring n x n matrices to rounding. Random matrices take 1.6 n; found by trying
/// graded, clustered, repeated and split ones, the worst of which takes up to 3 n, in float 2.5 n.
template <class Real>
constexpr int ql_sweeps(int n) noexcept {
  return n <= 1 ? 0 : n == 2 ? 2 : sizeof(Real) >= sizeof(double) ? 3 * n + 2 : 5 * n / 2;
}

namespace steps {

/// How eigenvectors turn vectors: reflections, then rotations of neighbouring entries. To turn a
/// vector takes fewer operations than to write the eigenvectors out.
template <int N, class Real>
struct Turns {
  static constexpr int kSweeps = ql_sweeps<Real>(N);
  Real reflections[N * N];  ///< column k below the diagonal: v of I - scales[k] v v^T
  Real scales[N];
  Real rotations[kSweeps > 0 ? 2 * (N - 1) * kSweeps : 1];  ///< c, s in the order of the sweeps
};

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
/// entries k + 1 to N - 1, where it replaces the column. Returns that entry; `scale` is 0 where
/// nothing is to be turned.
template <int N, class Real>
inline Real reflect_column(int k, Real (&A)[N * N], Real& scale) noexcept {
  Real square = Real(0);
  for (int i = k + 2; i < N; ++i) {
    square += A[i * N + k] * A[i * N + k];
  }
  const Real first = A[(k + 1) * N + k];
  const Real length = root_of_squares(first * first + square);
  const bool turns = square > kLostSquare<Real>;
  A[(k + 1) * N + k] = first < Real(0) ? first - length : first + length;
  scale = turns ? Real(1) / (turns ? length * (length + absolute(first)) : Real(1)) : Real(0);
  return !turns ? first : first < Real(0) ? length : -length;
}

/// A <- H A H in the lower triangle of rows from k + 1, with H = I - scale v v^T and v in column k.
template <int N, class Real>
constexpr void apply_reflection(int k, Real scale, Real (&A)[N * N]) noexcept {
  Real w[N];
  for (int i = k + 1; i < N; ++i) {
    w[i] = Real(0);
    for (int j = k + 1; j < i; ++j) {
      w[i] += A[i * N + j] * A[j * N + k];
      w[j] += A[i * N + j] * A[i * N + k];
    }
    w[i] += A[i * N + i] * A[i * N + k];
  }
  Real along = Real(0);
  for (int i = k + 1; i < N; ++i) {
    w[i] = scale * w[i];
    along += w[i] * A[i * N + k];
  }
  const Real part = Real(0.5) * scale * along;
  for (int i = k + 1; i < N; ++i) {
    w[i] -= part * A[i * N + k];
    for (int j = k + 1; j <= i; ++j) {
      A[i * N + j] -= A[i * N + k] * w[j] + w[i] * A[j * N + k];
    }
  }
}

/// x <- H x with the reflection k that `tridiagonalise` left in `A`.
template <int N, class Real>
constexpr void reflect(int k, const Real (&A)[N * N], Real scale, Real* x) noexcept {
  Real sum = Real(0);
  for (int i = k + 1; i < N; ++i) {
    sum += A[i * N + k] * x[i];
  }
  sum = scale * sum;
  for (int i = k + 1; i < N; ++i) {
    x[i] -= sum * A[i * N + k];
  }
}

/// T = H A H^T with the diagonal `d` and `e[i]` between d[i] and d[i + 1], where H is the product
/// of reflections N - 3 to 0. Reads the lower triangle of `A` and leaves the reflections in its
/// columns.
template <int N, class Real>
inline void tridiagonalise(Real (&A)[N * N], Real (&scales)[N], Real (&d)[N],
                           Real (&e)[N]) noexcept {
  for (int k = 0; k < N - 2; ++k) {
    e[k] = reflect_column<N>(k, A, scales[k]);
    apply_reflection<N>(k, scales[k], A);
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

/// One sweep of implicit QL over all blocks. Where an `e` is negligible it becomes 0, the rotation
/// nothing, and the next block begins. Writes the rotations of entries i and i + 1, the last first.
template <int N, class Real>
inline void sweep_up(Real (&d)[N], Real (&e)[N], Real negligible, Real* rotations) noexcept {
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
    *rotations++ = c;
    *rotations++ = s;
    s = splits ? Real(1) : s;
    begins = splits;
  }
  d[0] -= change;
  e[0] = left;
}

/// The eigenvalues, in no order, of the matrix whose lower triangle is in `turns.reflections`.
template <int N, class Real>
inline void diagonalise(Turns<N, Real>& turns, Real (&values)[N]) noexcept {
  const Real largest = scale_to_one<N>(turns.reflections);
  Real beside[N];
  tridiagonalise<N>(turns.reflections, turns.scales, values, beside);
  if constexpr (N > 1) {
    const Real negligible = Real(4) * Format<Real>::kEpsilon;
    for (int sweep = 0; sweep < turns.kSweeps; ++sweep) {
      sweep_up(values, beside, negligible, &turns.rotations[sweep * 2 * (N - 1)]);
    }
  }
  for (int i = 0; i < N; ++i) {
    values[i] = largest * values[i];
  }
}

/// Turns `x` into the axes of the eigenvectors.
template <int N, class Real>
constexpr void turn(const Turns<N, Real>& turns, Real (&x)[N]) noexcept {
  for (int k = 0; k < N - 2; ++k) {
    reflect<N>(k, turns.reflections, turns.scales[k], x);
  }
  const Real* rotation = turns.rotations;
  for (int sweep = 0; sweep < turns.kSweeps; ++sweep) {
    Real last = x[N - 1];
    for (int i = N - 2; i >= 0; --i) {
      const Real c = *rotation++;
      const Real s = *rotation++;
      x[i + 1] = s * x[i] + c * last;
      last = c * x[i] - s * last;
    }
    x[0] = last;
  }
}

/// Turns `x` back from the axes of the eigenvectors.
template <int N, class Real>
constexpr void turn_back(const Turns<N, Real>& turns, Real (&x)[N]) noexcept {
  const Real* rotation = turns.rotations + 2 * (N - 1) * turns.kSweeps;
  for (int sweep = 0; sweep < turns.kSweeps; ++sweep) {
    Real first = x[0];
    for (int i = 0; i < N - 1; ++i) {
      const Real s = *--rotation;
      const Real c = *--rotation;
      x[i] = c * first + s * x[i + 1];
      first = c * x[i + 1] - s * first;
    }
    x[N - 1] = first;
  }
  for (int k = N - 3; k >= 0; --k) {
    reflect<N>(k, turns.reflections, turns.scales[k], x);
  }
}

/// Eigenvalues and unit vectors as rows, in no order, of `A`, whose lower triangle is read.
template <int N, class Real>
inline void decompose(const Real (&A)[N * N], Real (&values)[N], Real (&vectors)[N * N]) noexcept {
  Turns<N, Real> turns;
  for (int j = 0; j < N; ++j) {
    for (int i = j; i < N; ++i) {  // by columns: of rows compilers make calls of memcpy
      turns.reflections[i * N + j] = A[i * N + j];
    }
  }
  for (int i = 0; i < N * N; ++i) {
    vectors[i] = i % (N + 1) == 0 ? Real(1) : Real(0);
  }
  diagonalise(turns, values);
  for (int k = N - 3; k >= 0; --k) {
    for (int row = k + 1; row < N; ++row) {
      reflect<N>(k, turns.reflections, turns.scales[k], &vectors[row * N]);
    }
  }
  const Real* rotation = turns.rotations;
  for (int sweep = 0; sweep < turns.kSweeps; ++sweep) {
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
