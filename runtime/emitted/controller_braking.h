#pragma once
// The safe state of a controller: the robot is braked along a reference that slows
// down, and then held where that comes to rest.

#include "controller_measurement.h"

/// Begins to brake from the present motion.
TL_INLINE void tl_start_braking(
    const TlConfig* config, const TlMeasured* at, TlState* state) {
  state->braking = 1;
  state->brake_share = TL_ZERO;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    state->brake_q[i] = at->q[i];
    state->brake_qd[i] = tl_within(at->qd[i], config->speed[i]);
    state->stand_q[i] = at->q[i];
    state->load[i] = TL_ZERO;
    state->softness[i] = TL_ZERO;
    state->swing[i] = TL_ZERO;
    state->swing_peak[i] = TL_ZERO;
    state->last_peak[i] = TL_ZERO;
    state->swing_ticks[i] = 0;
  }
}

/// Lets the braking begin gently: its share of `brake_damping` grows to 1 within
/// twice the time that a torque needs to rise to its limit, and half as fast while
/// torques are cut. Of joints that turn about one axis the one whose torque comes
/// late would be thrown forward by the others'.
TL_INLINE real tl_grow_braking(const TlConfig* config, TlState* state) {
  real slowest = config->torque_rate[0] / config->torque[0];
  for (int32_t i = 1; i < TL_JOINTS; ++i) {
    const real rate = config->torque_rate[i] / config->torque[i];
    slowest = tl_smaller(rate, slowest);
  }
  const real growth = (state->cut != 0) ? TL_REAL(0.25) : TL_REAL(0.5);
  const real share = state->brake_share + (growth * slowest * config->period);
  state->brake_share = tl_smaller(share, TL_ONE);
  return config->brake_damping * state->brake_share;
}

/// Lets a reference that still moves give way to the joint, within 20 ms, while
/// torques are cut: motors that cannot slow down so fast would be behind it at rest,
/// pull the robot back at their limits, and swing it.
TL_INLINE void tl_give_way(
    const TlConfig* config, const TlMeasured* at, int32_t i, TlState* state) {
  if ((state->cut != 0) && (tl_magnitude(state->brake_qd[i]) > config->rest_speed)) {
    const real give = tl_within(TL_REAL(50.0) * config->period, TL_ONE);
    state->brake_q[i] += give * tl_way_to(i, state->brake_q[i], at->q[i]);
    state->brake_qd[i] += give * (at->qd[i] - state->brake_qd[i]);
  }
}

/// Moves a joint's reference on by one step: it slows down by `damping`, stands at a
/// limit of position, and stays within `hold_reach` of the joint. Returns whether it
/// stands.
TL_INLINE bool tl_move_brake_reference(const TlConfig* config, const TlMeasured* at,
    real damping, int32_t i, TlState* state) {
  const bool stands = tl_magnitude(state->brake_qd[i]) <= config->rest_speed;
  const real before = state->brake_q[i];
  const real slower = TL_ONE - (damping * config->period);
  state->brake_qd[i] = stands ? TL_ZERO : (slower * state->brake_qd[i]);
  real next = before + (config->period * state->brake_qd[i]);
  if (((next > config->upper[i]) && (next > before)) ||
      ((next < config->lower[i]) && (next < before))) {
    next = before;
    state->brake_qd[i] = TL_ZERO;
  }
  const real ahead = tl_way_to(i, at->q[i], next);
  const bool beyond = tl_magnitude(ahead) > config->hold_reach;
  state->brake_q[i] =
      beyond ? (at->q[i] + tl_within(ahead, config->hold_reach)) : next;
  state->stand_q[i] = stands ? state->stand_q[i] : state->brake_q[i];
  return stands;
}

/// Acceleration that leads a joint along its reference, critically damped with
/// `hold_frequency`.
TL_INLINE real tl_brake_acceleration(const TlConfig* config, const TlMeasured* at,
    real damping, int32_t i, const TlState* state) {
  const real w = config->hold_frequency;
  const real error = tl_way_to(i, at->q[i], state->brake_q[i]);
  return (w * ((TL_REAL(2.0) * (state->brake_qd[i] - at->qd[i])) + (w * error))) -
      (damping * state->brake_qd[i]);
}

/// Torque of a spring at a share of `hold_reach`: soft near its reference, firm at
/// the reach, up to three fifths of the motor's torque. It bears what the law by
/// inertias cannot, a payload on a light wrist. Where the torque has no limit, beyond
/// 1e6 N m, there is none.
TL_INLINE real tl_firm_torque(const TlConfig* config, int32_t i, real share) {
  const bool is_limited = config->torque[i] < TL_REAL(1000000.0);
  const real most = is_limited ? (TL_REAL(0.6) * config->torque[i]) : TL_ZERO;
  return most * share * share * share;
}

