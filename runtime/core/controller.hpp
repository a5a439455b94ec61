#pragma once
// One step of an emitted controller: faults, commands, modes, the law's torque, saturation, and the
// torque of the safe state. C++17, freestanding, fixed size, no state but what it is given.

#include "core/controller_commands.hpp"
#include "core/controller_compliance.hpp"
#include "core/controller_config.hpp"

namespace treeline::core {

/// tau += J^T n force, which bears the reaction to `force` along the direction n of the point that
/// presses.
template <class Robot>
inline void add_push(const typename Robot::Input& input, const Measured<Robot>& at,
                     const typename Robot::State& state, RealOf<Robot> force,
                     RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  Real f[(Robot::kPoints > 0) ? (6 * Robot::kPoints) : 1];
  for (int i = 0; i < (6 * Robot::kPoints); ++i) {
    const int axis = i - (6 * state.press_point);
    f[i] = ((axis >= 0) && (axis < 3)) ? (-force * state.direction[axis]) : Real(0);
  }
  add_push_torque<Robot>(input, at, state, f, tau);
}

template <class Robot>
inline void law_torque(const typename Robot::Config& config, const typename Robot::Input& input,
                       const Measured<Robot>& at, typename Robot::State& state,
                       typename Robot::Output& output,
                       RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  if (state.law == Robot::kComplianceLaw) {
    compliant_torque<Robot>(config, input, at, state, tau);
    return;
  }
  if constexpr (Robot::kTask) {
    if (state.law == Robot::kTaskLaw) {
      Real qdd_0[Robot::kJoints];
      Real xdd_cmd[Robot::kRows];
      Real force = Real(0);
      task_law<Robot>(config, input, at, state, output, qdd_0, xdd_cmd, force);
      Robot::task_torque(input, state, at, qdd_0, xdd_cmd, tau);
      if constexpr (Robot::kForce) {
        if (state.pressing != 0) {
          add_push<Robot>(input, at, state, force, tau);
        }
      }
      return;
    }
  }
  Real qdd[Robot::kJoints];
  joint_law<Robot>(config, input, state, output, qdd);
  Robot::joint_torque(input, state, at, qdd, tau);
}

/// How the law of a step takes over from that of the step before.
enum class Switch : int32_t {
  none,
  fades,    ///< what it lacks of the old torque fades
  at_once,  ///< the old torque is not trusted any more
};

/// Adds what a switch of laws has left over: the torque has no step at the switch, and what it
/// lacks there fades.
template <class Robot>
inline void fade_switch(const typename Robot::Config& config, Switch how,
                        typename Robot::State& state,
                        RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  const Real rate = (config.fade > Real(0)) ? (Real(1) / config.fade) : Real(0);
  if (how != Switch::none) {
    state.fade_ticks = 0;
    for (int i = 0; i < Robot::kJoints; ++i) {
      const bool fades = (how == Switch::fades) && (rate > Real(0)) && (state.known != 0);
      state.left_over[i] = fades ? (state.tau[i] - tau[i]) : Real(0);
    }
  }
  const Real share = fade_out(share_left(seconds(state.fade_ticks, config.period), rate));
  for (int i = 0; i < Robot::kJoints; ++i) {
    tau[i] += share * state.left_over[i];
  }
  count_tick(state.fade_ticks);
}

/// Torque of the mode. Where the law's is not finite, or its reference is not followed, the mode
/// becomes faulted, and brakes.
template <class Robot>
inline void mode_torque(const typename Robot::Config& config, const typename Robot::Input& input,
                        const Measured<Robot>& at, Switch how, typename Robot::State& state,
                        typename Robot::Output& output,
                        RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  if (mode_of<Robot>(state) == Mode::running) {
    law_torque<Robot>(config, input, at, state, output, tau);
    fade_switch<Robot>(config, how, state, tau);
    const bool finite = all_finite(tau);
    if (finite && follows<Robot>(config, state, output)) {
      return;
    }
    raise_fault<Robot>(finite ? kFaultFollowing : kFaultTorque, state);
  }
  const bool begins = state.braking == 0;
  if (brake_torque<Robot>(config, input, at, state, tau)) {
    raise_fault<Robot>(kFaultMoved, state);
  }
  const bool by_command = (state.faults & ~kFaultEmergency) == 0;
  const Switch braked = by_command ? Switch::fades : Switch::at_once;
  fade_switch<Robot>(config, begins ? braked : Switch::none, state, tau);
  if ((mode_of<Robot>(state) == Mode::stopping) && rests<Robot>(config, at, state)) {
    apply_event<Robot>(Event::at_rest, state);
  }
}

/// Whether mechanical brakes should be closed now: torque alone cannot be trusted, or is not needed
/// any more since the robot is faulted and at rest. Stays so until a reset.
template <class Robot>
inline bool wants_brakes(const typename Robot::Config& config, const Measured<Robot>& at,
                         bool known, const typename Robot::State& state) noexcept {
  if (mode_of<Robot>(state) != Mode::faulted) {
    return false;
  }
  return (state.brakes != 0) || ((state.faults & kFaultsUntrusted) != 0) || !known ||
         rests<Robot>(config, at, state);
}

template <class Robot>
inline void clear_output(typename Robot::Output& output) noexcept {
  using Real = RealOf<Robot>;
  output.refused = 0;
  output.factor = Real(1);
  for (int i = 0; i < Robot::kJoints; ++i) {
    output.joint_error[i] = Real(0);
  }
  if constexpr (Robot::kTask) {
    for (Real& error : output.task_error) {
      error = Real(0);
    }
  }
  if constexpr (Robot::kForce) {
    output.force_error = Real(0);
  }
}

/// Faults of a step: of what was measured, of the configuration, of commands that stay away.
template <class Robot>
inline void find_faults(const typename Robot::Config& config, bool sound, bool seen,
                        const typename Robot::Input& input, typename Robot::State& state) noexcept {
  uint32_t found = sound ? 0U : kFaultConfig;
  if (seen) {
    found |= check_motion<Robot>(config, state, input) | check_drift<Robot>(config, state);
  } else {
    found |= kFaultMeasurement;
  }
  found |= is_stale<Robot>(config, state) ? kFaultStale : 0U;
  if (found != 0) {
    raise_fault<Robot>(found, state);
  }
}

/// Torque of a step, within its limits and their rates.
template <class Robot>
inline void step_torque(const typename Robot::Config& config, const typename Robot::Input& input,
                        const Measured<Robot>& at, bool known, Switch how,
                        typename Robot::State& state, typename Robot::Output& output) noexcept {
  bool finite = false;
  if (known) {
    mode_torque<Robot>(config, input, at, how, state, output, output.tau);
    finite = all_finite(output.tau);
  }
  if (finite) {
    output.factor = saturate<Robot>(config, state.held, output.tau);
  } else {
    blind_torque<Robot>(config, state, output.tau);
    state.braking = 0;
  }
  const bool late = limit_rate<Robot>(config, state, output.tau);
  state.cut = ((output.factor < RealOf<Robot>(1)) || late) ? 1 : 0;
}

/// One step of the controller, every `given.period` seconds. By a configuration that is not sound
/// the robot is not driven: it is braked by the emitted defaults.
template <class Robot>
inline void controller_step(const typename Robot::Config& given, typename Robot::State& state,
                            const typename Robot::Input& input,
                            typename Robot::Output& output) noexcept {
  clear_output<Robot>(output);
  const bool sound = check_config<Robot>(given).field == 0;
  const typename Robot::Config& config = sound ? given : Robot::defaults();
  const bool seen = measured_all<Robot>(input);
  if (seen) {
    add_drift<Robot>(config, input, state);
  }
  Measured<Robot> at;
  const bool known = complete_state<Robot>(config, input, seen, at, state);
  if (known) {
    hold_gravity<Robot>(config, at, state);
  }
  const bool switched = take_command<Robot>(config, input, at, seen, state, output);
  Switch how = switched ? Switch::fades : Switch::none;
  if constexpr (Robot::kTask) {
    if (known && (mode_of<Robot>(state) == Mode::running) && (state.law == Robot::kTaskLaw)) {
      how = tend_task<Robot>(config, input, at, state) ? Switch::at_once : how;
    }
    output.unmet = state.unmet;
  }
  find_faults<Robot>(config, sound, seen, input, state);
  step_torque<Robot>(config, input, at, known, how, state, output);
  state.brakes = wants_brakes<Robot>(config, at, known, state) ? 1 : 0;
  output.brakes = state.brakes;
  output.saturated = state.cut;
  output.mode = state.mode;
  output.faults = state.faults;
  output.reason = state.reason;
}

}  // namespace treeline::core
