#pragma once
// One step of a controller: faults, commands, modes, the law's torque, saturation,
// and the torque of the safe state. It keeps no state but what it is given.

#include "controller_commands.h"
#include "controller_compliance.h"
#include "controller_config.h"
#include "controller_observer.h"
#include "controller_pace.h"

/// How the law of a step takes over from that of the step before: what it lacks of
/// the old torque fades; or at once, where the old torque is not trusted any more.
struct TlSwitch {
  bool fades;
  bool at_once;
};
typedef struct TlSwitch TlSwitch;

TL_INLINE void tl_law_torque(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, TlOutput* output, TlJointsOut tau) {
  if (state->law == TL_COMPLIANCE_LAW) {
    tl_compliant_torque(config, input, at, state, tau);
#if TL_TASK
  } else if (state->law == TL_TASK_LAW) {
    tl_task_law(config, input, at, state, output, tau);
#endif
  } else {
    real qdd[TL_JOINTS];
    tl_joint_law(config, at, state, output, qdd);
    tl_joint_torque(input, state, at, qdd, tau);
  }
}

/// Adds what a switch of laws has left over: the torque has no step at the switch,
/// and what it lacks there fades.
TL_INLINE void tl_fade_switch(
    const TlConfig* config, TlSwitch how, TlState* state, TlJointsOut tau) {
  const real rate = (config->fade > TL_ZERO) ? (TL_ONE / config->fade) : TL_ZERO;
  if (how.fades || how.at_once) {
    const bool fades = (!how.at_once) && (rate > TL_ZERO) && (state->known != 0);
    state->fade_ticks = 0;
    for (int32_t i = 0; i < TL_JOINTS; ++i) {
      state->left_over[i] = fades ? (state->tau[i] - tau[i]) : TL_ZERO;
    }
  }
  const real left =
      tl_share_left(tl_seconds(state->fade_ticks, config->period), rate);
  const real share = tl_fade_out(left);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    tau[i] += share * state->left_over[i];
  }
  state->fade_ticks = tl_count_tick(state->fade_ticks);
}

/// Torque that brakes. A robot that was stopping and rests becomes idle.
TL_INLINE void tl_stop_torque(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, TlJointsOut tau) {
  const bool begins = state->braking == 0;
  if (tl_brake_torque(config, input, at, state, tau)) {
    tl_raise_fault(TL_FAULT_MOVED, state);
  }
  const bool by_command = (state->faults & (~TL_FAULT_EMERGENCY)) == 0U;
  const TlSwitch how = {begins && by_command, begins && (!by_command)};
  tl_fade_switch(config, how, state, tau);
  if ((state->mode == TL_STOPPING) && tl_rests(config, at, state)) {
    state->mode = TL_IDLE;
  }
}

/// Torque of the mode. Where the law's is not finite, or its reference is not
/// followed, the mode becomes faulted, and brakes.
TL_INLINE void tl_mode_torque(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlSwitch how, TlState* state, TlOutput* output,
    TlJointsOut tau) {
  bool runs = state->mode == TL_RUNNING;
  if (runs) {
    tl_law_torque(config, input, at, state, output, tau);
    tl_fade_switch(config, how, state, tau);
    const bool finite = tl_are_numbers(&tau[0], TL_JOINTS);
    runs = finite;
    if (!finite) {
      tl_raise_fault(TL_FAULT_TORQUE, state);
    } else if (!tl_follows(config, state, output)) {
      runs = false;
      tl_raise_fault(TL_FAULT_FOLLOWING, state);
    } else {
      // The law leads.
    }
  }
  if (!runs) {
    tl_stop_torque(config, input, at, state, tau);
  }
}

/// Whether mechanical brakes should be closed now: torque alone cannot be trusted, or
/// is not needed any more since the robot is faulted and at rest. Stays so until a
/// reset.
TL_INLINE bool tl_wants_brakes(
    const TlConfig* config, const TlMeasured* at, bool known, const TlState* state) {
  const uint32_t untrusted = TL_FAULTS_UNTRUSTED;
  return (state->mode == TL_FAULTED) &&
      ((state->brakes != 0) || ((state->faults & untrusted) != 0U) || (!known) ||
          tl_rests(config, at, state));
}

TL_INLINE void tl_clear_output(TlOutput* output) {
  output->refused = TL_ACCEPTED;
  output->factor = TL_ONE;
  tl_clear_numbers(TL_JOINTS, &output->joint_error[0]);
#if TL_TASK
  tl_clear_numbers(6 * TL_POINTS, &output->task_error[0]);
#endif
#if TL_FORCE
  output->force_error = TL_ZERO;
#endif
}

