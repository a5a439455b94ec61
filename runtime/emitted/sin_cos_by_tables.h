#pragma once
// The steps of sine and cosine without bits of numbers: comparisons and tables.
// Within the range the bits are those that quarter_turns.h gives.

#include "angle_format.h"

/// Turns sine and cosine of the remainder by quarter turns, -2 to 2: `place` counts
/// from 0.
TL_INLINE void tl_turn_by_quarters(
    int32_t place, real sine, real cosine, real* sine_of_x, real* cosine_of_x) {
  static const int32_t odd[5] = {0, 1, 0, 1, 0};
  static const real sine_signs[5] = {-TL_ONE, -TL_ONE, TL_ONE, TL_ONE, -TL_ONE};
  static const real cosine_signs[5] = {-TL_ONE, TL_ONE, TL_ONE, -TL_ONE, -TL_ONE};
  const real both[2] = {sine, cosine};
  *sine_of_x = sine_signs[place] * both[odd[place]];
  *cosine_of_x = cosine_signs[place] * both[1 - odd[place]];
}

/// By comparisons and tables, without bits of numbers. Within the range the bits are
/// those of the plain profile.
TL_INLINE void tl_sin_cos_steps(
    const real* angle, real* sine_of_x, real* cosine_of_x) {
  const real rounding_shift = TL_ROUNDING_SHIFT;
  const real two_over_pi = TL_TWO_OVER_PI;
  const real largest_angle = TL_LARGEST_ANGLE;
  // 1 within the range, else 0. As a factor it makes infinities and NaN into NaN and
  // keeps everything finite within the polynomials' range.
  const real not_above = (*angle <= largest_angle) ? TL_ONE : TL_ZERO;
  const real one_or_zero = (*angle >= -largest_angle) ? not_above : TL_ZERO;
  const real x = *angle * one_or_zero;
  // The nearest multiple of pi/2: a number next to the shift is an integer.
  const real turns = ((x * two_over_pi) + rounding_shift) - rounding_shift;
  real r;
  real tail;
  real sine;
  real cosine;
  tl_subtract_quarters(&x, &turns, &r, &tail);
  tl_sin_cos_remainder(&r, &tail, &sine, &cosine);
  // Quarter turns beyond whole turns: -2 to 2, from 0 on as places of the tables.
  const real whole = ((turns * TL_FOURTH) + rounding_shift) - rounding_shift;
  const real left = turns - (TL_FOUR * whole);
  const real shifted = left + TL_TWO;
  const real from_first = (one_or_zero > TL_ZERO) ? shifted : TL_TWO;
  const int32_t place = TL_AS_INDEX(from_first);
  tl_turn_by_quarters(place, sine, cosine, sine_of_x, cosine_of_x);
}
