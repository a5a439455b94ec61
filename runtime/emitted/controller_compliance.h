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
// joint is. No motion is compensated, so the robot is passive: it gives back no more
// than it was given, and than what leads the references gives. (Of orientations this
// holds where the three stiffnesses of a point are equal.)

#include "controller_braking.h"
#include "controller_laws.h"

/// Torque that turns a joint back at the ends of its range: a spring that begins
/// `hold_reach` before them.
TL_INLINE real tl_guard_range(const TlConfig* config, real q, int32_t i) {
  const real above = q - (config->upper[i] - config->hold_reach);
  const real below = (config->lower[i] + config->hold_reach) - q;
  const real up = (above > TL_ZERO) ? (above / config->hold_reach) : TL_ZERO;
  const real down = (below > TL_ZERO) ? (below / config->hold_reach) : TL_ZERO;
  return tl_firm_torque(config, i, tl_within(down, TL_ONE)) -
      tl_firm_torque(config, i, tl_within(up, TL_ONE));
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

/// Finds M_ii of one joint after the other, where its damping is told as a ratio:
/// what the torque of accelerations `qdd` grows by with 1 rad/s^2 or m/s^2 of this
/// joint.
TL_INLINE void tl_find_inertia(const TlConfig* config, const TlInput* input,
    const TlMeasured* still, TlJointsOut qdd, TlJointsIn tau, TlState* state) {
  const int32_t i = state->inertia_joint;
  if (config->joint_damping_ratio[i] > TL_ZERO) {
    real grown[TL_JOINTS];
    qdd[i] += TL_ONE;
    tl_joint_torque(input, state, still, qdd, grown);
    const real inertia = grown[i] - tau[i];
    state->inertia[i] = (inertia > TL_ZERO) ? inertia : TL_ZERO;
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
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    still.q[i] = at->q[i] + TL_ZERO;
    still.sin_q[i] = at->sin_q[i] + TL_ZERO;
    still.cos_q[i] = at->cos_q[i] + TL_ZERO;
    still.qd[i] = TL_ZERO * at->qd[i];
    qdd[i] = config->comply_damping * (v[i] - at->qd[i]);
  }
  tl_joint_torque(input, state, &still, qdd, tau);
  tl_find_inertia(config, input, &still, qdd, tau, state);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real way = tl_way_to(i, at->q[i], p[i]);
    tau[i] += (config->joint_stiffness[i] * way) +
        (tl_joint_viscosity(config, state, i) * (v[i] - at->qd[i])) +
        tl_guard_range(config, at->q[i], i);
  }
  state->joint_ticks = tl_count_tick(state->joint_ticks);
#if TL_FORCE
  tl_add_point_springs(config, input, at, state, tau);
#endif
}
