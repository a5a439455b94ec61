#pragma once
// Commands of a controller: what each begins, and which are refused.

#include "controller_drift.h"
#include "controller_laws.h"

/// Counts the steps without a command while running; whether there were too many.
TL_INLINE bool tl_is_stale(const TlConfig* config, TlState* state) {
  state->command_ticks = tl_count_tick(state->command_ticks);
  return (config->stale_ticks > 0) && (state->command_ticks > config->stale_ticks) &&
      (state->mode == TL_RUNNING);
}

/// Joints to a posture by a law, from the reference if it was following one.
TL_INLINE int32_t tl_begin_posture(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, int32_t law, TlState* state) {
  const real* const goal = &input->command.goal[0];
  const real duration = input->command.duration;
  const bool switched = state->law != law;
  bool within = true;
  real p[TL_JOINTS];
  real v[TL_JOINTS];
  real a[TL_JOINTS];
  tl_joint_reference(config, state, &p[0], &v[0], &a[0]);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    p[i] = switched ? at->q[i] : p[i];
    v[i] = switched ? at->qd[i] : v[i];
    a[i] = switched ? TL_ZERO : a[i];
    within = within && (goal[i] >= config->lower[i]) && (goal[i] <= config->upper[i]);
  }
  int32_t refusal = TL_ACCEPTED;
  if (!within) {
    refusal = TL_REFUSED_LIMITS;
  } else if (!tl_is_duration(duration, config->period)) {
    refusal = TL_REFUSED_DURATION;
  } else if (!tl_move_joints(config, &p[0], &v[0], &a[0], goal, duration, state)) {
    refusal = TL_REFUSED_LIMITS;
  } else {
    state->law = law;
  }
  return refusal;
}

#if TL_TASK
/// Whether a vector is of length 1 to a hundredth.
TL_INLINE bool tl_is_unit(real x, real y, real z) {
  return tl_magnitude((x * x) + (y * y) + (z * z) - TL_ONE) < TL_REAL(0.02);
}

/// Whether the rows are of length 1, and each is the cross product of the two others.
TL_INLINE bool tl_is_rotation(const real* R) {
  const real x = (R[1] * R[5]) - (R[2] * R[4]);
  const real y = (R[2] * R[3]) - (R[0] * R[5]);
  const real z = (R[0] * R[4]) - (R[1] * R[3]);
  const real determinant = (x * R[6]) + (y * R[7]) + (z * R[8]);
  return tl_is_unit(R[0], R[1], R[2]) && tl_is_unit(R[3], R[4], R[5]) &&
      (tl_magnitude(determinant - TL_ONE) < TL_REAL(0.03));
}

/// Begins the law of the task, where it is not the law already: all points but `led`,
/// -1 for none, come to rest, the posture is where the joints were led last.
TL_INLINE void tl_enter_task(
    const TlConfig* config, const TlMeasured* at, int32_t led, TlState* state) {
  if (state->law != TL_TASK_LAW) {
    state->law = TL_TASK_LAW;
#if TL_FORCE
    state->pressing = 0;
#endif
    tl_copy_numbers(&state->joint_motion[0], TL_JOINTS, &state->posture[0]);
    for (int32_t point = 0; point < TL_POINTS; ++point) {
      if (point != led) {
        tl_stop_point(config, at, point, state);
      }
    }
#if TL_BEHAVES
    tl_take_shares(config, state);
#endif
  }
}

/// A point to a pose: from its reference, or from where it is if it was not following
/// one. Nothing changes where there is no such motion.
TL_INLINE int32_t tl_begin_pose(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, bool* switched) {
  const TlCommand* const command = &input->command;
  int32_t refusal = TL_REFUSED_DURATION;
  TlPointMotion now;
  bool anew = state->law != TL_TASK_LAW;
#if TL_FORCE
  const bool pressed = (!anew) && tl_is_pressing(state, command->point);
  anew = anew || pressed;
#endif
  if (anew) {
    tl_measured_motion(at, command->point, &now);
  } else {
    tl_point_reference(config, state, command->point, &now);
  }
  if (tl_move_point(config, &now, &command->position[0], &command->rotation[0],
          command->duration, command->point, state)) {
    refusal = TL_ACCEPTED;
    tl_enter_task(config, at, command->point, state);
#if TL_FORCE
    if (pressed) {
      state->pressing = 0;
    }
#endif
    *switched = anew;
  }
  return refusal;
}

