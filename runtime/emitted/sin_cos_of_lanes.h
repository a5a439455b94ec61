#pragma once
// Sines and cosines of as many angles as there are lanes.

TL_INLINE void tl_sin_cos(const real* x, real* sine, real* cosine) {
  const TlAngle angles = *(const TlRow*)x;
  TlAngle sines;
  TlAngle cosines;
  tl_sin_cos_steps(&angles, &sines, &cosines);
  *(TlRow*)sine = sines;
  *(TlRow*)cosine = cosines;
}
