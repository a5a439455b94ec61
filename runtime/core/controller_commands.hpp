#pragma once
// Commands of an emitted controller: what each begins, and which are refused. C++17, freestanding,
// fixed size.

#include "core/controller_braking.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

template <class Robot>
inline Mode mode_of(const typename Robot::State& state) noexcept {
  return static_cast<Mode>(state.mode);
}

template <class Robot>
inline void apply_event(Event event, typename Robot::State& state) noexcept {
  state.mode = static_cast<int32_t>(next_mode(mode_of<Robot>(state), event));
}

template <class Robot>
inline void raise_fault(uint32_t faults, typename Robot::State& state) noexcept {
  state.reason = (state.faults == 0) ? faults : state.reason;
  state.faults |= faults;
  apply_event<Robot>(Event::fault, state);
}

/// Counts the steps without a command while running; whether there were too many.
template <class Robot>
inline bool is_stale(const typename Robot::Config& config, typename Robot::State& state) noexcept {
  count_tick(state.command_ticks);
  return (config.stale_ticks > 0) && (state.command_ticks > config.stale_ticks) &&
         (mode_of<Robot>(state) == Mode::running);
}

/// Begins to hold the joints where they are.
template <class Robot>
inline void start_holding(const typename Robot::Config& config, const typename Robot::Input& input,
                          typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  Real rest[Robot::kJoints];
  for (Real& number : rest) {
    number = Real(0);
  }
  state.law = Robot::kJointLaw;
  state.braking = 0;
  move_joints<Robot>(config, input.q, rest, rest, input.q, config.period, state);
}

template <class Robot>
inline bool is_within_limits(const typename Robot::Config& config,
                             const RealOf<Robot> (&goal)[Robot::kJoints]) noexcept {
  bool within_all = true;
  for (int i = 0; i < Robot::kJoints; ++i) {
    within_all = within_all && (goal[i] >= config.lower[i]) && (goal[i] <= config.upper[i]);
  }
  return within_all;
}

/// Whether the duration is finite, and a step at the least.
template <class Real>
constexpr bool is_duration(Real duration, Real period) noexcept {
  return is_finite(duration) && (duration >= period);
}

/// Whether a vector is of length 1 to a hundredth.
template <class Real>
constexpr bool is_unit(Real x, Real y, Real z) noexcept {
  return magnitude((x * x) + (y * y) + (z * z) - Real(1)) < Real(0.02);
}

/// Whether the rows are of length 1, and each is the cross product of the two others.
template <class Real>
constexpr bool is_rotation(const Real (&R)[9]) noexcept {
  const Real x = (R[1] * R[5]) - (R[2] * R[4]);
  const Real y = (R[2] * R[3]) - (R[0] * R[5]);
  const Real z = (R[0] * R[4]) - (R[1] * R[3]);
  return is_unit(R[0], R[1], R[2]) && is_unit(R[3], R[4], R[5]) &&
         (magnitude((x * R[6]) + (y * R[7]) + (z * R[8]) - Real(1)) < Real(0.03));
}

/// Joints to a posture, from the reference if they were following one. Returns whether the law
/// becomes another.
template <class Robot>
inline bool begin_posture(const typename Robot::Config& config, const typename Robot::Input& input,
                          typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  const bool switched = state.law != Robot::kJointLaw;
  Real p[Robot::kJoints];
  Real v[Robot::kJoints];
  Real a[Robot::kJoints];
  joint_reference<Robot>(config, state, p, v, a);
  for (int i = 0; i < Robot::kJoints; ++i) {
    p[i] = switched ? input.q[i] : p[i];
    v[i] = switched ? input.qd[i] : v[i];
    a[i] = switched ? Real(0) : a[i];
  }
  state.law = Robot::kJointLaw;
  move_joints<Robot>(config, p, v, a, input.command.goal, input.command.duration, state);
  return switched;
}

/// Whether the point exerts a force in place of moving.
template <class Robot>
inline bool is_pressing(const typename Robot::State& state, int point) noexcept {
  if constexpr (Robot::kForce) {
    return (state.pressing != 0) && (state.press_point == point);
  }
  return false;
}

template <class Robot>
inline void stop_pressing(typename Robot::State& state) noexcept {
  if constexpr (Robot::kForce) {
    state.pressing = 0;
  }
}

/// Begins the law of the task, where it is not the law already: all points hold their present
/// poses, the posture is where the joints were led last.
template <class Robot>
inline bool enter_task(const typename Robot::Config& config, const Measured<Robot>& at,
                       typename Robot::State& state) noexcept {
  if (state.law == Robot::kTaskLaw) {
    return false;
  }
  state.law = Robot::kTaskLaw;
  stop_pressing<Robot>(state);
  for (int i = 0; i < Robot::kJoints; ++i) {
    state.posture[i] = state.joint_motion[i];
  }
  for (int point = 0; point < Robot::kPoints; ++point) {
    PointMotion<RealOf<Robot>> now;
    measured_motion<Robot>(at, point, now);
    for (RealOf<Robot>& v : now.velocity) {
      v = RealOf<Robot>(0);
    }
    move_point<Robot>(config, now, now.position, now.rotation, config.period, point, state);
  }
  return true;
}

