#pragma once
// One step of an emitted controller: faults, commands, modes, the law's torque, saturation, and the
// torque of the safe state. C++17, freestanding, fixed size, no state but what it is given.

#include "core/controller_commands.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Torque that holds the robot against gravity and damps its motion, qdd = -brake_damping qd, each
/// joint's within its limit. NaN where the state was not finite.
template <class Robot>
inline void brake_torque(const typename Robot::Config& config, const typename Robot::Input& input,
                         const Measured<Robot>& at, RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  Real qdd[Robot::kJoints];
  for (int i = 0; i < Robot::kJoints; ++i) {
    qdd[i] = -config.brake_damping * input.qd[i];
  }
  Robot::joint_torque(input, at, qdd, tau);
}

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
  Real push[Robot::kJoints];
  Robot::push_torque(input, at, f, push);
  for (int i = 0; i < Robot::kJoints; ++i) {
    tau[i] += push[i];
  }
}

template <class Robot>
inline void law_torque(const typename Robot::Config& config, const typename Robot::Input& input,
                       const Measured<Robot>& at, typename Robot::State& state,
                       typename Robot::Output& output,
                       RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  if constexpr (Robot::kTask) {
    if (state.law == Robot::kTaskLaw) {
      Real qdd_0[Robot::kJoints];
      Real xdd_cmd[Robot::kRows];
      Real force = Real(0);
      task_law<Robot>(config, input, at, state, output, qdd_0, xdd_cmd, force);
      Robot::task_torque(input, at, qdd_0, xdd_cmd, tau);
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
  Robot::joint_torque(input, at, qdd, tau);
}

/// Adds what a switch of laws has left over: the torque has no step at the switch, and what it
/// lacks there fades.
template <class Robot>
inline void fade_switch(const typename Robot::Config& config, bool switched,
                        typename Robot::State& state,
                        RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  const Real rate = (config.fade > Real(0)) ? (Real(1) / config.fade) : Real(0);
  if (switched) {
    state.fade_ticks = 0;
    for (int i = 0; i < Robot::kJoints; ++i) {
      const bool fades = (rate > Real(0)) && (state.known != 0);
      state.left_over[i] = fades ? (state.tau[i] - tau[i]) : Real(0);
    }
  }
  const Real share = fade_out(share_left(seconds(state.fade_ticks, config.period), rate));
  for (int i = 0; i < Robot::kJoints; ++i) {
    tau[i] += share * state.left_over[i];
  }
  count_tick(state.fade_ticks);
}

/// Torque of the mode. Where the law's is not finite the mode becomes faulted, and brakes.
template <class Robot>
inline void mode_torque(const typename Robot::Config& config, const typename Robot::Input& input,
                        const Measured<Robot>& at, bool switched, typename Robot::State& state,
                        typename Robot::Output& output,
                        RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  if (mode_of<Robot>(state) == Mode::running) {
    law_torque<Robot>(config, input, at, state, output, tau);
    fade_switch<Robot>(config, switched, state, tau);
    if (all_finite(tau)) {
      return;
    }
    raise_fault<Robot>(kFaultTorque, state);
  }
  brake_torque<Robot>(config, input, at, tau);
  if ((mode_of<Robot>(state) == Mode::stopping) && rests<Robot>(config, input)) {
    apply_event<Robot>(Event::at_rest, state);
  }
}

/// The torque that holds the robot at rest, within its limits.
template <class Robot>
inline void hold_gravity(const typename Robot::Config& config, const Measured<Robot>& at,
                         typename Robot::State& state) noexcept {
  for (int i = 0; i < Robot::kJoints; ++i) {
    state.held[i] = within(at.gravity[i], config.torque[i]);
  }
  state.blind_ticks = 0;
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

/// One step of the controller, every `config.period` seconds.
template <class Robot>
inline void controller_step(const typename Robot::Config& config, typename Robot::State& state,
                            const typename Robot::Input& input,
                            typename Robot::Output& output) noexcept {
  using Real = RealOf<Robot>;
  clear_output<Robot>(output);
  const bool seen = measured_all<Robot>(input);
  Measured<Robot> at;
  if (seen) {
    Robot::measure(input, at);
    hold_gravity<Robot>(config, at, state);
  }
  const bool switched = take_command<Robot>(config, input, at, seen, state, output);
  const uint32_t found = seen ? check_motion<Robot>(config, state, input) : kFaultMeasurement;
  if (found != 0) {
    raise_fault<Robot>(found, state);
  }
  if (is_stale<Robot>(config, state)) {
    raise_fault<Robot>(kFaultStale, state);
  }
  Real tau[Robot::kJoints];
  bool finite = false;
  if (seen) {
    mode_torque<Robot>(config, input, at, switched, state, output, tau);
    finite = all_finite(tau);
  }
  if (finite) {
    output.factor = saturate<Robot>(config, state.held, tau);
  } else {
    blind_torque<Robot>(config, state, tau);
  }
  state.cut = (output.factor < Real(1)) ? 1 : 0;
  for (int i = 0; i < Robot::kJoints; ++i) {
    state.tau[i] = tau[i];
    output.tau[i] = tau[i];
  }
  state.known = 1;
  output.saturated = state.cut;
  output.mode = state.mode;
  output.faults = state.faults;
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
