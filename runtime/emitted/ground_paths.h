#pragma once
// The velocities that move a link: those of the path from the root to it.

#include "ground_motion.h"

/// Velocity `k` of the path that ends with `tip`, counted from the root.
TL_INLINE int32_t tl_on_path(int32_t tip, int32_t k) {
  const int32_t at = TL_GROUND_FACTOR_AT[tip];
  return ((at + k) < TL_GROUND_FACTOR_AT[tip + 1]) ? TL_GROUND_BEFORE[at + k] : tip;
}

/// How many velocities a path has.
TL_INLINE int32_t tl_path_length(int32_t tip) {
  return (TL_GROUND_FACTOR_AT[tip + 1] - TL_GROUND_FACTOR_AT[tip]) + 1;
}

/// Adds the velocity w x arm + v of a motion [v; w], times `speed`, to x.
TL_INLINE void tl_add_motion(
    const real* motion, const real* arm, real speed, real* x) {
  const real* const w = &motion[3];
  x[0] += speed * (motion[0] + ((w[1] * arm[2]) - (w[2] * arm[1])));
  x[1] += speed * (motion[1] + ((w[2] * arm[0]) - (w[0] * arm[2])));
  x[2] += speed * (motion[2] + ((w[0] * arm[1]) - (w[1] * arm[0])));
}

/// The motion of a group, at the origin of TlGroundPose: linear, angular.
TL_FUNCTION void tl_twist_of(
    const TlGroundPose* at, const real* qd, int32_t group, real* twist) {
  const int32_t tip = TL_GROUND_TIPS[group];
  for (int32_t i = 0; i < 6; ++i) {
    twist[i] = TL_ZERO;
  }
  for (int32_t k = 0; k < tl_path_length(tip); ++k) {
    const int32_t velocity = tl_on_path(tip, k);
    for (int32_t i = 0; i < 6; ++i) {
      twist[i] += at->motion[(6 * velocity) + i] * qd[velocity];
    }
  }
}
