#pragma once
// The steps of sine and cosine in double.

#include "quarter_turns.h"
#include "remainder_in_double.h"

TL_INLINE void tl_sin_cos_steps(const TlAngle* x, TlAngle* sine, TlAngle* cosine) {
  TlAngle one_or_zero;
  TlAngle turns;
  TlAngle r;
  TlAngle tail;
  TlAngleBits quarter;
  TlAngle s;
  TlAngle c;
  tl_within_range(x, &one_or_zero);
  tl_nearest_quarter(x, &turns, &quarter);
  tl_subtract_quarters(x, &turns, &r, &tail);
  r *= one_or_zero;
  tail *= one_or_zero;
  tl_sin_cos_remainder(&r, &tail, &s, &c);
  tl_rotate_by_quarters(&quarter, &s, &c);
  *sine = s;
  *cosine = c;
}
