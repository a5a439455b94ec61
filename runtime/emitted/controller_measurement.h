#pragma once
// What was measured, made fit to compute with: numbers that are lost are put together
// from those that are left.

#include "controller_safety.h"

/// Fills in a joint's state, of which `at` has the velocity. A lost velocity is the
/// difference of two coordinates, within the limit of speed; a lost coordinate is the
/// last one, moved on by the velocity; where both are lost, the joint is taken to
/// stand where it last was.
TL_INLINE void tl_complete_joint(const TlConfig* config, const TlInput* input,
    int32_t i, const TlState* state, TlMeasured* at) {
  const bool has_q = tl_is_number(input->q[i]);
  const bool has_qd = tl_is_number(at->qd[i]);
  at->lost[i] = (!has_q) && (!has_qd);
  at->qd[i] = has_qd ? at->qd[i] : TL_ZERO;
  if (has_q && (!has_qd) && (state->posed != 0)) {
    const real moved = tl_way_to(i, state->sound_q[i], input->q[i]);
    at->qd[i] = tl_within(moved / config->period, config->speed[i]);
  }
  const real onward = config->period * tl_within(at->qd[i], config->speed[i]);
  at->q[i] = has_q ? input->q[i] : (state->sound_q[i] + onward);
}

/// Fills in the state to compute with, of which `at` has the velocities: what was
/// measured, where all of it was `seen`.
/// Returns whether there is one: every coordinate, and what describes the robot, has
/// been told, now or before.
TL_INLINE bool tl_complete_state(const TlConfig* config, const TlInput* input,
    bool seen, TlState* state, TlMeasured* at) {
  const bool known = seen || (state->posed != 0) ||
      (tl_are_numbers(&input->q[0], TL_JOINTS) && tl_inputs_are_numbers(input));
  if (known) {
    bool lost = false;
    for (int32_t i = 0; i < TL_JOINTS; ++i) {
      if (seen) {
        at->lost[i] = false;
        at->q[i] = input->q[i];
      } else {
        tl_complete_joint(config, input, i, state, at);
      }
      lost = lost || at->lost[i];
      state->sound_q[i] = at->q[i];
      state->sound_qd[i] = at->qd[i];
    }
    tl_adopt(config, input, state);
    state->posed = 1;
    state->blind_ticks = lost ? state->blind_ticks : 0;
    tl_measure(input, state, at);
  }
  return known;
}

/// How far a joint may still go as it moves now.
TL_INLINE real tl_room_ahead(
    const TlConfig* config, const TlMeasured* at, int32_t i) {
  return (at->qd[i] > TL_ZERO) ? (config->upper[i] - at->q[i])
                               : (at->q[i] - config->lower[i]);
}
