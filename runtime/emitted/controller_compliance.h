#pragma once
// Compliance of a controller: springs and dampers in N m/rad and N/m about the pose
// where it was told to comply; without springs the robot is led by hand.
//
//   tau = g + K (p - q) - D qd - c M qd + sum J^T (K e - D xd)
//
// The damping c M, by inertias, is one that a sampled law can have however light a
// joint is. No motion is compensated, so the robot is passive: it gives back no more
// than it was given. (Of orientations this holds where the three stiffnesses of a
// point are equal.)

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
    const TlMeasured* at, const TlState* state, TlJointsOut tau) {
  real against[6 * TL_POINTS];
  for (int32_t point = 0; point < TL_POINTS; ++point) {
    TlPointMotion wanted;
    TlPointMotion now;
    real error[6];
    tl_compare_point(config, at, state, point, &wanted, &now, &error[0]);
    for (int32_t i = 0; i < 6; ++i) {
      const int32_t row = (6 * point) + i;
      against[row] = (config->point_viscosity[row] * now.velocity[i]) -
          (config->point_stiffness[row] * error[i]);
    }
  }
  tl_add_push_torque(input, state, at, against, tau);
}
#endif

/// Torque of a robot that complies.
TL_INLINE void tl_compliant_torque(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, const TlState* state, TlJointsOut tau) {
  TlMeasured still;  // as far as tl_joint_torque reads it: a copy would call memcpy
  real qdd[TL_JOINTS];
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    still.q[i] = at->q[i] + TL_ZERO;
    still.sin_q[i] = at->sin_q[i] + TL_ZERO;
    still.cos_q[i] = at->cos_q[i] + TL_ZERO;
    still.qd[i] = TL_ZERO * at->qd[i];
    qdd[i] = -config->comply_damping * at->qd[i];
  }
  tl_joint_torque(input, state, &still, qdd, tau);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real way = tl_way_to(i, at->q[i], state->joint_motion[i]);
    tau[i] += (config->joint_stiffness[i] * way) -
        (config->joint_viscosity[i] * at->qd[i]) +
        tl_guard_range(config, at->q[i], i);
  }
#if TL_FORCE
  tl_add_point_springs(config, input, at, state, tau);
#endif
}
