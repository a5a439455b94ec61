#ifndef TREELINE_UR10E_LDLT_HPP
#define TREELINE_UR10E_LDLT_HPP
// Small symmetric positive definite systems: A = L D L^T with L unit lower triangular. C++17,
// freestanding, fixed size, no square root, no branch on data.

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace ur10e::detail {

/// Factors the row-major symmetric `A` in place: L below the diagonal, D on it; what lies above the
/// diagonal is neither read nor written. Returns whether every pivot is positive (false for NaN
/// too); when not, the factors are meaningless.
template <int N, int NN, class Real>
inline bool ldlt_factor(Real (&A)[NN]) noexcept {
  static_assert(NN == N * N, "A holds N x N numbers");
  bool positive = true;
  Real scaled[N];
  for (int k = 0; k < N; ++k) {
    scaled[k] = A[k * N + k];  // or compilers take it for read before it is written
  }
  for (int j = 0; j < N; ++j) {
    Real pivot = A[j * N + j];
    for (int k = 0; k < j; ++k) {
      scaled[k] = A[j * N + k] * A[k * N + k];
      pivot -= A[j * N + k] * scaled[k];
    }
    A[j * N + j] = pivot;
    positive &= pivot > Real(0);
    for (int i = j + 1; i < N; ++i) {
      Real entry = A[i * N + j];
      for (int k = 0; k < j; ++k) {
        entry -= A[i * N + k] * scaled[k];
      }
      A[i * N + j] = entry / pivot;
    }
  }
  return positive;
}

/// Solves A x = b in place (`x` holds b on entry) with the factors of `ldlt_factor`.
template <int N, int NN, class Real>
constexpr void ldlt_solve(const Real (&factors)[NN], Real (&x)[N]) noexcept {
  static_assert(NN == N * N, "the factors hold N x N numbers");
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k < i; ++k) {
      x[i] -= factors[i * N + k] * x[k];
    }
  }
  for (int i = N - 1; i >= 0; --i) {
    x[i] /= factors[i * N + i];
    for (int k = i + 1; k < N; ++k) {
      x[i] -= factors[k * N + i] * x[k];
    }
  }
}

}  // namespace ur10e::detail

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#endif  // TREELINE_UR10E_LDLT_HPP
