#pragma once
// Velocities of a robot that measures its coordinates alone, by an observer of second
// order whose poles both are p = 1 - observer period:
//
//   e = q - (q' + period v'),  q' += period v' + (1 - p^2) e,
//   v' += (1 - p)^2 e / period
//
// Motion of constant speed is found exactly; under an acceleration a what is observed
// is too slow by a (2 / observer - 1.5 period). A count d of an encoder changes it by
// observer^2 period d at once.

#include "controller_measurement.h"

/// The velocities to compute with: those of the input, or where the configuration has
/// an observer those that it finds. A coordinate that jumps says nothing of its
/// velocity; one that is lost leaves it as it was. `drift` then is how far each
/// coordinate is from where the observer expects it.
TL_INLINE void tl_find_velocities(
    const TlConfig* config, const TlInput* input, TlState* state, TlMeasured* at) {
  const bool observes = config->observer > TL_ZERO;
  const real pole = TL_ONE - (config->observer * config->period);
  const real gain = (TL_ONE - pole) * (TL_ONE - pole) / config->period;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const bool has_q = tl_is_number(input->q[i]);
    if (!observes) {
      at->qd[i] = input->qd[i] + TL_ZERO;
      state->observed_q[i] = has_q ? input->q[i] : state->observed_q[i];
    } else if (state->posed == 0) {
      at->qd[i] = TL_ZERO;
      state->observed_q[i] = has_q ? input->q[i] : TL_ZERO;
    } else {
      const real onward =
          state->observed_q[i] + (config->period * state->sound_qd[i]);
      const real apart = has_q ? tl_way_to(i, onward, input->q[i]) : TL_ZERO;
      const bool jumps = !(tl_magnitude(apart) <= config->jump);
      state->drift[i] = tl_within(apart, TL_REAL(2.0) * config->jump);
      at->qd[i] = state->sound_qd[i] + (jumps ? TL_ZERO : (gain * apart));
      state->observed_q[i] =
          has_q ? (input->q[i] - (jumps ? TL_ZERO : (pole * pole * apart))) : onward;
    }
  }
}
