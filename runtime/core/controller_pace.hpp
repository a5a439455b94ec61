#pragma once
// What becomes of references that the robot cannot follow: those of points slow down, and are given
// up where nothing leads there; what stays behind for other reasons is a fault. C++17,
// freestanding, fixed size.

#include "core/controller_laws.hpp"

namespace treeline::core {

/// Why a motion was given up.
enum class Unmet : int32_t {
  none,
  stuck,    ///< something blocks the points, which is a fault
  reach,    ///< the way leads out of reach or into a singularity: a joint would become too fast
  limit,    ///< a joint could not be stopped within its range any more
  torque,   ///< the motors are too weak to follow
  contact,  ///< what the point pressed is not there any more
};

/// How far a reference may be away: `following`, and half of that once it has stood for a second.
template <class Robot>
inline RealOf<Robot> admitted_error(const typename Robot::Config& config, RealOf<Robot> time,
                                    RealOf<Robot> rate) noexcept {
  const bool stands = ((time - RealOf<Robot>(1)) * rate) > RealOf<Robot>(1);
  return stands ? (RealOf<Robot>(0.5) * config.following) : config.following;
}

/// Whether all joints are near their reference.
template <class Robot>
inline bool joints_follow(const typename Robot::Config& config, const typename Robot::State& state,
                          const typename Robot::Output& output) noexcept {
  const RealOf<Robot> most =
      admitted_error<Robot>(config, seconds(state.joint_ticks, config.period), state.joint_rate);
  bool follow = true;
  for (int i = 0; i < Robot::kJoints; ++i) {
    follow = follow && (magnitude(output.joint_error[i]) <= most);
  }
  return follow;
}

/// How far a point is from its reference, m or rad: the largest number of its position and
/// orientation, each where all three of its rows are controlled. Where the point presses its
/// position is free.
template <class Robot>
inline RealOf<Robot> point_away(int point, const typename Robot::State& state,
                                const typename Robot::Output& output) noexcept {
  using Real = RealOf<Robot>;
  Real most = Real(0);
  for (int part = is_pressing<Robot>(state, point) ? 3 : 0; part < 6; part += 3) {
    const int row = (6 * point) + part;
    for (int i = 0; i < 3; ++i) {
      const Real error = is_whole<Robot>(row) ? magnitude(output.task_error[row + i]) : Real(0);
      most = (error <= most) ? most : error;  // NaN too
    }
  }
  return most;
}

/// Whether the law's references are followed.
template <class Robot>
inline bool follows(const typename Robot::Config& config, typename Robot::State& state,
                    const typename Robot::Output& output) noexcept {
  if constexpr (Robot::kTask) {
    if (state.law == Robot::kTaskLaw) {
      using Real = RealOf<Robot>;
      bool all = true;
      state.away = Real(0);
      for (int point = 0; point < Robot::kPoints; ++point) {
        const Real away = point_away<Robot>(point, state, output);
        const Real time = point_time<Robot>(config, state, point);
        all = all && (away <= admitted_error<Robot>(config, time, state.point_rate[point]));
        state.away = (away > state.away) ? away : state.away;
      }
      return all;
    }
  }
  return joints_follow<Robot>(config, state, output);
}

/// The speed of the joint that is nearest to its limit, as a share of it, in twelve steps from now
/// if it goes on rising: on the way into a singularity it does.
template <class Robot>
inline RealOf<Robot> speed_ahead(const typename Robot::Config& config, const Measured<Robot>& at,
                                 typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  Real fastest = Real(0);
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real share = magnitude(at.qd[i]) / config.speed[i];
    fastest = (share > fastest) ? share : fastest;
  }
  const Real rises = fastest - state.fastest;
  state.fastest += Real(0.25) * rises;
  return fastest + ((rises > Real(0)) ? (Real(3) * rises) : Real(0));
}

/// Slows the points' references down where a joint is faster than two fifths of its limit, or a
/// point stays behind by more than a twentieth of `following`; at 0.3 of it they stand.
template <class Robot>
inline void set_pace(const typename Robot::Config& config, RealOf<Robot> ahead,
                     typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  const Real behind = (Real(4) * state.away / config.following) - Real(0.2);
  const Real yields = Real(2.5) * (ahead - Real(0.4));
  const Real most = (behind > yields) ? behind : yields;
  const Real wanted = (most < Real(1)) ? ((most > Real(0)) ? most : Real(0)) : Real(1);
  const Real rise = (config.speed_rise > config.period) ? config.speed_rise : config.period;
  const Real follows = Real(5) * config.period / rise;
  for (int point = 0; point < Robot::kPoints; ++point) {
    const Real change = wanted - state.point_slow[point];
    const Real rate = config.period / ((change > Real(0)) ? rise : (Real(2) * rise));
    const Real next =
        state.point_slow[point] + within(((follows < Real(1)) ? follows : Real(1)) * change, rate);
    state.point_slow_rate[point] = (next - state.point_slow[point]) / config.period;
    state.point_slow[point] = next;
  }
}