/// What of a command for a point makes no sense.
TL_INLINE int32_t tl_check_point(
    const TlConfig* config, const TlCommand* command, const TlState* state) {
  bool sound = true;
  bool weak = true;
#if TL_BEHAVES
#else
  (void)state;
#endif
  if (command->kind != TL_PRESS) {
    sound = tl_are_numbers(&command->position[0], 3) &&
        tl_is_rotation(&command->rotation[0]);
  }
#if TL_FORCE
  if (command->kind == TL_PRESS) {
    const real* const n = &command->direction[0];
    sound = tl_is_unit(n[0], n[1], n[2]);
    weak = tl_magnitude(command->force) <= config->largest_force;
  }
#endif
  int32_t refusal = TL_ACCEPTED;
  if ((command->point < 0) || (command->point >= TL_POINTS)) {
    refusal = TL_REFUSED_POINT;
#if TL_BEHAVES
  } else if ((command->kind != TL_LEAD_POINT) &&
      (tl_wanted_share(config, state, command->point) < TL_ONE)) {
    refusal = TL_REFUSED_BEHAVIOUR;
#endif
  } else if (!tl_is_duration(command->duration, config->period)) {
    refusal = TL_REFUSED_DURATION;
  } else if (!weak) {
    refusal = TL_REFUSED_FORCE;
  } else if (!sound) {
    refusal = TL_REFUSED_NUMBERS;
  } else {
    // It makes sense.
  }
  return refusal;
}
#endif

#if TL_FORCE
/// Lets the reference of the point that presses be where the point got to along its
/// direction, so that nothing leads it back when it presses no more.
TL_INLINE void tl_keep_pressed(
    const TlConfig* config, const TlMeasured* at, TlState* state) {
  const int32_t point = state->press_point;
  TlPointMotion wanted;
  real along = TL_ZERO;
  tl_point_reference(config, state, point, &wanted);
  for (int32_t i = 0; i < 3; ++i) {
    along +=
        state->direction[i] * (at->position[(3 * point) + i] - wanted.position[i]);
  }
  for (int32_t i = 0; i < 3; ++i) {
    state->point_motion[(24 * point) + i] += along * state->direction[i];
  }
}

/// Force along a direction, reached by and by.
TL_INLINE void tl_begin_press(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state) {
  tl_enter_task(config, at, -1, state);
  if (state->pressing != 0) {
    tl_keep_pressed(config, at, state);
  }
  state->pressing = 1;
  state->press_point = input->command.point;
  state->press_force = input->command.force;
  state->press_rate = TL_ONE / input->command.duration;
  state->press_ticks = 0;
  state->force_integral = TL_ZERO;
  state->contact_ticks = 0;
  tl_copy_numbers(&input->command.direction[0], 3, &state->direction[0]);
}
#endif

#if TL_BEHAVES
/// Another behaviour, to which the shares of the tasks move within the duration. A
/// point whose task comes is held where it is; a point whose task goes presses no
/// more.
TL_INLINE int32_t tl_begin_behaviour(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, bool* switched) {
  const TlCommand* const command = &input->command;
  int32_t refusal = TL_ACCEPTED;
  if ((command->point < 0) || (command->point >= TL_BEHAVIOURS)) {
    refusal = TL_REFUSED_BEHAVIOUR;
  } else if (!tl_is_duration(command->duration, config->period)) {
    refusal = TL_REFUSED_DURATION;
  } else {
    *switched = state->law != TL_TASK_LAW;
    state->behaviour = command->point;
    state->share_rate = TL_ONE / command->duration;
    state->share_ticks = 0;
    tl_copy_numbers(&state->active_tasks[0], TL_SHARE_COUNT, &state->share_from[0]);
    tl_enter_task(config, at, -1, state);
#if TL_FORCE
    if ((state->pressing != 0) &&
        (tl_wanted_share(config, state, state->press_point) < TL_ONE)) {
      tl_keep_pressed(config, at, state);
      state->pressing = 0;
      *switched = true;
    }
#endif
  }
  return refusal;
}
#endif

/// Joints and points comply about where they are.
TL_INLINE void tl_begin_compliance(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state) {
  tl_start_holding(config, input, state);
#if TL_TASK
  tl_enter_task(config, at, -1, state);
  for (int32_t point = 0; point < TL_POINTS; ++point) {
    tl_hold_point(config, at, point, state);
  }
#else
  (void)at;
#endif
  state->law = TL_COMPLIANCE_LAW;
  state->fade_ticks = 0;
}

/// Leads what springs pull to, of joints or of a point.
TL_INLINE int32_t tl_begin_leading(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state) {
  int32_t refusal = TL_REFUSED_KIND;
  if (state->law != TL_COMPLIANCE_LAW) {
    refusal = TL_REFUSED_MODE;
  } else if (input->command.kind == TL_LEAD_JOINTS) {
    refusal = tl_begin_posture(config, input, at, TL_COMPLIANCE_LAW, state);
  } else {
#if TL_FORCE
    const TlCommand* const command = &input->command;
    refusal = tl_check_point(config, command, state);
    if (refusal == TL_ACCEPTED) {
      TlPointMotion now;
      tl_point_reference(config, state, command->point, &now);
      refusal = tl_move_point(config, &now, &command->position[0],
                    &command->rotation[0], command->duration, command->point, state)
          ? TL_ACCEPTED
          : TL_REFUSED_DURATION;
    }
#endif
  }
  return refusal;
}

