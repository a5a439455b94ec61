#pragma once
// Sine and cosine of what quarter turns leave of an angle, in double.

#include "angle_format.h"

/// x - turns pi/2 as r + tail. pi/2 is split in three parts of 26 bits and one of 53:
/// for |turns| < 2^27 the products with the first three are exact, and so are the
/// first two differences (Cody and Waite); what the third loses to rounding goes to
/// `tail`, from which the fourth is taken. Left over: turns * 2^-134, and the
/// rounding of `tail`.
TL_INLINE void tl_subtract_quarters(
    const TlAngle* x, const TlAngle* turns, TlAngle* r, TlAngle* tail) {
  const double kPart1 = 0x1.921fb5p+0;
  const double kPart2 = 0x1.110b46p-26;
  const double kPart3 = 0x1.1a6263p-54;
  const double kPart4 = 0x1.8a2e03707344ap-81;
  const TlAngle rough = (*x - (*turns * kPart1)) - (*turns * kPart2);
  const TlAngle third = *turns * kPart3;
  const TlAngle rest = rough - third;
  *r = rest;
  *tail = ((rough - rest) - third) - (*turns * kPart4);
}

/// Sine and cosine of r + tail, |r| <= pi/4, |tail| of the order of r's rounding.
/// Minimax polynomials in r^2: relative error of the sine 2^-57.9, absolute of the
/// cosine 2^-64. The leading terms r and 1 - r^2/2 are added last and the rounding
/// error of the latter is restored, as in Sun's fdlibm.
TL_INLINE void tl_sin_cos_remainder(
    const TlAngle* r, const TlAngle* tail, TlAngle* sine, TlAngle* cosine) {
  const double kS1 = -0x1.5555555555548p-3;
  const double kS2 = 0x1.111111110f764p-7;
  const double kS3 = -0x1.a01a019bf35dbp-13;
  const double kS4 = 0x1.71de35603d30ep-19;
  const double kS5 = -0x1.ae5e557756731p-26;
  const double kS6 = 0x1.5d8e8400477c8p-33;
  const double kC1 = 0x1.555555555554cp-5;
  const double kC2 = -0x1.6c16c16c1521fp-10;
  const double kC3 = 0x1.a01a019cbf626p-16;
  const double kC4 = -0x1.27e4f812b61f6p-22;
  const double kC5 = 0x1.1ee9f15241a81p-29;
  const double kC6 = -0x1.8fb130c6d769dp-37;
  const TlAngle z = *r * *r;
  const TlAngle w = z * z;
  const TlAngle v = z * *r;
  const TlAngle s = ((z * kS3) + kS2) + (w * (((z * kS5) + kS4) + (w * kS6)));
  *sine = *r - (((z * ((*tail * 0.5) - (v * s))) - *tail) - (v * kS1));
  const TlAngle c =
      z * (((z * kC2) + kC1) + (w * (((z * kC4) + kC3) + (w * ((z * kC6) + kC5)))));
  const TlAngle halved = z * 0.5;
  const TlAngle leading = 1.0 - halved;
  *cosine = leading + (((1.0 - leading) - halved) + ((z * c) - (*r * *tail)));
}
