#pragma once
// What becomes of references that the robot cannot follow: those of points slow down,
// and are given up where nothing leads there; what stays behind for other reasons is
// a fault.

#include "controller_following.h"

#if TL_TASK
/// The speed of the joint that is nearest to its limit, as a share of it, in twelve
/// steps from now if it goes on rising: on the way into a singularity it does.
TL_INLINE real tl_speed_ahead(
    const TlConfig* config, const TlMeasured* at, TlState* state) {
  real fastest = TL_ZERO;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    fastest = tl_larger(tl_magnitude(at->qd[i]) / config->speed[i], fastest);
  }
  const real rises = fastest - state->fastest;
  state->fastest += TL_REAL(0.25) * rises;
  const real more = TL_REAL(3.0) * rises;
  return fastest + ((rises > TL_ZERO) ? more : TL_ZERO);
}

/// Slows the points' references down where a joint is faster than two fifths of its
/// limit, or a point stays behind.
TL_INLINE void tl_set_pace(const TlConfig* config, real ahead, TlState* state) {
  const real asked = tl_larger(
      tl_behind(config, state->away), TL_REAL(2.5) * (ahead - TL_REAL(0.4)));
  for (int32_t point = 0; point < TL_POINTS; ++point) {
    const real next = tl_slow_down(config, asked, state->point_slow[point]);
    state->point_slow_rate[point] =
        (next - state->point_slow[point]) / config->period;
    state->point_slow[point] = next;
  }
}

/// Whether a joint could not be stopped within its range any more, from which it is
/// moving away.
TL_INLINE bool tl_meets_limit(const TlConfig* config, const TlMeasured* at) {
  const real duration = tl_stop_duration(config, at);
  bool meets = false;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real onward = tl_magnitude(tl_stop_way(duration, at->qd[i]));
    const real slack = TL_REAL(0.5) * config->position_margin;
    meets = meets || (onward > (tl_room_ahead(config, at, i) + slack));
  }
  return meets;
}

/// Whether motors have been at their limits for thirty milliseconds while a point is
/// away from its reference by more than a tenth of `following`.
TL_INLINE bool tl_lacks_torque(const TlConfig* config, TlState* state) {
  const bool lacks =
      (state->cut != 0) && (state->away > (TL_REAL(0.1) * config->following));
  state->cut_ticks = tl_count_tick(lacks ? state->cut_ticks : 0);
  return tl_seconds(state->cut_ticks, config->period) > TL_REAL(0.03);
}

/// Whether the references have waited too long since a point is away from its own.
TL_INLINE bool tl_is_stuck(const TlConfig* config, TlState* state) {
  bool waits = true;
  bool ended = true;
  for (int32_t point = 0; point < TL_POINTS; ++point) {
    const real time = tl_point_time(config, state, point);
#if TL_BEHAVES
    const bool counts = tl_is_done_whole(state, point);
    waits = waits && ((!counts) || tl_is_waiting(state->point_slow[point]));
    ended = ended && ((!counts) || ((time * state->point_rate[point]) >= TL_ONE));
#else
    waits = waits && tl_is_waiting(state->point_slow[point]);
    ended = ended && ((time * state->point_rate[point]) >= TL_ONE);
#endif
  }
  state->stuck_ticks = tl_count_tick((waits && (!ended)) ? state->stuck_ticks : 0);
  return tl_has_waited(config, state->stuck_ticks);
}

#if TL_FORCE
/// Whether the point that presses has lost what it pressed: after half of the force
/// was there, less than a tenth of it is left for twenty milliseconds.
TL_INLINE bool tl_loses_contact(
    const TlConfig* config, const TlInput* input, TlState* state) {
  real measured = TL_ZERO;
  for (int32_t i = 0; i < 3; ++i) {
    measured += state->direction[i] * input->force[i];
  }
  const real wanted = tl_magnitude(state->press_force);
  const real borne = (state->press_force < TL_ZERO) ? -measured : measured;
  const bool bears = borne > (TL_REAL(0.5) * wanted);
  if ((!bears) && (borne < (TL_REAL(0.1) * wanted)) && (state->contact_ticks > 0)) {
    state->contact_ticks = tl_count_tick(state->contact_ticks);
  } else {
    state->contact_ticks = tl_flag(bears || (state->contact_ticks > 0));
  }
  return (state->pressing != 0) &&
      (tl_seconds(state->contact_ticks, config->period) > TL_REAL(0.02));
}
#endif

/// Why the points' motion cannot go on, if it cannot; `stuck` where something blocks
/// them, which is a fault. Nothing blocks a robot that waits since its joints are
/// fast.
TL_INLINE int32_t tl_find_unmet(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, bool* stuck) {
  const real ahead = tl_speed_ahead(config, at, state);
  tl_set_pace(config, ahead, state);
  int32_t why = TL_UNMET_NONE;
  *stuck = tl_is_stuck(config, state);
  if (tl_lacks_torque(config, state)) {
    why = TL_UNMET_TORQUE;
  }
  if ((ahead > TL_REAL(0.85)) || ((*stuck) && (ahead > TL_REAL(0.4)))) {
    why = TL_UNMET_REACH;
  }
  if (tl_meets_limit(config, at)) {
    why = TL_UNMET_LIMIT;
  }
#if TL_FORCE
  if (tl_loses_contact(config, input, state)) {
    why = TL_UNMET_CONTACT;
  }
#else
  (void)input;
#endif
  return why;
}

/// Sees to it that points follow their references, or gives their motion up: then the
/// joints come to rest and hold. Returns whether it did. A robot that is stuck on the
/// way is a fault: something blocks it.
TL_INLINE bool tl_tend_task(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state) {
  bool stuck = false;
  const int32_t why = tl_find_unmet(config, input, at, state, &stuck);
  const bool gives_up = why != TL_UNMET_NONE;
  if (gives_up) {
    state->unmet = why;
    tl_stop_joints(config, at, state);
  } else if (stuck) {
    tl_raise_fault(TL_FAULT_FOLLOWING, state);
  } else {
    // The motion goes on.
  }
  return gives_up;
}
#endif
