#pragma once
// What keeps a controller within its limits: checks of what was measured, torque and
// its rate within limits.

#include "controller_numbers.h"
#include "controller_robot.h"

/// How far coordinate i is from `from` to `to`, rad or m: the short way round for a
/// joint that turns without end.
TL_INLINE real tl_way_to(int32_t i, real from, real to) {
  return TL_TURNS[i] ? tl_shortest_turn(to - from) : (to - from);
}

/// Brings each torque within its limit, and within what `torque_rate` lets it differ
/// from the last. Returns whether one was cut.
TL_INLINE bool tl_limit_rate(
    const TlConfig* config, TlState* state, TlJointsOut tau) {
  bool cut = false;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real given = tau[i];
    const real asked = tl_within(given, config->torque[i]);
    const real last =
        (state->known != 0) ? tl_within(state->tau[i], config->torque[i]) : asked;
    const real most = config->torque_rate[i] * config->period;
    const real change = asked - last;
    tau[i] =
        (tl_magnitude(change) <= most) ? asked : (last + tl_within(change, most));
    cut = cut || (tl_magnitude(change) > most) ||
        (tl_magnitude(given) > config->torque[i]);
    state->tau[i] = tau[i];
  }
  state->known = 1;
  return cut;
}
