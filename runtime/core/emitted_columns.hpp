#pragma once
// The header of runtime/emitted that solves for all columns of matrices, as members of a class of
// any number type and size. C++17, freestanding.

#include <stdint.h>

namespace treeline::core {

/// Length of a row that holds three rows of n numbers, a multiple of eight.
constexpr int32_t column_stride(int32_t n) noexcept {
  return ((3 * n) + 7) / 8 * 8;
}

#define TL_INLINE
#define TL_RESTRICT __restrict

/// Everything of runtime/emitted/solve_columns.h, for matrices of so many rows.
template <class Number>
struct EmittedColumns {
  using real = Number;
  const real TL_ZERO = real(0.0);
  const real TL_ONE = real(1.0);
  const int32_t TL_VELOCITIES;
  const int32_t TL_STRIDE = column_stride(TL_VELOCITIES);

  explicit EmittedColumns(int32_t velocities) : TL_VELOCITIES(velocities) {}

#include "emitted/solve_columns.h"
};

#undef TL_INLINE
#undef TL_RESTRICT

}  // namespace treeline::core
