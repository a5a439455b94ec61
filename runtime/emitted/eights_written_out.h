#pragma once
// Rows of numbers, eight at a time, written out for rules that know no vectors: what
// eights.h gives where the machine has none, with the same bits.

#include "limit_sizes.h"

/// Sum of products, in eight sums that run side by side. TL_UNKNOWNS is a multiple of
/// eight.
TL_INLINE real tl_dot(const real* a, const real* b) {
  real sum_0 = TL_ZERO;
  real sum_1 = TL_ZERO;
  real sum_2 = TL_ZERO;
  real sum_3 = TL_ZERO;
  real sum_4 = TL_ZERO;
  real sum_5 = TL_ZERO;
  real sum_6 = TL_ZERO;
  real sum_7 = TL_ZERO;
  for (int32_t i = 0; i < TL_UNKNOWNS; i += 8) {
    sum_0 += a[i] * b[i];
    sum_1 += a[i + 1] * b[i + 1];
    sum_2 += a[i + 2] * b[i + 2];
    sum_3 += a[i + 3] * b[i + 3];
    sum_4 += a[i + 4] * b[i + 4];
    sum_5 += a[i + 5] * b[i + 5];
    sum_6 += a[i + 6] * b[i + 6];
    sum_7 += a[i + 7] * b[i + 7];
  }
  return ((sum_0 + sum_4) + (sum_1 + sum_5)) + ((sum_2 + sum_6) + (sum_3 + sum_7));
}

/// Eight `entries` less the sum of `count` products of factors, `stride` apart, and
/// rows of `columns`.
TL_INLINE void tl_subtract_rows(const real* factors, const real* columns,
    int32_t stride, int32_t count, real* entries) {
  real left_0 = entries[0];
  real left_1 = entries[1];
  real left_2 = entries[2];
  real left_3 = entries[3];
  real left_4 = entries[4];
  real left_5 = entries[5];
  real left_6 = entries[6];
  real left_7 = entries[7];
  for (int32_t i = 0; i < count; ++i) {
    const real factor = factors[i * stride];
    const real* const row = &columns[i * stride];
    left_0 -= factor * row[0];
    left_1 -= factor * row[1];
    left_2 -= factor * row[2];
    left_3 -= factor * row[3];
    left_4 -= factor * row[4];
    left_5 -= factor * row[5];
    left_6 -= factor * row[6];
    left_7 -= factor * row[7];
  }
  entries[0] = left_0;
  entries[1] = left_1;
  entries[2] = left_2;
  entries[3] = left_3;
  entries[4] = left_4;
  entries[5] = left_5;
  entries[6] = left_6;
  entries[7] = left_7;
}

/// Subtracts the product of `along` and the sum of rows `at` to `rows` of W, each
/// times its entry of v, from the columns `begin` to `end`: W - along (v^T W).
TL_INLINE void tl_reflect_columns(const real* v, const real* along, int32_t at,
    int32_t rows, int32_t begin, int32_t end, int32_t cols, real* W) {
  real sums[TL_COLS];
  for (int32_t j = begin; j < end; ++j) {
    sums[j] = TL_ZERO;
  }
  for (int32_t i = at; i < rows; ++i) {
    const real factor = v[i];
    for (int32_t j = begin; j < end; ++j) {
      sums[j] += factor * W[(i * cols) + j];
    }
  }
  for (int32_t i = at; i < rows; ++i) {
    const real factor = along[i];
    for (int32_t j = begin; j < end; ++j) {
      W[(i * cols) + j] -= factor * sums[j];
    }
  }
}
