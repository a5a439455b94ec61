#pragma once
// The steps of sine and cosine in float.

#include "quarter_turns.h"
#include "remainder_in_float.h"

TL_INLINE void tl_sin_cos_steps(const TlAngle* x, TlAngle* sine, TlAngle* cosine) {
  TlAngle one_or_zero;
  TlAngle turns;
  TlAngle r;
  TlAngle excess;
  TlAngleBits quarter;
  TlAngle s;
  TlAngle c;
  tl_within_range(x, &one_or_zero);
  const TlAngle angle = *x * one_or_zero;
  tl_nearest_quarter(&angle, &turns, &quarter);
  tl_subtract_quarters(&angle, &turns, &r, &excess);
  tl_sin_cos_remainder(&r, &excess, &s, &c);
  tl_rotate_by_quarters(&quarter, &s, &c);
  *sine = s;
  *cosine = c;
}
