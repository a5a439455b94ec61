#pragma once
// Compliance of a controller: springs and dampers in N m/rad and N/m about the pose
// where it was told to comply, or about one that moves; without springs the robot is
// led by hand.
//
//   tau = g + K (p - q) + (D + c M) (v - qd) + sum J^T (K e + D (v - xd))
//
// for references p, v, which stand until they are led. D of a joint is its viscosity
// and 2 ratio sqrt(K M_ii), of which M_ii is found anew every TL_JOINTS steps.
// The damping c M, by inertias, is one that a sampled law can have however light a
// joint is. Near the ends of ranges and limits of speed joints are damped more. No
// motion is compensated, so the robot is passive: it gives back no more than it was
// given, and than what leads the references gives. (Of orientations this holds where
// the three stiffnesses of a point are equal.)

#include "controller_braking.h"
#include "controller_laws.h"

/// How deep a joint is in the end of its range, which begins `hold_reach` before a
/// limit: a share of `hold_reach`, at most 1, negative at the upper end.
TL_INLINE real tl_depth_at_end(const TlConfig* config, real q, int32_t i) {
  const real reach = config->hold_reach;
  const real above = q - (config->upper[i] - reach);
  const real below = (config->lower[i] + reach) - q;
  const real up = tl_larger(above, TL_ZERO) / reach;
  const real down = tl_larger(below, TL_ZERO) / reach;
  return tl_within(down, TL_ONE) - tl_within(up, TL_ONE);
}

/// Torque that turns a joint back at the ends of its range: a damped spring of
/// `hold_frequency` for the joint's inertia, as far as the motor can be firm. One
/// that does not know how light a joint is would throw it back.
TL_INLINE real tl_guard_range(
    const TlConfig* config, const TlState* state, const TlMeasured* at, int32_t i) {
  const real depth = tl_depth_at_end(config, at->q[i], i);
  const real w = config->hold_frequency;
  const real back = w * config->hold_reach * depth;
  const real slower = TL_REAL(2.0) * tl_magnitude(depth) * at->qd[i];
  return tl_within(
      state->inertia[i] * w * (back - slower), tl_firm_torque(config, i, TL_ONE));
}

/// The speed of a joint as a share of what it may have: its limit, and what lets it
/// stop before the end of its range to which it moves, see tl_stop_way.
TL_INLINE real tl_share_of_speed(
    const TlConfig* config, const TlMeasured* at, int32_t i) {
  const real speed = tl_magnitude(at->qd[i]);
  const real room = tl_room_ahead(config, at, i);
  const real way = TL_REAL(0.72) * config->speed_rise * speed * speed;
  const real by_limit = speed / config->speed[i];
  const real by_range = (way < (config->speed[i] * room))
      ? tl_square_root(way / (config->speed[i] * room))
      : TL_ONE;
  return tl_larger(by_limit, by_range);
}

/// Damping, 1/s, of a robot one of whose joints nears its limit of speed or too
/// quickly the end of its range: from 0 at half of what it may have to
/// `hold_frequency`. Nothing else slows joints down that are pushed, or that
/// references lead which do not compensate the motion. So other laws can take over at
/// any time. It rises within 0.1 s of a switch: motors cannot follow at once, and
/// light joints would be thrown by those that do.
TL_INLINE real tl_guard_speed(
    const TlConfig* config, const TlMeasured* at, const TlState* state) {
  real fastest = TL_ZERO;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    fastest = tl_larger(tl_share_of_speed(config, at, i), fastest);
  }
  const real share = tl_within((TL_REAL(2.0) * fastest) - TL_ONE, TL_ONE);
  const real left =
      tl_share_left(tl_seconds(state->fade_ticks, config->period), TL_TEN);
  const real most = (TL_ONE - tl_fade_out(left)) * config->hold_frequency;
  return tl_larger(share, TL_ZERO) * most;
}

#if TL_FORCE
/// Adds springs and dampers of the points.
TL_INLINE void tl_add_point_springs(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, TlJointsOut tau) {
  real against[6 * TL_POINTS];
  for (int32_t point = 0; point < TL_POINTS; ++point) {
    TlPointMotion wanted;
    TlPointMotion now;
    real error[6];
    tl_compare_point(config, at, state, point, &wanted, &now, &error[0]);
    for (int32_t i = 0; i < 6; ++i) {
      const int32_t row = (6 * point) + i;
      against[row] =
          (config->point_viscosity[row] * (now.velocity[i] - wanted.velocity[i])) -
          (config->point_stiffness[row] * error[i]);
    }
    state->point_ticks[point] = tl_count_tick(state->point_ticks[point]);
  }
  tl_add_push_torque(input, state, at, against, tau);
}
#endif

/// Finds M_ii of one joint after the other, where its damping is told as a ratio or
/// it is at an end of its range: what the torque of accelerations `qdd` grows by with
/// 1 rad/s^2 or m/s^2 of this joint.
TL_INLINE void tl_find_inertia(const TlConfig* config, const TlInput* input,
    const TlMeasured* still, TlJointsOut qdd, TlJointsIn tau, TlState* state) {
  const int32_t i = state->inertia_joint;
  const real depth = tl_depth_at_end(config, still->q[i], i);
  if ((config->joint_damping_ratio[i] > TL_ZERO) || (tl_magnitude(depth) > TL_ZERO)) {
    real grown[TL_JOINTS];
    qdd[i] += TL_ONE;
    tl_joint_torque(input, state, still, qdd, grown);
    const real inertia = grown[i] - tau[i];
    state->inertia[i] = tl_larger(inertia, TL_ZERO);
  }
  const int32_t next = i + 1;
  state->inertia_joint = (next < TL_JOINTS) ? next : 0;
}

/// Viscosity of a joint with what its ratio asks for.
TL_INLINE real tl_joint_viscosity(
    const TlConfig* config, const TlState* state, int32_t i) {
  const real product = config->joint_stiffness[i] * state->inertia[i];
  return config->joint_viscosity[i] +
      (TL_REAL(2.0) * config->joint_damping_ratio[i] * tl_square_root(product));
}

/// Torque of a robot that complies.
TL_INLINE void tl_compliant_torque(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, TlJointsOut tau) {
  TlMeasured still;  // as far as tl_joint_torque reads it: a copy would call memcpy
  real p[TL_JOINTS];
  real v[TL_JOINTS];
  real qdd[TL_JOINTS];
  tl_joint_reference(config, state, &p[0], &v[0], &qdd[0]);
  const real guard = tl_guard_speed(config, at, state);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    still.q[i] = at->q[i] + TL_ZERO;
    still.sin_q[i] = at->sin_q[i] + TL_ZERO;
    still.cos_q[i] = at->cos_q[i] + TL_ZERO;
    still.qd[i] = TL_ZERO * at->qd[i];
    qdd[i] = (config->comply_damping * (v[i] - at->qd[i])) - (guard * at->qd[i]);
  }
  tl_joint_torque(input, state, &still, qdd, tau);
  tl_find_inertia(config, input, &still, qdd, tau, state);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real way = tl_way_to(i, at->q[i], p[i]);
    tau[i] += (config->joint_stiffness[i] * way) +
        (tl_joint_viscosity(config, state, i) * (v[i] - at->qd[i])) +
        tl_guard_range(config, state, at, i);
  }
  state->joint_ticks = tl_count_tick(state->joint_ticks);
#if TL_FORCE
  tl_add_point_springs(config, input, at, state, tau);
#endif
}
