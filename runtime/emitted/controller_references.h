#pragma once
// References of a controller: quintic splines to goals, stretched where limits of
// speed ask for it.

#include "controller_measurement.h"
#include "quintic.h"

/// Reference of the joints at this step.
TL_INLINE void tl_joint_reference(
    const TlConfig* config, const TlState* state, real* p, real* v, real* a) {
  const real time = tl_seconds(state->joint_ticks, config->period);
  const real left = tl_share_left(time, state->joint_rate);
  tl_quintic_at(TL_JOINTS, &state->joint_motion[0], left, state->joint_rate, p, v, a);
}

/// The duration, and as much longer as keeps a motion over `way` within its limit of
/// speed, which it reaches within `rise` seconds at the soonest. `way` is a share of
/// the limit times a second, `speed` the share of it that the motion begins with.
/// From rest a quintic is fastest at 15/8 of its mean, and its acceleration is
/// largest at 10/sqrt(3) way / duration^2; from a speed v that of a stop is 4 v /
/// duration.
TL_INLINE real tl_stretch(real duration, real way, real speed, real rise) {
  const real by_speed = TL_REAL(1.875) * way * (TL_ONE + (TL_REAL(0.8) * speed));
  const real by_rise = tl_square_root(TL_REAL(5.7735) * way * rise);
  const real by_stop = TL_REAL(4.0) * speed * rise;
  return tl_larger(tl_larger(tl_larger(duration, by_speed), by_rise), by_stop);
}

/// Whether the duration is at least a step, and at most an hour, up to which time can
/// be counted.
TL_INLINE bool tl_is_duration(real duration, real period) {
  return (duration >= period) && (duration <= TL_REAL(3600.0));
}

/// Whether a motion of the joints stays within their limits on its way, at 15 places
/// of it. From rest it does; in the midst of a motion it may swing out.
TL_INLINE bool tl_stays_within(
    const TlConfig* config, const real* motion, const real* from, real rate) {
  bool within = true;
  for (int32_t k = 1; k < 16; ++k) {
    const real left = TL_REAL(0.0625) * TL_AS_REAL(k);
    real p[TL_JOINTS];
    real v[TL_JOINTS];
    real a[TL_JOINTS];
    tl_quintic_at(TL_JOINTS, motion, left, rate, &p[0], &v[0], &a[0]);
    for (int32_t i = 0; i < TL_JOINTS; ++i) {
      const real margin = TL_REAL(0.5) * config->position_margin;
      const real most =
          (TL_ONE + (TL_REAL(0.5) * config->speed_margin)) * config->speed[i];
      within = within &&
          ((p[i] <= (config->upper[i] + margin)) || (p[i] <= from[i])) &&
          ((p[i] >= (config->lower[i] - margin)) || (p[i] >= from[i])) &&
          (tl_magnitude(v[i]) <= most);
    }
  }
  return within;
}

/// Leads the joints from a state to rest in `goal`. The motion takes `duration`, and
/// as much longer as keeps it within the limits of speed. Joints that turn without
/// end go the short way round. Returns whether there is such a motion; where there is
/// none the old one goes on.
TL_INLINE bool tl_move_joints(const TlConfig* config, const real* p, const real* v,
    const real* a, const real* goal, real duration, TlState* state) {
  real end[TL_JOINTS];
  real longest = TL_ZERO;
  real fastest = TL_ZERO;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real way = tl_way_to(i, p[i], goal[i]);
    end[i] = TL_TURNS[i] ? (p[i] + way) : goal[i];
    longest = tl_larger(tl_magnitude(way) / config->speed[i], longest);
    fastest = tl_larger(tl_magnitude(v[i]) / config->speed[i], fastest);
  }
  const real taken = tl_stretch(duration, longest, fastest, config->speed_rise);
  const real rate = TL_ONE / taken;
  real motion[4 * TL_JOINTS];
  tl_quintic_to_rest(TL_JOINTS, p, v, a, &end[0], taken, &motion[0]);
  const bool possible = tl_is_duration(taken, config->period) &&
      ((!(fastest > TL_ZERO)) || tl_stays_within(config, &motion[0], p, rate));
  if (possible) {
    tl_copy_numbers(&motion[0], 4 * TL_JOINTS, &state->joint_motion[0]);
    state->joint_rate = rate;
    state->joint_ticks = 0;
  }
  return possible;
}

/// Begins to hold the joints where they are.
TL_INLINE void tl_start_holding(
    const TlConfig* config, const TlInput* input, TlState* state) {
  real rest[TL_JOINTS];
  tl_clear_numbers(TL_JOINTS, &rest[0]);
  state->law = TL_JOINT_LAW;
  state->braking = 0;
  (void)tl_move_joints(
      config, &input->q[0], &rest[0], &rest[0], &input->q[0], config->period, state);
}