/// A point to a pose: from its reference, or from where it is if it was not following one.
template <class Robot>
inline bool begin_pose(const typename Robot::Config& config, const typename Robot::Input& input,
                       const Measured<Robot>& at, typename Robot::State& state) noexcept {
  const int point = input.command.point;
  const bool entered = enter_task<Robot>(config, at, state);
  const bool pressed = is_pressing<Robot>(state, point);
  PointMotion<RealOf<Robot>> now;
  if (entered || pressed) {
    measured_motion<Robot>(at, point, now);
  } else {
    point_reference<Robot>(config, state, point, now);
  }
  if (pressed) {
    stop_pressing<Robot>(state);
  }
  move_point<Robot>(config, now, input.command.position, input.command.rotation,
                    input.command.duration, point, state);
  return entered || pressed;
}

/// Force along a direction, reached by and by.
template <class Robot>
inline bool begin_press(const typename Robot::Config& config, const typename Robot::Input& input,
                        const Measured<Robot>& at, typename Robot::State& state) noexcept {
  enter_task<Robot>(config, at, state);
  state.pressing = 1;
  state.press_point = input.command.point;
  state.press_force = input.command.force;
  state.press_rate = RealOf<Robot>(1) / input.command.duration;
  state.press_ticks = 0;
  state.force_integral = RealOf<Robot>(0);
  copy_numbers(&input.command.direction[0], state.direction);
  return true;
}

/// Whether a command of motion makes sense.
template <class Robot>
inline bool is_sound(const typename Robot::Config& config,
                     const typename Robot::Command& command) noexcept {
  const auto kind = static_cast<MessageKind>(command.kind);
  if (!is_duration(command.duration, config.period)) {
    return false;
  }
  if (kind == MessageKind::set_posture) {
    return is_within_limits<Robot>(config, command.goal);
  }
  const bool of_point = (command.point >= 0) && (command.point < Robot::kPoints);
  if constexpr (Robot::kTask) {
    if (kind == MessageKind::move_point) {
      return of_point && all_finite(command.position) && is_rotation(command.rotation);
    }
  }
  if constexpr (Robot::kForce) {
    if (kind == MessageKind::press) {
      return of_point && (magnitude(command.force) <= config.largest_force) &&
             is_unit(command.direction[0], command.direction[1], command.direction[2]);
    }
  }
  return false;
}

/// Begins a motion, or refuses to. Returns whether the law becomes another.
template <class Robot>
inline bool begin_motion(const typename Robot::Config& config, const typename Robot::Input& input,
                         const Measured<Robot>& at, typename Robot::State& state,
                         typename Robot::Output& output) noexcept {
  if ((mode_of<Robot>(state) != Mode::running) || !is_sound<Robot>(config, input.command)) {
    output.refused = 1;
    return false;
  }
  const auto kind = static_cast<MessageKind>(input.command.kind);
  if constexpr (Robot::kTask) {
    if (kind == MessageKind::move_point) {
      return begin_pose<Robot>(config, input, at, state);
    }
  }
  if constexpr (Robot::kForce) {
    if (kind == MessageKind::press) {
      return begin_press<Robot>(config, input, at, state);
    }
  }
  return begin_posture<Robot>(config, input, state);
}

/// Commands of the loop: `seen` says whether the state was measured.
template <class Robot>
inline bool apply_command(const typename Robot::Config& config, const typename Robot::Input& input,
                          const Measured<Robot>& at, bool seen, typename Robot::State& state,
                          typename Robot::Output& output) noexcept {
  const Mode before = mode_of<Robot>(state);
  if (!is_message_kind(input.command.kind)) {
    output.refused = 1;
    return false;
  }
  switch (static_cast<MessageKind>(input.command.kind)) {
    case MessageKind::emergency_stop:
      raise_fault<Robot>(kFaultEmergency, state);
      return false;
    case MessageKind::disconnect:
    case MessageKind::stop:
      apply_event<Robot>(Event::stop, state);
      return false;
    case MessageKind::instruction:  // only tells that whoever commands is there
      return false;
    case MessageKind::reset:
      output.refused = (seen && (before == Mode::faulted)) ? 0 : 1;
      if (output.refused != 0) {
        return false;
      }
      admit<Robot>(config, input, state);
      clear_drift<Robot>(state);
      state.faults = 0;
      state.reason = 0;
      apply_event<Robot>(Event::reset, state);
      return false;
    case MessageKind::start:
      output.refused = (seen && (before == Mode::idle)) ? 0 : 1;
      if (output.refused != 0) {
        return false;
      }
      apply_event<Robot>(Event::start, state);
      start_holding<Robot>(config, input, state);
      return true;
    default:
      break;
  }
  if (seen) {
    return begin_motion<Robot>(config, input, at, state, output);
  }
  output.refused = 1;
  return false;
}

/// Takes the command if it is a new one. Returns whether the law becomes another.
template <class Robot>
inline bool take_command(const typename Robot::Config& config, const typename Robot::Input& input,
                         const Measured<Robot>& at, bool seen, typename Robot::State& state,
                         typename Robot::Output& output) noexcept {
  if (input.command.sequence == state.sequence) {
    return false;
  }
  state.sequence = input.command.sequence;
  state.command_ticks = 0;
  return apply_command<Robot>(config, input, at, seen, state, output);
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
