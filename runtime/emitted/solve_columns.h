#pragma once
// M X = B for the columns of two matrices and of the unit matrix, where M = L^T D L
// is the mass matrix of a tree: L has zeros where M has (Featherstone, RBDA
// section 6.5). Rows of all three stand side by side in one array, whose rows are a
// multiple of eight numbers long, so that compilers make vector instructions of the
// sums. No branch on data.

#include "ending_sizes.h"

/// to -= a x
TL_INLINE void tl_subtract_row(
    real a, const real* TL_RESTRICT x, real* TL_RESTRICT to) {
  for (int32_t j = 0; j < TL_STRIDE; ++j) {
    to[j] = to[j] - (a * x[j]);
  }
}

/// to -= a x + b y + c z + d w, one after the other.
TL_INLINE void tl_subtract_four_rows(real a, const real* TL_RESTRICT x, real b,
    const real* TL_RESTRICT y, real c, const real* TL_RESTRICT z, real d,
    const real* TL_RESTRICT w, real* TL_RESTRICT to) {
  for (int32_t j = 0; j < TL_STRIDE; ++j) {
    to[j] = (((to[j] - (a * x[j])) - (b * y[j])) - (c * z[j])) - (d * w[j]);
  }
}

/// Subtracts from row i the rows of the entries from ends[i - 1] to ends[i]. An entry
/// is two numbers: the row, and where its factor stands in L.
TL_INLINE void tl_subtract_entries(
    const int16_t* ends, const int16_t* entries, int32_t i, const real* L, real* X) {
  real* const to = &X[i * TL_STRIDE];
  const int32_t end = ends[i];
  int32_t e = (i > 0) ? ends[i - 1] : 0;
  for (; (e + 3) < end; e += 4) {
    const int16_t* const entry = &entries[2 * e];
    tl_subtract_four_rows(L[entry[1]], &X[entry[0] * TL_STRIDE], L[entry[3]],
        &X[entry[2] * TL_STRIDE], L[entry[5]], &X[entry[4] * TL_STRIDE], L[entry[7]],
        &X[entry[6] * TL_STRIDE], to);
  }
  for (; e < end; ++e) {
    const int16_t* const entry = &entries[2 * e];
    tl_subtract_row(L[entry[1]], &X[entry[0] * TL_STRIDE], to);
  }
}

/// Makes of A and B, n x n, M^-1 A and M^-1 B, and of `inverse` M^-1. `L` has the
/// entries of L that may not be 0, `inverse_D` 1 / D. `above` lists the rows that
/// L^-T subtracts from each row, `below` those that L^-1 does. `X` is work space of n
/// rows.
TL_INLINE void tl_solve_columns(const int16_t* above_ends, const int16_t* above,
    const int16_t* below_ends, const int16_t* below, const real* TL_RESTRICT L,
    const real* TL_RESTRICT inverse_D, real* TL_RESTRICT X, real* TL_RESTRICT A,
    real* TL_RESTRICT B, real* TL_RESTRICT inverse) {
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    real* const row = &X[i * TL_STRIDE];
    for (int32_t j = 0; j < TL_VELOCITIES; ++j) {
      row[j] = A[(i * TL_VELOCITIES) + j];
      row[TL_VELOCITIES + j] = B[(i * TL_VELOCITIES) + j];
    }
    for (int32_t j = 2 * TL_VELOCITIES; j < TL_STRIDE; ++j) {
      row[j] = TL_ZERO;
    }
    row[(2 * TL_VELOCITIES) + i] = TL_ONE;
  }
  for (int32_t i = TL_VELOCITIES - 1; i >= 0; --i) {
    tl_subtract_entries(above_ends, above, i, L, X);
  }
  for (int32_t i = 0; i < TL_VELOCITIES; ++i) {
    real* const row = &X[i * TL_STRIDE];
    for (int32_t j = 0; j < TL_STRIDE; ++j) {
      row[j] = row[j] * inverse_D[i];
    }
    tl_subtract_entries(below_ends, below, i, L, X);
    for (int32_t j = 0; j < TL_VELOCITIES; ++j) {
      A[(i * TL_VELOCITIES) + j] = row[j];
      B[(i * TL_VELOCITIES) + j] = row[TL_VELOCITIES + j];
      inverse[(i * TL_VELOCITIES) + j] = row[(2 * TL_VELOCITIES) + j];
    }
  }
}
