#pragma once

namespace treeline::core {

/// Columns of matrices are padded to a multiple of eight, which compilers turn into SIMD.
constexpr int in_eights(int count) noexcept {
  return (count + 7) / 8 * 8;
}

}  // namespace treeline::core