/// Begins a motion, or refuses to. `switched` becomes whether the law becomes
/// another.
TL_INLINE int32_t tl_begin_motion(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, bool* switched) {
  const int32_t kind = input->command.kind;
  int32_t refusal = TL_REFUSED_KIND;
  if (kind == TL_MOVE_JOINTS) {
    const int32_t before = state->law;
    refusal = tl_begin_posture(config, input, at, TL_JOINT_LAW, state);
    *switched = state->law != before;
  }
  if (kind == TL_COMPLY) {
    refusal = TL_ACCEPTED;
    *switched = true;
    tl_begin_compliance(config, input, at, state);
  }
  if ((kind == TL_LEAD_JOINTS) || (kind == TL_LEAD_POINT)) {
    refusal = tl_begin_leading(config, input, at, state);
  }
#if TL_TASK
  if (kind == TL_MOVE_POINT) {
    refusal = tl_check_point(config, &input->command, state);
    if (refusal == TL_ACCEPTED) {
      refusal = tl_begin_pose(config, input, at, state, switched);
    }
  }
#endif
#if TL_FORCE
  if (kind == TL_PRESS) {
    refusal = tl_check_point(config, &input->command, state);
    if (refusal == TL_ACCEPTED) {
      *switched = true;
      tl_begin_press(config, input, at, state);
    }
  }
#endif
#if TL_BEHAVES
  if (kind == TL_BEHAVE) {
    refusal = tl_begin_behaviour(config, input, at, state, switched);
  }
#endif
  return refusal;
}

/// Leaves the mode faulted.
TL_INLINE void tl_leave_faults(
    const TlConfig* config, const TlInput* input, TlState* state) {
  tl_admit(config, input, state);
  tl_clear_numbers(TL_JOINTS, &state->drift[0]);
  state->faults = 0U;
  state->reason = 0U;
  state->mode = TL_IDLE;
}

/// Begins what needs a mode of its own and a measurement.
TL_INLINE int32_t tl_begin(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, bool seen, TlState* state, bool* switched) {
  const int32_t kind = input->command.kind;
  int32_t needed = TL_RUNNING;
  if (kind == TL_RESET) {
    needed = TL_FAULTED;
  }
  if (kind == TL_START) {
    needed = TL_IDLE;
  }
  int32_t refusal = TL_ACCEPTED;
  if (state->mode != needed) {
    refusal = TL_REFUSED_MODE;
  } else if (!seen) {
    refusal = TL_REFUSED_MEASUREMENT;
  } else if (kind == TL_RESET) {
    tl_leave_faults(config, input, state);
  } else if (kind == TL_START) {
    state->mode = TL_RUNNING;
    tl_start_holding(config, input, state);
    *switched = true;
  } else {
    refusal = tl_begin_motion(config, input, at, state, switched);
  }
  return refusal;
}

/// Whether the controller has such commands, in whatever mode.
TL_INLINE bool tl_is_kind(int32_t kind) {
  bool known = ((kind >= TL_EMERGENCY_STOP) && (kind <= TL_START)) ||
      (kind == TL_MOVE_JOINTS) || (kind == TL_KEEP_ALIVE) || (kind == TL_COMPLY) ||
      (kind == TL_LEAD_JOINTS);
#if TL_TASK
  known = known || (kind == TL_MOVE_POINT);
#endif
#if TL_FORCE
  known = known || (kind == TL_PRESS) || (kind == TL_LEAD_POINT);
#endif
#if TL_BEHAVES
  known = known || (kind == TL_BEHAVE);
#endif
  return known;
}

/// Commands of the loop: `seen` says whether the state was measured. `switched`
/// becomes whether the law becomes another.
TL_INLINE int32_t tl_apply_command(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, bool seen, TlState* state, bool* switched) {
  const int32_t kind = input->command.kind;
  int32_t refusal = TL_ACCEPTED;
  if (!tl_is_kind(kind)) {
    refusal = TL_REFUSED_KIND;
  } else if (kind == TL_EMERGENCY_STOP) {
    tl_raise_fault(TL_FAULT_EMERGENCY, state);
  } else if ((kind == TL_DISCONNECT) || (kind == TL_STOP)) {
    if (state->mode == TL_RUNNING) {
      state->mode = TL_STOPPING;
    }
  } else if (kind != TL_KEEP_ALIVE) {
    refusal = tl_begin(config, input, at, seen, state, switched);
  } else {
    // It only tells that whoever commands is there.
  }
  return refusal;
}

/// Takes the command if it is a new one. Returns whether the law becomes another.
TL_INLINE bool tl_take_command(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, bool seen, TlState* state, TlOutput* output) {
  bool switched = false;
  if (input->command.sequence != state->sequence) {
    state->sequence = input->command.sequence;
    state->command_ticks = 0;
    output->refused = tl_apply_command(config, input, at, seen, state, &switched);
#if TL_TASK
    const bool moves = input->command.kind != TL_KEEP_ALIVE;
    if (moves && (output->refused == TL_ACCEPTED)) {
      state->unmet = TL_UNMET_NONE;
    }
#endif
  }
  return switched;
}