/// The share of its firmness that is left to what holds a joint. A joint that is far
/// lighter than its motor would be swung to and fro by it, torque at its limits: each
/// half of a swing within 30 ms that does not fade takes half of the firmness away,
/// until the robot brakes anew. `error` is how much faster the reference is than the
/// joint, rad/s or m/s; below 0.3 it is noise.
TL_INLINE real tl_find_firmness(
    const TlConfig* config, real error, int32_t i, TlState* state) {
  const real size = tl_magnitude(error);
  if ((error * state->swing[i]) < TL_ZERO) {
    const bool quick =
        tl_seconds(state->swing_ticks[i], config->period) < TL_REAL(0.03);
    const bool fades = state->swing_peak[i] < (TL_REAL(0.9) * state->last_peak[i]);
    if (quick && (!fades) && (state->swing_peak[i] > TL_REAL(0.3))) {
      state->softness[i] += TL_REAL(0.5) * (TL_REAL(0.9999) - state->softness[i]);
    }
    state->last_peak[i] = state->swing_peak[i];
    state->swing_peak[i] = TL_ZERO;
    state->swing_ticks[i] = 0;
  }
  state->swing_peak[i] = tl_larger(size, state->swing_peak[i]);
  state->swing[i] = (size > TL_ZERO) ? error : state->swing[i];
  state->swing_ticks[i] = tl_count_tick(state->swing_ticks[i]);
  return TL_ONE - state->softness[i];
}

/// Torque of the firm spring, which damps as it stiffens, and of the load that it has
/// handed over. While the joint stands, the spring hands over what it bears beyond
/// half its reach, within some tenths of a second: the torque stays, and the
/// reference comes near the joint again.
TL_INLINE real tl_hold_torque(const TlConfig* config, const TlMeasured* at, int32_t i,
    bool stands, TlState* state) {
  const real way = tl_way_to(i, at->q[i], state->brake_q[i]);
  const real share = tl_within(way / config->hold_reach, TL_ONE);
  const real damping_time = TL_REAL(0.01);  // s
  const real firmness =
      tl_find_firmness(config, state->brake_qd[i] - at->qd[i], i, state);
  real firm = firmness * tl_firm_torque(config, i, share);
  const real slope = (tl_magnitude(share) > TL_REAL(0.01))
      ? (TL_REAL(3.0) * firm / (share * config->hold_reach))
      : TL_ZERO;
  const real damping =
      tl_within(slope * damping_time * (state->brake_qd[i] - at->qd[i]),
          TL_REAL(0.6) * firmness * config->torque[i]);
  if (stands && (tl_magnitude(share) > TL_REAL(0.5))) {
    const real rate = tl_smaller(TL_TEN * config->period, TL_ONE);
    const real left = share - (rate * (share - tl_within(share, TL_REAL(0.5))));
    const real kept = firmness * tl_firm_torque(config, i, left);
    state->load[i] = tl_within(state->load[i] + (firm - kept), config->torque[i]);
    state->brake_q[i] = at->q[i] + (left * config->hold_reach);
    firm = kept;
  }
  return firm + damping + state->load[i];
}

/// Torque that brakes the robot to rest and holds it there. A joint of which nothing
/// is measured is held against gravity alone, for `blind_ticks` steps. Returns
/// whether a joint that stood was dragged away by more than twice `hold_reach`. NaN
/// where the state was beyond all numbers.
TL_INLINE bool tl_brake_torque(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, TlJointsOut tau) {
  if (state->braking == 0) {
    tl_start_braking(config, at, state);
  }
  const real damping = tl_grow_braking(config, state);
  bool dragged = false;
  bool lost = false;
  const bool lately = state->blind_ticks < config->blind_ticks;
  real qdd[TL_JOINTS];
  real held[TL_JOINTS];
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    lost = lost || at->lost[i];
    if (at->lost[i]) {
      state->brake_q[i] = at->q[i];
      state->brake_qd[i] = TL_ZERO;
      qdd[i] = TL_ZERO;
      held[i] = TL_ZERO;
    } else {
      tl_give_way(config, at, i, state);
      const bool stands = tl_move_brake_reference(config, at, damping, i, state);
      held[i] = tl_hold_torque(config, at, i, stands, state);
      qdd[i] = tl_brake_acceleration(config, at, damping, i, state);
      const real moved = tl_magnitude(tl_way_to(i, state->stand_q[i], at->q[i]));
      dragged = dragged || (moved > (TL_REAL(2.0) * config->hold_reach));
    }
  }
  tl_joint_torque(input, state, at, qdd, tau);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    tau[i] = (at->lost[i] && (!lately)) ? TL_ZERO : (tau[i] + held[i]);
  }
  if (lost && lately) {
    state->blind_ticks += 1;
  }
  return dragged;
}

/// Whether the reference stands, and the robot within its reach, whatever noise
/// velocities have.
TL_INLINE bool tl_rests(
    const TlConfig* config, const TlMeasured* at, const TlState* state) {
  bool rests = true;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real away = tl_magnitude(tl_way_to(i, at->q[i], state->brake_q[i]));
    rests = rests && (tl_magnitude(state->brake_qd[i]) <= config->rest_speed) &&
        (away <= (TL_REAL(0.6) * config->hold_reach)) && (!at->lost[i]);
  }
  return rests;
}
