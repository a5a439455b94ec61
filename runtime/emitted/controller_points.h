#pragma once
// References of points: quintic splines to poses, straight and about one axis from
// rest. Behaviours: from one set of points whose tasks are done to another the share
// of each task moves by a quintic, and the torque with it.

#include "controller_references.h"
#include "turn_motion.h"

#if TL_TASK
/// Desired motion of one point in world axes, linear over angular.
struct TlPointMotion {
  real position[3];
  real rotation[9];
  real velocity[6];
  real acceleration[6];
};
typedef struct TlPointMotion TlPointMotion;

#if TL_FORCE
/// Whether the point exerts a force in place of moving.
TL_INLINE bool tl_is_pressing(const TlState* state, int32_t point) {
  return (state->pressing != 0) && (state->press_point == point);
}
#endif

/// Seconds that all joints take to stop without turning back, by half of their
/// torque.
TL_INLINE real tl_stop_duration(const TlConfig* config, const TlMeasured* at) {
  real duration = config->period;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real least = TL_REAL(1.8) * config->speed_rise * tl_magnitude(at->qd[i]) /
        config->speed[i];
    duration = tl_larger(duration, least);
  }
  return duration;
}

/// How far a joint still goes in a stop whose acceleration begins with zero.
TL_INLINE real tl_stop_way(real duration, real speed) {
  return TL_REAL(0.4) * duration * speed;
}

/// A shorter duration of a stop, down to half of it, where a joint has less room: it
/// goes at least a fifth of speed times duration.
TL_INLINE real tl_stop_within_room(
    const TlConfig* config, const TlMeasured* at, real duration) {
  real taken = duration;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real least = TL_REAL(5.0) * tl_room_ahead(config, at, i);
    const real way = taken * tl_magnitude(at->qd[i]);
    taken = (way > least) ? (least / tl_magnitude(at->qd[i])) : taken;
  }
  return tl_larger(taken, TL_REAL(0.5) * duration);
}

/// Leads the joints from their present motion to rest as soon as they may, without
/// turning back, and within their limits of position: by quintics whose first
/// coefficient is 0.
TL_INLINE void tl_stop_joints(
    const TlConfig* config, const TlMeasured* at, TlState* state) {
  const real duration = tl_stop_within_room(config, at, tl_stop_duration(config, at));
  real slower[TL_JOINTS];
  real end[TL_JOINTS];
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real v = at->qd[i];
    const real room = tl_larger(tl_room_ahead(config, at, i), TL_ZERO);
    const real way = tl_within(tl_stop_way(duration, v), room);
    end[i] = at->q[i] + way;
    slower[i] = tl_within(((TL_REAL(20.0) * way / duration) - (TL_REAL(8.0) * v)),
                    TL_REAL(4.0) * tl_magnitude(v)) /
        duration;
  }
  tl_quintic_to_rest(TL_JOINTS, &at->q[0], &at->qd[0], &slower[0], &end[0], duration,
      &state->joint_motion[0]);
  state->joint_rate = TL_ONE / duration;
  state->joint_ticks = 0;
  state->law = TL_JOINT_LAW;
}

/// Seconds that a point's reference has moved on. Its clock runs slower than that of
/// the steps, and stands, where the robot cannot follow.
TL_INLINE real tl_point_time(
    const TlConfig* config, const TlState* state, int32_t point) {
  return tl_seconds(state->point_ticks[point], config->period) -
      state->point_lag[point];
}

/// Reference of a point at this step.
TL_INLINE void tl_point_reference(const TlConfig* config, const TlState* state,
    int32_t point, TlPointMotion* motion) {
  const real rate = state->point_rate[point];
  const real left = tl_share_left(tl_point_time(config, state, point), rate);
  real x[6];
  real v[6];
  real a[6];
  tl_quintic_at(6, &state->point_motion[24 * point], left, rate, &x[0], &v[0], &a[0]);
  real w[3];
  real wd[3];
  tl_turn_rates(&x[3], &v[3], &a[3], &w[0], &wd[0]);
  real turned[9];
  tl_rotation_from_vector(&x[3], &turned[0]);
  tl_turn_by(&turned[0], &state->point_from[9 * point], &motion->rotation[0]);
  const real pace = TL_ONE - state->point_slow[point];
  const real change = -state->point_slow_rate[point];
  for (int32_t i = 0; i < 3; ++i) {
    motion->position[i] = x[i];
    motion->velocity[i] = pace * v[i];
    motion->velocity[3 + i] = pace * w[i];
    motion->acceleration[i] = (pace * pace * a[i]) + (change * v[i]);
    motion->acceleration[3 + i] = (pace * pace * wd[i]) + (change * w[i]);
  }
}

/// The larger of the lengths of two vectors, as shares of `most` and `most_turn`.
TL_INLINE real tl_larger_share(
    const real* x, real most, const real* turn, real most_turn) {
  const real length = tl_square_root(tl_squared_norm(x)) / most;
  const real angle = tl_square_root(tl_squared_norm(turn)) / most_turn;
  return tl_larger(length, angle);
}

