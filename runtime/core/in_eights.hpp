#pragma once

namespace treeline::core {

/// Columns of matrices are padded to a multiple of eight, which compilers turn into SIMD.
constexpr int in_eights(int count) noexcept {
  return (count + 7) / 8 * 8;
}

/// Length of a row that holds three rows of n numbers.
constexpr int column_stride(int n) noexcept {
  return in_eights(3 * n);
}

}  // namespace treeline::core
