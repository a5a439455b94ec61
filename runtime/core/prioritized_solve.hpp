#pragma once
// Forces of tasks in strict priority order from one factored matrix. C++17, freestanding, fixed
// size, no square root.
//
// The rows of all tasks are stacked, the most important first; A = J M^-1 J^T. Eliminating in that
// order, the pivot c_k is the inverse inertia of row k within the dynamically consistent null space
// of all rows above it, (Lambda_(k|prec))^-1, and the recursion of prioritised null spaces (Khatib,
// Sentis) is nothing but this elimination. As long as no pivot vanishes all rows are achieved.
// Where row k depends on the rows above, its pivot vanishes and row k alone yields: 1/c_k becomes
// w_k/c_k with a share that falls smoothly from 1 to 0,
//
//     w_k = t^8 / (1 + t^8),  t = c_k / border_k:
//
// one half at the border, and from a hundred borders on 1 to the last digit of double. What is
// solved then is
//
//     (A + diag(delta)) F = b,  delta_k = c_k (1 - w_k) / w_k,
//
// so A F = b - delta F. Since delta is zero for every row with w = 1, and w_k depends on rows 1..k
// only: every row that does not yield is achieved to rounding, whatever the rows below it ask for
// or how they conflict. F stays bounded, |w_k / c_k| < 1 / border_k. It is the law of the generated
// `control_torque` of scenes whose points differ in priority.

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// 0 for s <= 0, 1 for s >= 1, continuously differentiable between.
template <class Real>
constexpr Real smooth_step(Real s) noexcept {
  const Real t = s > Real(0) ? (s < Real(1) ? s : Real(1)) : Real(0);
  return t * t * (Real(3) - Real(2) * t);
}

/// A + diag(delta) = L diag(1 / inverse_pivots) L^T.
template <int N, class Real>
struct SelectiveFactors {
  Real L[N * N];           ///< unit lower triangular; the rest is not used
  Real inverse_pivots[N];  ///< w_k / c_k, zero for a row that is given up
  Real shares[N];          ///< w_k: 1 achieved, 0 given up
};

namespace steps {

/// Eliminates in order. `invert(k, pivot, own)` gives row k's inverse pivot and its share; `own` is
/// A_kk.
template <int N, class Real, class Invert>
inline SelectiveFactors<N, Real> eliminate(const Real (&A)[N * N], const Invert& invert) noexcept {
  SelectiveFactors<N, Real> factors;
  Real columns[N * N];
  for (int k = 0; k < N; ++k) {
    for (int i = k; i < N; ++i) {
      Real entry = A[i * N + k];
      for (int j = 0; j < k; ++j) {
        entry -= factors.L[i * N + j] * columns[k * N + j];
      }
      columns[i * N + k] = entry;
    }
    invert(k, columns[k * N + k], A[k * N + k], factors.inverse_pivots[k], factors.shares[k]);
    for (int i = k; i < N; ++i) {
      factors.L[i * N + k] = i == k ? Real(1) : columns[i * N + k] * factors.inverse_pivots[k];
    }
  }
  return factors;
}

}  // namespace steps

namespace steps {

/// w and w / pivot, without dividing by a pivot that may be as small as it likes.
template <class Real>
constexpr void yield(Real pivot, Real border, Real& inverse, Real& share) noexcept {
  const bool moves = border > Real(0) && pivot > Real(0);
  const bool below = moves && pivot < border;
  const Real t = !moves ? Real(0) : below ? Real(pivot / border) : Real(border / pivot);
  const Real t2 = t * t;
  const Real t4 = t2 * t2;
  const Real t8 = t4 * t4;
  const Real part = Real(1) / (Real(1) + t8);
  share = !moves ? Real(0) : below ? Real(t8 * part) : part;
  inverse = !moves ? Real(0) : below ? Real(t4 * t2 * t * part / border) : Real(part / pivot);
}

}  // namespace steps

/// Factors the row-major symmetric positive semidefinite `A`, of which the lower triangle is read.
/// Row k yields where its pivot falls towards borders[k].
template <int N, int NN, class Real>
inline SelectiveFactors<N, Real> bordered_factor(const Real (&A)[NN],
                                                 const Real (&borders)[N]) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  return steps::eliminate<N>(
      A, [&borders](int k, Real pivot, Real, Real& inverse, Real& share) noexcept {
        steps::yield(pivot, borders[k], inverse, share);
      });
}

/// Factors `A` with borders of `tolerance` A_kk: c_k / A_kk is the squared sine, in the metric of
/// kinetic energy, of the angle between row k and the rows above it. 1e-4 (0.6 degrees; nothing
/// yields beyond 6) suits control; not below 1e-12 in double.
template <int N, int NN, class Real>
inline SelectiveFactors<N, Real> prioritized_factor(const Real (&A)[NN], Real tolerance) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  return steps::eliminate<N>(
      A, [tolerance](int, Real pivot, Real own, Real& inverse, Real& share) noexcept {
        steps::yield(pivot, Real(tolerance * own), inverse, share);
      });
}

/// Factors `A` with given shares instead of a test of pivots: row k is achieved where shares[k] =
/// 1, left out where it is 0, and between them yields by delta_k = c_k (1 - w_k) / w_k. Pivots of
/// rows with a positive share must not vanish.
template <int N, int NN, class Real>
inline SelectiveFactors<N, Real> shared_factor(const Real (&A)[NN],
                                               const Real (&shares)[N]) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  return steps::eliminate<N>(
      A, [&shares](int k, Real pivot, Real, Real& inverse, Real& share) noexcept {
        const bool kept = shares[k] > Real(0) && pivot > Real(0);
        share = kept ? shares[k] : Real(0);
        inverse = kept ? share / pivot : Real(0);
      });
}

/// Turns `x`, which holds the accelerations b that are missing, into the forces F.
template <int N, class Real>
constexpr void selective_solve(const SelectiveFactors<N, Real>& factors, Real (&x)[N]) noexcept {
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k < i; ++k) {
      x[i] -= factors.L[i * N + k] * x[k];
    }
  }
  for (int i = N - 1; i >= 0; --i) {
    x[i] *= factors.inverse_pivots[i];
    for (int k = i + 1; k < N; ++k) {
      x[i] -= factors.L[k * N + i] * x[k];
    }
  }
}

/// Factor and solve in one: F of A F = b, rows in priority order, in place.
template <int N, int NN, class Real>
inline void prioritized_solve(const Real (&A)[NN], Real tolerance, Real (&x)[N]) noexcept {
  selective_solve(prioritized_factor<N>(A, tolerance), x);
}

/// tau += J^T F: what the forces ask of the joints. J is rows x nv, row-major.
template <int rows, int nv, int size, class Real>
constexpr void add_task_torque(const Real (&J)[size], const Real (&F)[rows],
                               Real (&tau)[nv]) noexcept {
  static_assert(size == rows * nv, "J holds rows x nv numbers");
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < nv; ++i) {
      tau[i] += J[row * nv + i] * F[row];
    }
  }
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
