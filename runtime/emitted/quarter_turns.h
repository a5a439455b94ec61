#pragma once
// Angles and quarter turns by the bits of numbers: of one angle, or of several where
// the types are vectors. Passed by reference only: the calling convention of vectors
// depends on the target's flags.

#include "angle_format.h"

/// 1 where |x| is within the range, else 0. As a factor it makes infinities and NaN
/// into NaN and keeps everything finite within the polynomials' range. Integers
/// compare as the magnitudes do.
TL_INLINE void tl_within_range(const TlAngle* x, TlAngle* one_or_zero) {
  const TlBits zero = 0;
  const TlBits one = 1;
  const TlBits bias = TL_BIAS;
  const TlBits exponent = TL_LARGEST_EXPONENT;
  const TlBits largest = (bias + exponent) << TL_FRACTION_BITS;
  TlAngleBits bits;
  tl_to_bits(x, &bits);
  bits &= ~(one << TL_SIGN_AT);
  bits -= largest + one;  // negative, if it could be, within the range
  bits = (zero - (bits >> TL_SIGN_AT)) & (bias << TL_FRACTION_BITS);
  tl_from_bits(&bits, one_or_zero);
}

/// The nearest multiple of pi/2 to x: `turns` quarter turns, the low bits of
/// `quarter` in two's complement.
TL_INLINE void tl_nearest_quarter(
    const TlAngle* x, TlAngle* turns, TlAngleBits* quarter) {
  const real two_over_pi = TL_TWO_OVER_PI;
  // A number next to it is an integer, so adding it rounds to the nearest integer,
  // whose low bits can be read off, and subtracting it gives the integer back.
  const real rounding_shift = TL_ROUNDING_SHIFT;
  const TlAngle shifted = (*x * two_over_pi) + rounding_shift;
  *turns = shifted - rounding_shift;
  tl_to_bits(&shifted, quarter);
}

/// Turns sine and cosine of the remainder into those of the angle: swaps them after
/// an odd number of quarter turns and sets their signs.
TL_INLINE void tl_rotate_by_quarters(
    const TlAngleBits* quarter, TlAngle* sine, TlAngle* cosine) {
  const TlBits zero = 0;
  const TlBits one = 1;
  const TlBits sign = one << TL_SIGN_AT;
  TlAngleBits s;
  TlAngleBits c;
  tl_to_bits(sine, &s);
  tl_to_bits(cosine, &c);
  const TlAngleBits odd = zero - (*quarter & one);
  const TlAngleBits difference = (s ^ c) & odd;
  s ^= difference ^ ((*quarter << (TL_SIGN_AT - 1U)) & sign);
  c ^= difference ^ (((*quarter + one) << (TL_SIGN_AT - 1U)) & sign);
  tl_from_bits(&s, sine);
  tl_from_bits(&c, cosine);
}
