#pragma once
// Angular motion of a frame whose rotation vector moves.

#include "orientation.h"

TL_INLINE real tl_dot_of_three(const real* a, const real* b) {
  return (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}

/// sum_k (-x)^k / (2k + first)! and its derivative by x. The series of sine and
/// cosine, whose terms left out are below a rounding of the sum for x <= 12, an angle
/// of 3.4 rad.
TL_INLINE void tl_alternating_series(real x, int32_t first, real* sum, real* slope) {
  real last = TL_ONE;
  for (int32_t k = 2; k <= first; ++k) {
    last /= TL_AS_REAL(k);
  }
  real s = TL_ONE;
  real d = TL_ZERO;
  for (int32_t k = TL_SERIES_TERMS; k > 0; --k) {
    const int32_t factors = ((2 * k) + first - 1) * ((2 * k) + first);
    const real ratio = TL_ONE / TL_AS_REAL(factors);
    d = -ratio * (s + (x * d));
    s = TL_ONE - (ratio * x * s);
  }
  *sum = last * s;
  *slope = last * d;
}

/// Angular velocity w and acceleration wd of the rotation exp([r]x), in the axes in
/// which r is, where r moves with rd and rdd:
///   w = rd + B r x rd + C r x (r x rd),  B = (1 - cos t) / t^2,
///   C = (t - sin t) / t^3,  t = |r|,
/// and its derivative. Along one axis w = rd. For |r| up to 3.4 rad.
TL_INLINE void tl_turn_rates(
    const real* r, const real* rd, const real* rdd, real* w, real* wd) {
  real B;
  real C;
  real dB;
  real dC;
  tl_alternating_series(tl_squared_norm(r), 2, &B, &dB);
  tl_alternating_series(tl_squared_norm(r), 3, &C, &dC);
  const real twice = TL_REAL(2.0) * tl_dot_of_three(r, rd);
  real across[3];
  real twice_across[3];
  real turned[3];
  real twice_turned[3];
  real mixed[3];
  tl_cross(r, rd, &across[0]);
  tl_cross(r, &across[0], &twice_across[0]);
  tl_cross(r, rdd, &turned[0]);
  tl_cross(r, &turned[0], &twice_turned[0]);
  tl_cross(rd, &across[0], &mixed[0]);
  for (int32_t i = 0; i < 3; ++i) {
    w[i] = rd[i] + (B * across[i]) + (C * twice_across[i]);
    wd[i] = rdd[i] + (B * turned[i]) + (C * (twice_turned[i] + mixed[i])) +
        (twice * ((dB * across[i]) + (dC * twice_across[i])));
  }
}

/// A B of row-major rotation matrices.
TL_INLINE void tl_turn_by(const real* A, const real* B, real* product) {
  for (int32_t i = 0; i < 3; ++i) {
    for (int32_t j = 0; j < 3; ++j) {
      product[(3 * i) + j] = (A[3 * i] * B[j]) + (A[(3 * i) + 1] * B[3 + j]) +
          (A[(3 * i) + 2] * B[6 + j]);
    }
  }
}
