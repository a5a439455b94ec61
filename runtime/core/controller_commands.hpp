#pragma once
// Commands of an emitted controller: what each begins, and which are refused. C++17, freestanding,
// fixed size.

#include "core/controller_braking.hpp"
#include "core/controller_pace.hpp"

namespace treeline::core {

/// Why a command was refused.
enum class Refusal : int32_t {
  none,
  kind,         ///< there is no such command
  mode,         ///< not in this mode
  measurement,  ///< while something is not measured
  duration,     ///< shorter than a step, longer than an hour, or it would have to be
  limits,       ///< the goal is beyond a joint's limits, or the way there is
  point,        ///< there is no such point
  numbers,      ///< a position that is not finite, or what is no rotation or no direction
  force,        ///< larger than `largest_force`
};

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

/// Joints to a posture, from the reference if they were following one.
template <class Robot>
inline Refusal begin_posture(const typename Robot::Config& config,
                             const typename Robot::Input& input,
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
  if (!is_within_limits<Robot>(config, input.command.goal)) {
    return Refusal::limits;
  }
  if (!is_duration(input.command.duration, config.period)) {
    return Refusal::duration;
  }
  if (!move_joints<Robot>(config, p, v, a, input.command.goal, input.command.duration, state)) {
    return Refusal::limits;
  }
  state.law = Robot::kJointLaw;
  return Refusal::none;
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
inline Refusal begin_pose(const typename Robot::Config& config, const typename Robot::Input& input,
                          const Measured<Robot>& at, typename Robot::State& state,
                          bool& switched) noexcept {
  const typename Robot::Command& command = input.command;
  const int32_t before = state.law;
  const bool entered = enter_task<Robot>(config, at, state);
  const bool pressed = is_pressing<Robot>(state, command.point);
  PointMotion<RealOf<Robot>> now;
  if (entered || pressed) {
    measured_motion<Robot>(at, command.point, now);
  } else {
    point_reference<Robot>(config, state, command.point, now);
  }
  if (!move_point<Robot>(config, now, command.position, command.rotation, command.duration,
                         command.point, state)) {
    state.law = before;
    return Refusal::duration;
  }
  if (pressed) {
    stop_pressing<Robot>(state);
  }
  switched = entered || pressed;
  return Refusal::none;
}

/// Force along a direction, reached by and by.
template <class Robot>
inline Refusal begin_press(const typename Robot::Config& config, const typename Robot::Input& input,
                           const Measured<Robot>& at, typename Robot::State& state) noexcept {
  enter_task<Robot>(config, at, state);
  state.pressing = 1;
  state.press_point = input.command.point;
  state.press_force = input.command.force;
  state.press_rate = RealOf<Robot>(1) / input.command.duration;
  state.press_ticks = 0;
  state.force_integral = RealOf<Robot>(0);
  state.contact_ticks = 0;
  copy_numbers(&input.command.direction[0], state.direction);
  return Refusal::none;
}

/// Joints and points comply about where they are.
template <class Robot>
inline Refusal begin_compliance(const typename Robot::Config& config,
                                const typename Robot::Input& input, const Measured<Robot>& at,
                                typename Robot::State& state) noexcept {
  start_holding<Robot>(config, input, state);
  if constexpr (Robot::kTask) {
    enter_task<Robot>(config, at, state);
  }
  state.law = Robot::kComplianceLaw;
  return Refusal::none;
}

/// What of a command for a point makes no sense.
template <class Robot>
inline Refusal check_point_command(const typename Robot::Config& config,
                                   const typename Robot::Command& command) noexcept {
  if ((command.point < 0) || (command.point >= Robot::kPoints)) {
    return Refusal::point;
  }
  if (!is_duration(command.duration, config.period)) {
    return Refusal::duration;
  }
  bool sound = true;
  if constexpr (Robot::kTask) {
    if (static_cast<MessageKind>(command.kind) == MessageKind::move_point) {
      sound = all_finite(command.position) && is_rotation(command.rotation);
    }
  }
  if constexpr (Robot::kForce) {
    if (static_cast<MessageKind>(command.kind) == MessageKind::press) {
      sound = is_unit(command.direction[0], command.direction[1], command.direction[2]);
      if (!(magnitude(command.force) <= config.largest_force)) {
        return Refusal::force;
      }
    }
  }
  return sound ? Refusal::none : Refusal::numbers;
}

/// Begins a motion, or refuses to. `switched` becomes whether the law becomes another.
template <class Robot>
inline Refusal begin_motion(const typename Robot::Config& config,
                            const typename Robot::Input& input, const Measured<Robot>& at,
                            typename Robot::State& state, bool& switched) noexcept {
  const auto kind = static_cast<MessageKind>(input.command.kind);
  if (kind == MessageKind::set_posture) {
    const int32_t before = state.law;
    const Refusal refusal = begin_posture<Robot>(config, input, state);
    switched = state.law != before;
    return refusal;
  }
  if (kind == MessageKind::comply) {
    switched = true;
    return begin_compliance<Robot>(config, input, at, state);
  }
  if constexpr (Robot::kTask) {
    const bool presses = Robot::kForce && (kind == MessageKind::press);
    if (presses || (kind == MessageKind::move_point)) {
      const Refusal refusal = check_point_command<Robot>(config, input.command);
      if (refusal != Refusal::none) {
        return refusal;
      }
    }
    if (kind == MessageKind::move_point) {
      return begin_pose<Robot>(config, input, at, state, switched);
    }
  }
  if constexpr (Robot::kForce) {
    if (kind == MessageKind::press) {
      switched = true;
      return begin_press<Robot>(config, input, at, state);
    }
  }
  return Refusal::kind;
}

/// Leaves the mode faulted.
template <class Robot>
inline void leave_faults(const typename Robot::Config& config, const typename Robot::Input& input,
                         typename Robot::State& state) noexcept {
  admit<Robot>(config, input, state);
  clear_drift<Robot>(state);
  state.faults = 0;
  state.reason = 0;
  apply_event<Robot>(Event::reset, state);
}

/// The mode that a command needs, if it needs one.
template <class Robot>
inline Refusal check_mode(MessageKind kind, bool seen,
                          const typename Robot::State& state) noexcept {
  Mode needed = Mode::running;
  if (kind == MessageKind::reset) {
    needed = Mode::faulted;
  }
  if (kind == MessageKind::start) {
    needed = Mode::idle;
  }
  if (mode_of<Robot>(state) != needed) {
    return Refusal::mode;
  }
  return seen ? Refusal::none : Refusal::measurement;
}

/// Commands of the loop: `seen` says whether the state was measured. `switched` becomes whether the
/// law becomes another.
template <class Robot>
inline Refusal apply_command(const typename Robot::Config& config,
                             const typename Robot::Input& input, const Measured<Robot>& at,
                             bool seen, typename Robot::State& state, bool& switched) noexcept {
  if (!is_message_kind(input.command.kind)) {
    return Refusal::kind;
  }
  const auto kind = static_cast<MessageKind>(input.command.kind);
  if (kind == MessageKind::emergency_stop) {
    raise_fault<Robot>(kFaultEmergency, state);
    return Refusal::none;
  }
  if ((kind == MessageKind::disconnect) || (kind == MessageKind::stop)) {
    apply_event<Robot>(Event::stop, state);
    return Refusal::none;
  }
  if (kind == MessageKind::instruction) {  // only tells that whoever commands is there
    return Refusal::none;
  }
  const Refusal refusal = check_mode<Robot>(kind, seen, state);
  if (refusal != Refusal::none) {
    return refusal;
  }
  if (kind == MessageKind::reset) {
    leave_faults<Robot>(config, input, state);
    return Refusal::none;
  }
  if (kind == MessageKind::start) {
    apply_event<Robot>(Event::start, state);
    start_holding<Robot>(config, input, state);
    switched = true;
    return Refusal::none;
  }
  return begin_motion<Robot>(config, input, at, state, switched);
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
  bool switched = false;
  const Refusal refusal = apply_command<Robot>(config, input, at, seen, state, switched);
  output.refused = static_cast<int32_t>(refusal);
  if constexpr (Robot::kTask) {
    const bool moves = input.command.kind != static_cast<int32_t>(MessageKind::instruction);
    state.unmet = (moves && (refusal == Refusal::none)) ? 0 : state.unmet;
  }
  return switched;
}

}  // namespace treeline::core
