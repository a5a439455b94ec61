#pragma once
// Quintic motion of numbers from any state to rest.

#include <stdint.h>

/// Coefficients of the motion that leaves x0 with velocity v0 and acceleration a0 and
/// is at rest in x1 after `duration` > 0 seconds, as a polynomial in the share u of
/// the time that is left: x = x1 + u^3 (c1 + u (c2 + u c3)). So the end is x1 to the
/// bit, with velocity and acceleration zero. Row-major, a row each of x1, c1, c2, c3.
TL_INLINE void tl_quintic_to_rest(int32_t count, const real* x0, const real* v0,
    const real* a0, const real* x1, real duration, real* coefficients) {
  for (int32_t i = 0; i < count; ++i) {
    const real away = x0[i] - x1[i];
    const real slope = -v0[i] * duration;
    const real bend = a0[i] * duration * duration;
    coefficients[i] = x1[i];
    coefficients[count + i] =
        (TL_TEN * away) - (TL_REAL(4.0) * slope) + (TL_REAL(0.5) * bend);
    coefficients[(2 * count) + i] =
        (TL_REAL(-15.0) * away) + (TL_REAL(7.0) * slope) - bend;
    coefficients[(3 * count) + i] =
        (TL_REAL(6.0) * away) - (TL_REAL(3.0) * slope) + (TL_REAL(0.5) * bend);
  }
}

/// The share of a motion's time that is left `time` seconds after its begin, 0 behind
/// its end; `rate` is 1 / duration.
TL_INLINE real tl_share_left(real time, real rate) {
  const real left = TL_ONE - (time * rate);
  const real most = (left < TL_ONE) ? left : TL_ONE;
  return (left > TL_ZERO) ? most : TL_ZERO;
}

/// State of a motion of `tl_quintic_to_rest` where the share `left` of its time is
/// left.
TL_INLINE void tl_quintic_at(int32_t count, const real* coefficients, real left,
    real rate, real* x, real* v, real* a) {
  const real* const c1 = &coefficients[count];
  const real* const c2 = &coefficients[2 * count];
  const real* const c3 = &coefficients[3 * count];
  const real square = left * left;
  for (int32_t i = 0; i < count; ++i) {
    x[i] = coefficients[i] +
        (square * left * (c1[i] + (left * (c2[i] + (left * c3[i])))));
    v[i] = -rate * square *
        ((TL_REAL(3.0) * c1[i]) +
            (left * ((TL_REAL(4.0) * c2[i]) + (left * (TL_REAL(5.0) * c3[i])))));
    a[i] = rate * rate * left *
        ((TL_REAL(6.0) * c1[i]) +
            (left * ((TL_REAL(12.0) * c2[i]) + (left * (TL_REAL(20.0) * c3[i])))));
  }
}

/// 1 where all of the time is left, 0 where none is, with first and second derivative
/// zero at both ends.
TL_INLINE real tl_fade_out(real left) {
  return left * left * left *
      (TL_TEN + (left * (TL_REAL(-15.0) + (left * TL_REAL(6.0)))));
}