/// Whether all that was measured is finite.
TL_INLINE bool tl_measured_all(const TlInput* input, const TlMeasured* at) {
  bool finite = tl_are_numbers(&input->q[0], TL_JOINTS) &&
      tl_are_numbers(&at->qd[0], TL_JOINTS) && tl_inputs_are_numbers(input);
#if TL_FORCE
  finite = finite && tl_are_numbers(&input->force[0], 3);
#endif
  return finite;
}

/// Faults of a step: of what was measured, of the configuration, of commands that
/// stay away.
TL_INLINE void tl_find_faults(const TlConfig* config, bool sound, bool seen,
    const TlInput* input, const TlMeasured* at, TlState* state) {
  uint32_t found = 0U;
  if (!sound) {
    found |= TL_FAULT_CONFIG;
  }
  if (!seen) {
    found |= TL_FAULT_MEASUREMENT;
  } else {
    found |= tl_check_motion(config, input, at, state);
    if (tl_drifts(config, state)) {
      found |= TL_FAULT_JUMP;
    }
  }
  if (tl_is_stale(config, state)) {
    found |= TL_FAULT_STALE;
  }
  if (found != 0U) {
    tl_raise_fault(found, state);
  }
}

/// The torque that holds the robot at rest, within its limits; where it is none, the
/// last that was one.
TL_INLINE void tl_hold_gravity(
    const TlConfig* config, const TlMeasured* at, TlState* state) {
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real sound = tl_is_number(at->gravity[i]) ? at->gravity[i] : state->held[i];
    state->held[i] = tl_within(sound, config->torque[i]);
  }
}

/// Torque of a robot of which nothing can be computed: what held it against gravity
/// when something last could, and nothing once that is too long ago, when mechanical
/// brakes have taken over.
TL_INLINE void tl_blind_torque(
    const TlConfig* config, TlState* state, TlJointsOut tau) {
  const bool lately = state->blind_ticks < config->blind_ticks;
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    tau[i] = lately ? state->held[i] : TL_ZERO;
  }
  state->braking = 0;
  if (lately) {
    state->blind_ticks += 1;
  }
}

/// Torque of a step, within its limits and their rates.
TL_INLINE void tl_step_torque(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, bool known, TlSwitch how, TlState* state,
    TlOutput* output) {
  bool finite = false;
  if (known) {
    tl_mode_torque(config, input, at, how, state, output, output->tau);
    finite = tl_are_numbers(&output->tau[0], TL_JOINTS);
    if (!finite) {
      tl_raise_fault(TL_FAULT_TORQUE, state);
    }
  }
  if (finite) {
    output->factor = tl_saturate(config, state->held, output->tau);
  } else {
    tl_blind_torque(config, state, output->tau);
  }
  const bool late = tl_limit_rate(config, state, output->tau);
  state->cut = tl_flag((output->factor < TL_ONE) || late);
}

#if TL_CURRENT
/// Currents that give the torques, where motors and gears lose nothing.
TL_INLINE void tl_tell_currents(const TlConfig* config, TlOutput* output) {
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    output->current[i] = output->tau[i] / config->torque_per_ampere[i];
  }
}
#endif

/// One step of the controller, every `period` seconds. By a configuration that is not
/// sound the robot is not driven: it is braked by the emitted defaults.
TL_INLINE void tl_controller_step(
    const TlConfig* given, TlState* state, const TlInput* input, TlOutput* output) {
  int32_t index = 0;
  const bool sound = tl_find_config_fault(given, &index) == TL_CONFIG_SOUND;
  const TlConfig* const config = sound ? given : &TL_DEFAULTS;
  TlMeasured at;
  tl_clear_output(output);
  tl_find_velocities(config, input, state, &at);
  const bool seen = tl_measured_all(input, &at);
  if (seen && (!(config->observer > TL_ZERO))) {
    tl_add_drift(config, &at, input, state);
  }
  const bool known = tl_complete_state(config, input, seen, state, &at);
  if (known) {
    tl_hold_gravity(config, &at, state);
  }
  TlSwitch how = {false, false};
  how.fades = tl_take_command(config, input, &at, seen, state, output);
#if TL_TASK
  if (known && (state->mode == TL_RUNNING) && (state->law == TL_TASK_LAW)) {
    how.at_once = tl_tend_task(config, input, &at, state);
  }
  output->unmet = state->unmet;
#endif
#if TL_BEHAVES
  output->behaviour = state->behaviour;
#endif
  tl_find_faults(config, sound, seen, input, &at, state);
  tl_step_torque(config, input, &at, known, how, state, output);
#if TL_CURRENT
  tl_tell_currents(config, output);
#endif
  state->brakes = tl_flag(tl_wants_brakes(config, &at, known, state));
  output->brakes = state->brakes;
  output->saturated = state->cut;
  output->mode = state->mode;
  output->faults = state->faults;
  output->reason = state->reason;
}
