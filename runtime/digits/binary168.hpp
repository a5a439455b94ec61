#pragma once

#include <array>
#include <bit>
#include <cstddef>
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

// Both functions exist if the compiler has integers of 128 bits. They are inline, so that limbs
// stay in registers: passing them through memory takes as long as the arithmetic.

/// a b, rounded to nearest, ties to even.
Binary168 multiply(const Binary168& a, const Binary168& b);
/// Computes a + b, rounded to nearest, ties to even. Returns false if the sum is zero. The
/// exponents may differ by at most `kFarthest`.
bool add(const Binary168& a, const Binary168& b, Binary168& sum);

#if defined(__SIZEOF_INT128__)

__extension__ using Wide = unsigned __int128;

constexpr int kLimb = 64;
constexpr int kTop = 168 - 2 * kLimb;  ///< number of bits of the highest limb

/// Rounds up if what was cut off exceeds half of the last bit, or equals half and the number is
/// odd.
inline void round(Binary168& x, bool half, bool more) {
  if (!half || (!more && (x.limbs[0] & 1U) == 0)) return;
  if (++x.limbs[0] != 0 || ++x.limbs[1] != 0) return;
  if (++x.limbs[2] >> kTop == 0) return;
  x.limbs[2] >>= 1;  // all other bits are zero
  ++x.exponent;
}

/// Four limbs, the lowest first. Below the number's 168 bits there are 64 guard bits.
using Guarded = std::array<std::uint64_t, 4>;

/// Shifts limbs to the right. If bits are lost, the last bit is set.
[[gnu::always_inline]] inline Guarded shifted_right(const std::array<std::uint64_t, 3>& limbs,
                                                    std::int64_t by) {
  Guarded from{0, limbs[0], limbs[1], limbs[2]}, to{};
  const auto whole = static_cast<std::size_t>(by / kLimb);
  const int part = static_cast<int>(by % kLimb);
  std::uint64_t lost = 0;
  for (std::size_t i = 0; i < whole; ++i) lost |= from[i];
  if (part > 0) lost |= from[whole] << (kLimb - part);
  for (std::size_t i = whole; i < from.size(); ++i) {
    to[i - whole] = from[i] >> part;
    if (part > 0 && i + 1 < from.size()) to[i - whole] |= from[i + 1] << (kLimb - part);
  }
  to[0] |= lost != 0 ? 1U : 0U;
  return to;
}

[[gnu::always_inline]] inline Guarded added(const Guarded& a, const Guarded& b) {
  Guarded sum{};
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const Wide both = Wide{a[i]} + b[i] + carry;
    sum[i] = static_cast<std::uint64_t>(both);
    carry = static_cast<std::uint64_t>(both >> kLimb);
  }
  return sum;
}

/// a - b, which must not be negative.
[[gnu::always_inline]] inline Guarded subtracted(const Guarded& a, const Guarded& b) {
  Guarded difference{};
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < difference.size(); ++i) {
    const Wide both = Wide{a[i]} - b[i] - borrow;
    difference[i] = static_cast<std::uint64_t>(both);
    borrow = static_cast<std::uint64_t>(both >> kLimb) != 0 ? 1 : 0;
  }
  return difference;
}

/// Index of the highest limb that is not zero; -1 if there is none.
inline int highest_limb(const Guarded& x) {
  int i = 3;
  while (i >= 0 && x[static_cast<std::size_t>(i)] == 0) --i;
  return i;
}

inline Guarded shifted_left(const Guarded& from, int by) {
  Guarded to{};
  const int whole = by / kLimb;
  const int part = by % kLimb;
  for (int i = 3; i >= whole; --i) {
    const auto at = static_cast<std::size_t>(i);
    const auto source = static_cast<std::size_t>(i - whole);
    to[at] = from[source] << part;
    if (part > 0 && source > 0) to[at] |= from[source - 1] >> (kLimb - part);
  }
  return to;
}

/// Makes the number with the bits `x`, including the guard bits.
[[gnu::always_inline]] inline Binary168 normalized(Guarded x, std::int64_t exponent,
                                                   bool negative) {
  const int high = highest_limb(x);
  const int bits =
      high * kLimb + static_cast<int>(std::bit_width(x[static_cast<std::size_t>(high)]));
  constexpr int kAll = 168 + kLimb;
  if (bits > kAll) {  // carry; the bit pushed out is below the deciding one
    const std::uint64_t lost = x[0] & 1U;
    for (std::size_t i = 0; i < 3; ++i) x[i] = x[i] >> 1 | x[i + 1] << (kLimb - 1);
    x[3] >>= 1;
    x[0] |= lost;
  } else if (bits < kAll) {
    x = shifted_left(x, kAll - bits);
  }
  Binary168 result{{x[1], x[2], x[3]}, exponent + bits - kAll, negative};
  constexpr std::uint64_t kHalf = std::uint64_t{1} << (kLimb - 1);
  round(result, (x[0] & kHalf) != 0, (x[0] & ~kHalf) != 0);
  return result;
}

inline bool is_smaller(const Binary168& a, const Binary168& b) {
  if (a.exponent != b.exponent) return a.exponent < b.exponent;
  for (std::size_t i = 3; i-- > 0;) {
    if (a.limbs[i] != b.limbs[i]) return a.limbs[i] < b.limbs[i];
  }
  return false;
}

[[gnu::always_inline]] inline Binary168 multiply(const Binary168& a, const Binary168& b) {
  std::array<std::uint64_t, 6> product{};
  for (std::size_t i = 0; i < 3; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const Wide sum = Wide{a.limbs[i]} * b.limbs[j] + product[i + j] + carry;
      product[i + j] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> kLimb);
    }
    product[i + 3] = carry;
  }
  const bool is_long = product[5] >> (2 * kTop - kLimb - 1) != 0;  // 336 bits instead of 335
  const int cut = is_long ? kTop : kTop - 1;                       // bits of the third limb
  Binary168 result{{}, a.exponent + b.exponent + (is_long ? 1 : 0), a.negative != b.negative};
  for (std::size_t i = 0; i < 3; ++i) {
    result.limbs[i] = product[i + 2] >> cut | product[i + 3] << (kLimb - cut);
  }
  const std::uint64_t half = std::uint64_t{1} << (cut - 1);
  const bool more = (product[2] & (half - 1)) != 0 || product[1] != 0 || product[0] != 0;
  round(result, (product[2] & half) != 0, more);
  return result;
}

inline bool add(const Binary168& a, const Binary168& b, Binary168& sum) {
  if (is_smaller(a, b)) return add(b, a, sum);
  const Guarded first{0, a.limbs[0], a.limbs[1], a.limbs[2]};
  const Guarded second = shifted_right(b.limbs, a.exponent - b.exponent);
  const Guarded total = a.negative == b.negative ? added(first, second) : subtracted(first, second);
  if (highest_limb(total) < 0) return false;
  sum = normalized(total, a.exponent, a.negative);
  return true;
}

#endif

}  // namespace treeline::digits