/// Leads a point from a motion to rest in a pose, straight and about one axis if it
/// is at rest. The motion takes `duration`, and as much longer as keeps it within
/// `point_speed` and `point_turn`. Returns whether there is such a motion; where
/// there is none the old one goes on.
TL_INLINE bool tl_move_point(const TlConfig* config, const TlPointMotion* now,
    const real* position, const real* rotation, real duration, int32_t point,
    TlState* state) {
  real way[6];
  real from[6];
  real to[6];
  tl_pose_error(&now->position[0], &now->rotation[0], position, rotation, &way[0]);
  for (int32_t i = 0; i < 3; ++i) {
    from[i] = now->position[i];
    from[3 + i] = TL_ZERO;
    to[i] = position[i];
    to[3 + i] = way[3 + i];
  }
  const real taken = tl_stretch(duration,
      tl_larger_share(&way[0], config->point_speed, &way[3], config->point_turn),
      tl_larger_share(&now->velocity[0], config->point_speed, &now->velocity[3],
          config->point_turn),
      config->speed_rise);
  const bool possible = tl_is_duration(taken, config->period);
  if (possible) {
    tl_quintic_to_rest(6, &from[0], &now->velocity[0], &now->acceleration[0], &to[0],
        taken, &state->point_motion[24 * point]);
    tl_copy_numbers(&now->rotation[0], 9, &state->point_from[9 * point]);
    state->point_rate[point] = TL_ONE / taken;
    state->point_ticks[point] = 0;
    state->point_lag[point] = TL_ZERO;
    state->point_slow[point] = TL_ZERO;
    state->point_slow_rate[point] = TL_ZERO;
  }
  return possible;
}

/// The measured motion of a point, without its acceleration.
TL_INLINE void tl_measured_motion(
    const TlMeasured* at, int32_t point, TlPointMotion* motion) {
  tl_copy_numbers(&at->position[3 * point], 3, &motion->position[0]);
  tl_copy_numbers(&at->rotation[9 * point], 9, &motion->rotation[0]);
  tl_copy_numbers(&at->velocity[6 * point], 6, &motion->velocity[0]);
  tl_clear_numbers(6, &motion->acceleration[0]);
}

/// Begins to hold a point where it is.
TL_INLINE void tl_hold_point(
    const TlConfig* config, const TlMeasured* at, int32_t point, TlState* state) {
  TlPointMotion now;
  tl_measured_motion(at, point, &now);
  tl_clear_numbers(6, &now.velocity[0]);
  (void)tl_move_point(
      config, &now, &now.position[0], &now.rotation[0], config->period, point, state);
}

/// Leads a point from its present motion to rest as soon as the joints may; holds it
/// where it is if it stands.
TL_INLINE void tl_stop_point(
    const TlConfig* config, const TlMeasured* at, int32_t point, TlState* state) {
  const real duration = tl_stop_duration(config, at);
  TlPointMotion now;
  real position[3];
  real turn[3];
  real turned[9];
  real rotation[9];
  tl_measured_motion(at, point, &now);
  for (int32_t i = 0; i < 3; ++i) {
    position[i] = now.position[i] + tl_stop_way(duration, now.velocity[i]);
    turn[i] = tl_stop_way(duration, now.velocity[3 + i]);
  }
  tl_rotation_from_vector(&turn[0], &turned[0]);
  tl_turn_by(&turned[0], &now.rotation[0], &rotation[0]);
  (void)tl_move_point(
      config, &now, &position[0], &rotation[0], duration, point, state);
}

#if TL_BEHAVES
/// Share to which the present behaviour does the task of a point, in the end.
TL_INLINE real tl_wanted_share(
    const TlConfig* config, const TlState* state, int32_t point) {
  const int32_t share = TL_SHARES[point];
  return (share < 0)
      ? TL_ONE
      : config->behaviour_share[(TL_SHARE_COUNT * state->behaviour) + share];
}

/// Whether the task of a point is done whole at present, so that its error counts.
TL_INLINE bool tl_is_done_whole(const TlState* state, int32_t point) {
  const int32_t share = TL_SHARES[point];
  return (share < 0) || (state->active_tasks[share] >= TL_ONE);
}

/// Gives the present behaviour its shares at once: where the law of tasks begins.
TL_INLINE void tl_take_shares(const TlConfig* config, TlState* state) {
  for (int32_t point = 0; point < TL_POINTS; ++point) {
    if (TL_SHARES[point] >= 0) {
      const real share = tl_wanted_share(config, state, point);
      state->share_from[TL_SHARES[point]] = share;
      state->active_tasks[TL_SHARES[point]] = share;
    }
  }
}

/// Moves the shares on by one step. The reference of a point whose task is not done
/// at all is where the point comes to rest, so that it is held there when a behaviour
/// takes it up.
TL_INLINE void tl_lead_shares(
    const TlConfig* config, const TlMeasured* at, TlState* state) {
  const real left = tl_share_left(
      tl_seconds(state->share_ticks, config->period), state->share_rate);
  const real before = tl_fade_out(left);
  for (int32_t point = 0; point < TL_POINTS; ++point) {
    const int32_t share = TL_SHARES[point];
    if (share >= 0) {
      const real wanted = tl_wanted_share(config, state, point);
      state->active_tasks[share] =
          wanted + (before * (state->share_from[share] - wanted));
      if (!(state->active_tasks[share] > TL_ZERO)) {
        tl_stop_point(config, at, point, state);
      }
    }
  }
  state->share_ticks = tl_count_tick(state->share_ticks);
}
#endif
#endif
