#pragma once
// Sine and cosine together, without branch or library. Every operation is one IEEE
// operation in round-to-nearest, and the order of operations matters: compile without
// -ffast-math. Products and sums may be fused or not.

#include <stdint.h>

/// Sine and cosine of x radians. Errors are at most 0.8 ulp up to TL_ACCURATE_ANGLE;
/// beyond 2^TL_LARGEST_EXPONENT they are 0, 1 or -1. NaN and infinities give NaN.
TL_INLINE void tl_sin_cos_of(real x, real* sine, real* cosine) {
  tl_sin_cos_steps(&x, sine, cosine);
}

/// Sines and cosines of several angles.
TL_INLINE void tl_sin_cos(int32_t count, const real* x, real* sine, real* cosine) {
  for (int32_t i = 0; i < count; ++i) {
    tl_sin_cos_of(x[i], &sine[i], &cosine[i]);
  }
}
