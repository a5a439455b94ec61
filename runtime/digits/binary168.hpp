#pragma once

#include <array>
#include <cstdint>

namespace treeline::digits {

/// A finite nonzero number: an integer of 168 bits, the highest of which is set, times 2^(exponent
/// - 167). It is stored in three limbs, the lowest first.
struct Binary168 {
  std::array<std::uint64_t, 3> limbs{};
  std::int64_t exponent = 0;
  bool negative = false;
};

/// Largest difference of exponents that `add` accepts.
constexpr std::int64_t kFarthest = 160;

// Both functions exist if the compiler has integers of 128 bits.

/// a b, rounded to nearest, ties to even.
Binary168 multiply(const Binary168& a, const Binary168& b);
/// Computes a + b, rounded to nearest, ties to even. Returns false if the sum is zero. The
/// exponents may differ by at most `kFarthest`.
bool add(const Binary168& a, const Binary168& b, Binary168& sum);

}  // namespace treeline::digits
