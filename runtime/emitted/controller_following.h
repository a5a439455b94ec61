#pragma once
// How far references are left behind.

#include "controller_faults.h"
#include "controller_laws.h"
#include "controller_waiting.h"

/// Whether all joints are near their reference.
TL_INLINE bool tl_joints_follow(
    const TlConfig* config, const TlState* state, const TlOutput* output) {
  const real time = tl_seconds(state->joint_ticks, config->period);
  const real most = tl_admitted_error(config, time, state->joint_rate);
  bool follow = true;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    follow = follow && (tl_magnitude(output->joint_error[i]) <= most);
  }
  return follow;
}

#if TL_TASK
/// Whether a number of a point's error counts, world axes: that of a row, or where
/// rows have the point's own axes, of three of them.
TL_INLINE bool tl_is_compared(int32_t point, int32_t row) {
  return TL_OWN_AXES[point] ? tl_is_whole(row) : TL_CONTROLS[row];
}

/// How far a point is from its reference, m or rad: the largest number of its error.
/// Where the point presses its position is free.
TL_INLINE real tl_point_away(
    int32_t point, const TlState* state, const TlOutput* output) {
  real most = TL_ZERO;
  int32_t part = 0;
#if TL_FORCE
  if (tl_is_pressing(state, point)) {
    part = 3;
  }
#else
  (void)state;
#endif
  for (int32_t i = part; i < 6; ++i) {
    const int32_t row = (6 * point) + i;
    const real error =
        tl_is_compared(point, row) ? tl_magnitude(output->task_error[row]) : TL_ZERO;
    most = (error <= most) ? most : error;  // NaN too
  }
  return most;
}

/// Whether all points are near their references.
TL_INLINE bool tl_points_follow(
    const TlConfig* config, TlState* state, const TlOutput* output) {
  bool all = true;
  state->away = TL_ZERO;
  for (int32_t point = 0; point < TL_POINTS; ++point) {
#if TL_BEHAVES
    const bool counts = tl_is_done_whole(state, point);
    const real away = counts ? tl_point_away(point, state, output) : TL_ZERO;
#else
    const real away = tl_point_away(point, state, output);
#endif
    const real time = tl_point_time(config, state, point);
    all = all && (away <= tl_admitted_error(config, time, state->point_rate[point]));
    state->away = tl_larger(away, state->away);
  }
  return all;
}
#endif

/// Whether the law's references are followed.
TL_INLINE bool tl_follows(
    const TlConfig* config, TlState* state, const TlOutput* output) {
#if TL_TASK
  const bool by_points = state->law == TL_TASK_LAW;
  const bool points = by_points && tl_points_follow(config, state, output);
  return points || ((!by_points) && tl_joints_follow(config, state, output));
#else
  return tl_joints_follow(config, state, output);
#endif
}
