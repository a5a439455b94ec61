#pragma once
// Sine and cosine of what quarter turns leave of an angle, in float.

#include "angle_format.h"

/// x - turns pi/2 as r - excess. pi/2 is split in parts of 12, 13, 11 and 24 bits:
/// for |turns| <= 2^11 the products with the first three are exact, and so is the
/// first difference. The first parts happen to miss pi/2 by 2^-17.8, 2^-33.9 and
/// 2^-47.4 only. Left over: turns * 2^-72, and the rounding of `excess`, which next
/// to a multiple of pi/2 is 2^-58.
TL_INLINE void tl_subtract_quarters(
    const TlAngle* x, const TlAngle* turns, TlAngle* r, TlAngle* excess) {
  const float kPart1 = 0x1.922p+0F;
  const float kPart2 = -0x1.2afp-18F;
  const float kPart3 = 0x1.0b4p-34F;
  const float kPart4 = 0x1.84698ap-48F;
  const TlAngle rough = *x - (*turns * kPart1);
  const TlAngle second = *turns * kPart2;
  const TlAngle third = *turns * kPart3;
  const TlAngle rest = second + third;
  const TlAngle left = rough - rest;
  *r = left;
  *excess = ((third - (rest - second)) + (*turns * kPart4)) - ((rough - left) - rest);
}

/// Sine and cosine of r - excess, |r| <= pi/4: relative error of the sine's
/// polynomial 2^-27.8, absolute of the cosine's 2^-33.1; leading terms are added
/// last.
TL_INLINE void tl_sin_cos_remainder(
    const TlAngle* r, const TlAngle* excess, TlAngle* sine, TlAngle* cosine) {
  const float kS1 = 0x1.555544p-3F;
  const float kS2 = -0x1.1106d6p-7F;
  const float kS3 = 0x1.992462p-13F;
  const float kC1 = 0x1.55554ap-5F;
  const float kC2 = -0x1.6c0c24p-10F;
  const float kC3 = 0x1.99e5cap-16F;
  const TlAngle z = *r * *r;
  const TlAngle halved = z * 0.5F;
  const TlAngle leading = 1.0F - halved;
  const TlAngle s = (((z * kS3) + kS2) * z) + kS1;
  *sine = *r - ((*excess * leading) + ((z * *r) * s));
  const TlAngle c = (((z * kC3) + kC2) * z) + kC1;
  *cosine =
      leading + (((1.0F - leading) - halved) + (((z * z) * c) + (*r * *excess)));
}