/// Whether a joint could not be stopped within its range any more, from which it is moving away.
template <class Robot>
inline bool meets_limit(const typename Robot::Config& config, const Measured<Robot>& at) noexcept {
  using Real = RealOf<Robot>;
  const Real duration = stop_duration<Robot>(config, at);
  bool meets = false;
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real onward = kStopShare<Real> * duration * at.qd[i];
    const Real slack = Real(0.5) * config.position_margin;
    const Real room =
        (onward > Real(0)) ? (config.upper[i] - at.q[i]) : (at.q[i] - config.lower[i]);
    meets = meets || (magnitude(onward) > (room + slack));
  }
  return meets;
}

/// Whether motors have been at their limits for thirty milliseconds while a point is away from its
/// reference by more than a tenth of `following`.
template <class Robot>
inline bool lacks_torque(const typename Robot::Config& config,
                         typename Robot::State& state) noexcept {
  const bool lacks = (state.cut != 0) && (state.away > (RealOf<Robot>(0.1) * config.following));
  state.cut_ticks = lacks ? state.cut_ticks : 0;
  count_tick(state.cut_ticks);
  return seconds(state.cut_ticks, config.period) > RealOf<Robot>(0.03);
}

/// Whether the references have stood for half a second since a point is away from its own.
template <class Robot>
inline bool is_stuck(const typename Robot::Config& config, typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  bool waits = true;
  bool ended = true;
  for (int point = 0; point < Robot::kPoints; ++point) {
    const Real time = point_time<Robot>(config, state, point);
    waits = waits && (state.point_slow[point] > Real(0.9));
    ended = ended && ((time * state.point_rate[point]) >= Real(1));
  }
  state.stuck_ticks = (waits && !ended) ? state.stuck_ticks : 0;
  count_tick(state.stuck_ticks);
  return seconds(state.stuck_ticks, config.period) > Real(0.5);
}

/// Whether the point that presses has lost what it pressed: after half of the force was there, less
/// than a tenth of it is left for twenty milliseconds.
template <class Robot>
inline bool loses_contact(const typename Robot::Config& config, const typename Robot::Input& input,
                          typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  if constexpr (Robot::kForce) {
    Real measured = Real(0);
    for (int i = 0; i < 3; ++i) {
      measured += state.direction[i] * input.force[i];
    }
    const Real wanted = magnitude(state.press_force);
    const Real borne = (state.press_force < Real(0)) ? -measured : measured;
    if (borne > (Real(0.5) * wanted)) {
      state.contact_ticks = 1;
    } else if ((borne < (Real(0.1) * wanted)) && (state.contact_ticks > 0)) {
      count_tick(state.contact_ticks);
    } else {
      state.contact_ticks = (state.contact_ticks > 0) ? 1 : 0;
    }
    return (state.pressing != 0) && (seconds(state.contact_ticks, config.period) > Real(0.02));
  }
  return false;
}

/// Why the points' motion cannot go on, if it cannot.
template <class Robot>
inline Unmet find_unmet(const typename Robot::Config& config, const typename Robot::Input& input,
                        const Measured<Robot>& at, typename Robot::State& state) noexcept {
  const RealOf<Robot> ahead = speed_ahead<Robot>(config, at, state);
  set_pace<Robot>(config, ahead, state);
  Unmet why = Unmet::none;
  if (is_stuck<Robot>(config, state)) {
    why = Unmet::stuck;
  }
  if (lacks_torque<Robot>(config, state)) {
    why = Unmet::torque;
  }
  if (ahead > RealOf<Robot>(0.85)) {
    why = Unmet::reach;
  }
  if (meets_limit<Robot>(config, at)) {
    why = Unmet::limit;
  }
  return loses_contact<Robot>(config, input, state) ? Unmet::contact : why;
}

/// Sees to it that points follow their references, or gives their motion up: then the joints come
/// to rest and hold. Returns whether it did. A robot that is stuck on the way is a fault: something
/// blocks it.
template <class Robot>
inline bool tend_task(const typename Robot::Config& config, const typename Robot::Input& input,
                      const Measured<Robot>& at, typename Robot::State& state) noexcept {
  const Unmet why = find_unmet<Robot>(config, input, at, state);
  if (why == Unmet::stuck) {
    raise_fault<Robot>(kFaultFollowing, state);
  }
  if ((why == Unmet::none) || (why == Unmet::stuck)) {
    return false;
  }
  state.unmet = static_cast<int32_t>(why);
  stop_joints<Robot>(config, at, state);
  return true;
}

}  // namespace treeline::core
