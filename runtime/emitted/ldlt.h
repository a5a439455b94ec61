#pragma once
// Symmetric positive definite systems of fixed size: A = L D L^T with L unit lower
// triangular. No square root, no branch on data.

#include "damped_sizes.h"

/// Factors the row-major symmetric A in place: L below the diagonal, D on it; what
/// lies above the diagonal is neither read nor written. Returns whether every pivot
/// is positive (false for NaN too); when not, the factors are meaningless.
TL_INLINE bool tl_ldlt_factor(real* A) {
  bool positive = true;
  real scaled[TL_TASK_ROWS];
  for (int32_t k = 0; k < TL_TASK_ROWS; ++k) {
    // Or compilers take it for read before it is written.
    scaled[k] = A[(k * TL_TASK_ROWS) + k];
  }
  for (int32_t j = 0; j < TL_TASK_ROWS; ++j) {
    real pivot = A[(j * TL_TASK_ROWS) + j];
    for (int32_t k = 0; k < j; ++k) {
      scaled[k] = A[(j * TL_TASK_ROWS) + k] * A[(k * TL_TASK_ROWS) + k];
      pivot -= A[(j * TL_TASK_ROWS) + k] * scaled[k];
    }
    A[(j * TL_TASK_ROWS) + j] = pivot;
    positive = positive && (pivot > TL_ZERO);
    for (int32_t i = j + 1; i < TL_TASK_ROWS; ++i) {
      real entry = A[(i * TL_TASK_ROWS) + j];
      for (int32_t k = 0; k < j; ++k) {
        entry -= A[(i * TL_TASK_ROWS) + k] * scaled[k];
      }
      A[(i * TL_TASK_ROWS) + j] = entry / pivot;
    }
  }
  return positive;
}

/// Solves A x = b in place with the factors of tl_ldlt_factor: x holds b on entry.
TL_INLINE void tl_ldlt_solve(const real* factors, real* x) {
  for (int32_t i = 0; i < TL_TASK_ROWS; ++i) {
    for (int32_t k = 0; k < i; ++k) {
      x[i] -= factors[(i * TL_TASK_ROWS) + k] * x[k];
    }
  }
  for (int32_t i = TL_TASK_ROWS - 1; i >= 0; --i) {
    x[i] /= factors[(i * TL_TASK_ROWS) + i];
    for (int32_t k = i + 1; k < TL_TASK_ROWS; ++k) {
      x[i] -= factors[(k * TL_TASK_ROWS) + i] * x[k];
    }
  }
}
