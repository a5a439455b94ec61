#pragma once
// Square root without bits of numbers, builtin or library: correctly rounded, so that
// results have the bits of square_root.h.

#include <stdbool.h>
#include <stdint.h>

/// Brings a positive finite number into 1 to 4 by a power of four; what its root is
/// to be multiplied by goes to `scale`. Every product is exact.
TL_INLINE void tl_bring_near_one(real x, real* reduced, real* scale) {
  // Powers of four, and their roots. Twice the first, as the smallest numbers need.
  static const real powers[TL_POWER_COUNT] = {TL_POWERS};
  static const real inverse_powers[TL_POWER_COUNT] = {TL_INVERSE_POWERS};
  static const real roots[TL_POWER_COUNT] = {TL_ROOTS};
  static const real inverse_roots[TL_POWER_COUNT] = {TL_INVERSE_ROOTS};
  real value = x;
  real factor = TL_ONE;
  for (int32_t i = 0; i < TL_POWER_COUNT; ++i) {
    const bool is_large = value >= powers[i];
    const bool is_small = value < (TL_FOUR * inverse_powers[i]);
    const real raising = is_small ? powers[i] : TL_ONE;
    const real lowering = is_small ? inverse_roots[i] : TL_ONE;
    value = value * (is_large ? inverse_powers[i] : raising);
    factor = factor * (is_large ? roots[i] : lowering);
  }
  *reduced = value;
  *scale = factor;
}

/// The root of a number from 1 to 4, correctly rounded: Heron's steps, whose last
/// digit integers decide. It is never a tie.
TL_INLINE real tl_root_near_one(real x) {
  const real third = TL_THIRD;
  const real unit = TL_UNIT;
  const real inverse_unit = TL_INVERSE_UNIT;
  const uint64_t negative = 0x8000000000000000U;  // from here on negative differences
  const uint64_t one = 1U;
  // (x + 2) / 3 is within 6 %; each step halves the square of the relative error.
  real guess = (x + TL_TWO) * third;
  for (int32_t i = 0; i < TL_HERON_STEPS; ++i) {
    guess = TL_HALF * (guess + (x / guess));
  }
  const real units_of_square = x * unit;
  const real units_of_guess = guess * unit;
  const TlBits square = TL_AS_BITS(units_of_square);
  const TlBits candidate = TL_AS_BITS(units_of_guess);
  // It is the root rounded if the square, in units of the candidate's, is between
  // (candidate - 1/2)^2 and (candidate + 1/2)^2, or next to it.
  const uint64_t wide_square = square;
  const uint64_t wide = candidate;
  const uint64_t rest =
      ((wide_square << TL_FRACTION_BITS) - (wide * (wide - one))) - one;
  const bool is_high = rest >= negative;
  const bool is_low = rest >= (wide + wide);
  const TlBits lower = candidate - 1U;
  const TlBits higher = candidate + 1U;
  const TlBits not_high = is_low ? higher : candidate;
  const TlBits root = is_high ? lower : not_high;
  return TL_AS_REAL(root) * inverse_unit;
}

/// Square root of x, correctly rounded; 0 for what rounding has made negative.
TL_INLINE real tl_root(real x) {
  const real largest = TL_LARGEST;
  const real positive = (x > TL_ZERO) ? x : TL_ZERO;
  const bool is_usual = (positive > TL_ZERO) && (positive <= largest);
  real reduced = TL_ONE;
  real scale = TL_ONE;
  tl_bring_near_one(is_usual ? positive : TL_ONE, &reduced, &scale);
  const real found = tl_root_near_one(reduced) * scale;
  return is_usual ? found : positive;
}
