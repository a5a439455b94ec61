#pragma once
// Sines and cosines of the angles of one state, in groups side by side.
//
// - tl_fours_sin_cos, tl_eights_sin_cos: the same of four and of eight angles
// - TL_ANGLES_AT_ONCE: 8 where a register holds as many, else 4

/// Sines and cosines of several angles. Of many, the last eight take some a second
/// time: a remainder would make the code long. Of few, two or three that remain are
/// padded.
TL_INLINE void tl_sin_cos(int32_t count, const real* x, real* sine, real* cosine) {
  int32_t done = 0;
  if (TL_ANGLES_AT_ONCE == 8) {
    done = (count > 16) ? count : count - (count % 8);
    for (int32_t i = 0; i < done; i += 8) {
      const int32_t at = (i + 8 <= count) ? i : count - 8;
      tl_eights_sin_cos(&x[at], &sine[at], &cosine[at]);
    }
  }
  const int32_t whole = (done < count) ? count - (count % 4) : count;
  for (int32_t i = done; i < whole; i += 4) {
    tl_fours_sin_cos(&x[i], &sine[i], &cosine[i]);
  }
  const int32_t left = count - whole;
  if (left == 1) {
    tl_sin_cos_of(x[whole], &sine[whole], &cosine[whole]);
  } else if (left > 1) {
    const real angles[4] = {x[whole], x[whole + 1], x[count - 1], x[whole]};
    real sines[4];
    real cosines[4];
    tl_fours_sin_cos(angles, sines, cosines);
    sine[whole] = sines[0];
    cosine[whole] = cosines[0];
    sine[whole + 1] = sines[1];
    cosine[whole + 1] = cosines[1];
    if (left == 3) {
      sine[whole + 2] = sines[2];
      cosine[whole + 2] = cosines[2];
    }
  }
}
