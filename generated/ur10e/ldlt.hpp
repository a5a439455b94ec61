// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_LDLT_HPP
#define TREELINE_UR10E_LDLT_HPP
// Symmetric positive definite systems of fixed size: A = L D L^T with L unit lower
// triangular. No square root, no branch on data.
// Generated; see ur10e_damped.hpp for the contract.

#include "damped_sizes.hpp"

namespace ur10e {
namespace detail {

/// Factors the row-major symmetric A in place: L below the diagonal, D on it; what
/// lies above the diagonal is neither read nor written. Returns whether every pivot
/// is positive (false for NaN too); when not, the factors are meaningless.
inline bool ldlt_factor(double* A) {
  bool positive = true;
  double scaled[kTaskRows];
  for (int32_t k = 0; k < kTaskRows; ++k) {
    // Or compilers take it for read before it is written.
    scaled[k] = A[(k * kTaskRows) + k];
  }
  for (int32_t j = 0; j < kTaskRows; ++j) {
    double pivot = A[(j * kTaskRows) + j];
    for (int32_t k = 0; k < j; ++k) {
      scaled[k] = A[(j * kTaskRows) + k] * A[(k * kTaskRows) + k];
      pivot -= A[(j * kTaskRows) + k] * scaled[k];
    }
    A[(j * kTaskRows) + j] = pivot;
    positive = positive && (pivot > 0.0);
    for (int32_t i = j + 1; i < kTaskRows; ++i) {
      double entry = A[(i * kTaskRows) + j];
      for (int32_t k = 0; k < j; ++k) {
        entry -= A[(i * kTaskRows) + k] * scaled[k];
      }
      A[(i * kTaskRows) + j] = entry / pivot;
    }
  }
  return positive;
}

/// Solves A x = b in place with the factors of ldlt_factor: x holds b on entry.
inline void ldlt_solve(const double* factors, double* x) {
  for (int32_t i = 0; i < kTaskRows; ++i) {
    for (int32_t k = 0; k < i; ++k) {
      x[i] -= factors[(i * kTaskRows) + k] * x[k];
    }
  }
  for (int32_t i = kTaskRows - 1; i >= 0; --i) {
    x[i] /= factors[(i * kTaskRows) + i];
    for (int32_t k = i + 1; k < kTaskRows; ++k) {
      x[i] -= factors[(k * kTaskRows) + i] * x[k];
    }
  }
}

}  // namespace detail
}  // namespace ur10e

#endif  // TREELINE_UR10E_LDLT_HPP
