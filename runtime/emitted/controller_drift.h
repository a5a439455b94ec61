#pragma once
// Coordinates compared with their velocities.

#include "controller_faults.h"

/// Adds to each joint's drift how far q moved in a step otherwise than by the mean of
/// both velocities. Old drift fades within a tenth of a second. All that was measured
/// is finite.
TL_INLINE void tl_add_drift(const TlConfig* config, const TlMeasured* at,
    const TlInput* input, TlState* state) {
  const real fading = TL_TEN * config->period;
  const real kept = tl_larger(TL_ONE - fading, TL_ZERO);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real moved = tl_way_to(i, state->sound_q[i], input->q[i]);
    const real told =
        TL_REAL(0.5) * config->period * (state->sound_qd[i] + at->qd[i]);
    const real apart = moved - told;
    const real more = (state->posed != 0) ? apart : TL_ZERO;
    state->drift[i] =
        tl_within((kept * state->drift[i]) + more, TL_REAL(2.0) * config->jump);
  }
}

/// Whether a coordinate moves otherwise than its velocity says: it jumped, or one of
/// both is frozen.
TL_INLINE bool tl_drifts(const TlConfig* config, const TlState* state) {
  bool all = true;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    all = all && (tl_magnitude(state->drift[i]) <= config->jump);
  }
  return !all;
}
