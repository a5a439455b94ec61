#pragma once
// Rows of numbers, eight at a time, in as many registers as hold eight.

#include "limit_sizes.h"
#include "registers.h"

/// Sum of products, in eight sums that run side by side. TL_UNKNOWNS is a multiple of
/// eight.
TL_INLINE real tl_dot(const real* a, const real* b) {
  TlRegister sums[TL_REGISTERS];
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
    const TlRegister zero = {TL_ZERO};
    sums[k] = zero;
  }
  for (int32_t i = 0; i < TL_UNKNOWNS; i += 8) {
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
      sums[k] += tl_load(&a[i + (k * TL_WIDTH)]) * tl_load(&b[i + (k * TL_WIDTH)]);
    }
  }
  real s[8];
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
    tl_store(sums[k], &s[k * TL_WIDTH]);
  }
  return ((s[0] + s[4]) + (s[1] + s[5])) + ((s[2] + s[6]) + (s[3] + s[7]));
}

/// Eight `entries` less the sum of `count` products of factors, `stride` apart, and
/// rows of `columns`.
TL_INLINE void tl_subtract_rows(const real* factors, const real* columns,
    int32_t stride, int32_t count, real* entries) {
  TlRegister left[TL_REGISTERS];
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
    left[k] = tl_load(&entries[k * TL_WIDTH]);
  }
  for (int32_t i = 0; i < count; ++i) {
    const real factor = factors[i * stride];
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
      left[k] -= factor * tl_load(&columns[(i * stride) + (k * TL_WIDTH)]);
    }
  }
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < TL_REGISTERS; ++k) {
    tl_store(left[k], &entries[k * TL_WIDTH]);
  }
}

/// Subtracts the product of `along` and v^T W from the columns of W that `count`
/// registers hold, from row `at` on.
TL_INLINE TREELINE_IN_PLACE void tl_reflect_registers(const real* v,
    const real* along, int32_t at, int32_t rows, int32_t cols, int32_t count,
    real* W) {
  TlRegister sums[2 * TL_REGISTERS];
  TREELINE_WRITTEN_OUT for (int32_t k = 0; k < count; ++k) {
    const TlRegister zero = {TL_ZERO};
    sums[k] = zero;
  }
  for (int32_t i = at; i < rows; ++i) {
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < count; ++k) {
      sums[k] += v[i] * tl_load(&W[(i * cols) + (k * TL_WIDTH)]);
    }
  }
  for (int32_t i = at; i < rows; ++i) {
    TREELINE_WRITTEN_OUT for (int32_t k = 0; k < count; ++k) {
      real* const place = &W[(i * cols) + (k * TL_WIDTH)];
      tl_store(tl_load(place) - (along[i] * sums[k]), place);
    }
  }
}

/// Subtracts the product of `along` and v^T W from the columns of W from `begin` to
/// `end`, from row `at` on. Sixteen columns at once where there are vectors;
/// elsewhere it would only be longer.
TL_INLINE void tl_reflect_columns(const real* v, const real* along, int32_t at,
    int32_t rows, int32_t begin, int32_t end, int32_t cols, real* W) {
  int32_t j = begin;
#if TREELINE_REGISTER_BYTES > 0
  for (; (j + 16) <= end; j += 16) {
    tl_reflect_registers(v, along, at, rows, cols, 2 * TL_REGISTERS, &W[j]);
  }
#endif
  for (; j < end; j += 8) {
    tl_reflect_registers(v, along, at, rows, cols, TL_REGISTERS, &W[j]);
  }
}
