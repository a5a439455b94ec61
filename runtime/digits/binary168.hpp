#pragma once

#include <array>
#include <cstdint>

namespace treeline::digits {

/// A finite number other than zero: a whole number of 168 bits, of which the highest is set, in
/// three limbs, the lowest first, times 2^(exponent - 167).
struct Binary168 {
  std::array<std::uint64_t, 3> limbs{};
  std::int64_t exponent = 0;
  bool negative = false;
};

/// Farther apart than this, `add` does not take exponents.
constexpr std::int64_t kFarthest = 160;

// Both are there where the compiler has integers of 128 bits.

/// a b, rounded to nearest, ties to even.
Binary168 multiply(const Binary168& a, const Binary168& b);
/// a + b, rounded likewise; false where it is zero. Exponents are at most `kFarthest` apart.
bool add(const Binary168& a, const Binary168& b, Binary168& sum);

}  // namespace treeline::digits
