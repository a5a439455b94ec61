#pragma once
// Faults of a controller, limits of what was measured, saturation.

#include "controller_safety.h"

TL_INLINE void tl_raise_fault(uint32_t faults, TlState* state) {
  state->reason = (state->faults == 0U) ? faults : state->reason;
  state->faults |= faults;
  state->mode = TL_FAULTED;
}

/// How far a coordinate is beyond its limits, rad or m; negative within them.
TL_INLINE real tl_beyond_limits(
    const TlConfig* config, const TlInput* input, int32_t i) {
  const real above = input->q[i] - config->upper[i];
  const real below = config->lower[i] - input->q[i];
  return tl_larger(above, below);
}

/// The faults of what was measured, which is finite. A joint that was beyond its
/// limit at a reset may stay there and be led back: what is admitted shrinks with it.
TL_INLINE uint32_t tl_check_motion(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state) {
  uint32_t faults = 0U;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real beyond = tl_beyond_limits(config, input, i);
    if (!(beyond <= (config->position_margin + state->admitted[i]))) {
      faults |= TL_FAULT_POSITION;
    }
    const real now = (beyond > TL_ZERO) ? beyond : TL_ZERO;
    state->admitted[i] = tl_smaller(state->admitted[i], now);
    const real most = config->speed[i] * (TL_ONE + config->speed_margin);
    if (!(tl_magnitude(at->qd[i]) <= most)) {
      faults |= TL_FAULT_SPEED;
    }
  }
  return faults;
}

/// Lets joints be where they are, however far beyond their limits.
TL_INLINE void tl_admit(
    const TlConfig* config, const TlInput* input, TlState* state) {
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real beyond = tl_beyond_limits(config, input, i);
    state->admitted[i] = (beyond > TL_ZERO) ? beyond : TL_ZERO;
  }
}

/// Brings tau within its limits and returns the factor that was needed, 1 for none.
/// By `scale` what exceeds the torque that holds the robot against gravity, `held`,
/// is shortened as a whole: its direction is kept and the robot stays held. By
/// `clamp` each torque is cut by itself, and the factor is that of the torque that
/// lost most.
TL_INLINE real tl_saturate(const TlConfig* config, TlJointsIn held, TlJointsOut tau) {
  real factor = TL_ONE;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real most = (tau[i] < held[i]) ? -config->torque[i] : config->torque[i];
    const real room = most - held[i];
    const real asked = tau[i] - held[i];
    if (tl_magnitude(asked) > tl_magnitude(room)) {
      const real share = room / asked;
      factor = tl_smaller(share, factor);
    }
  }
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    if ((config->saturation == TL_SCALE) && (factor < TL_ONE)) {
      tau[i] = held[i] + (factor * (tau[i] - held[i]));
    }
    tau[i] = tl_within(tau[i], config->torque[i]);
  }
  return factor;
}
