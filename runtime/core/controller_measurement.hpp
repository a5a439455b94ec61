#pragma once
// What was measured, made fit to compute with: numbers that are lost are put together from those
// that are left, and coordinates are compared with their velocities. C++17, freestanding, fixed
// size.

#include "core/controller_safety.hpp"

namespace treeline::core {

/// State of the robot as the functions of a step find it: coordinates and velocities, each joint's
/// sine and cosine once, poses and velocities [v; w] of the points in world axes, and the torque
/// that holds the robot at rest.
template <class Robot>
struct Measured {
  RealOf<Robot> q[Robot::kJoints];
  RealOf<Robot> qd[Robot::kJoints];
  bool lost[Robot::kJoints];  ///< neither q nor qd of the joint is finite
  RealOf<Robot> sin_q[Robot::kJoints];
  RealOf<Robot> cos_q[Robot::kJoints];
  RealOf<Robot> gravity[Robot::kJoints];
  RealOf<Robot> position[(Robot::kPoints > 0) ? (3 * Robot::kPoints) : 1];
  RealOf<Robot> rotation[(Robot::kPoints > 0) ? (9 * Robot::kPoints) : 1];
  RealOf<Robot> velocity[(Robot::kPoints > 0) ? (6 * Robot::kPoints) : 1];
};

/// Whether all that was measured is finite.
template <class Robot>
inline bool measured_all(const typename Robot::Input& input) noexcept {
  bool finite = all_finite(input.q) && all_finite(input.qd) && Robot::finite(input);
  if constexpr (Robot::kForce) {
    finite = finite && all_finite(input.force);
  }
  return finite;
}

/// Adds to each joint's drift how far q moved in a step otherwise than by the mean of both
/// velocities. Old drift fades within a tenth of a second. All that was measured is finite.
template <class Robot>
inline void add_drift(const typename Robot::Config& config, const typename Robot::Input& input,
                      typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  const Real fading = Real(10) * config.period;
  const Real kept = (fading < Real(1)) ? (Real(1) - fading) : Real(0);
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real moved = way_to<Robot>(i, state.sound_q[i], input.q[i]);
    const Real told = Real(0.5) * config.period * (state.sound_qd[i] + input.qd[i]);
    const Real more = (state.posed != 0) ? (moved - told) : Real(0);
    state.drift[i] = within((kept * state.drift[i]) + more, Real(2) * config.jump);
  }
}

/// Whether a coordinate moves otherwise than its velocity says: it jumped, or one of both is
/// frozen.
template <class Robot>
inline uint32_t check_drift(const typename Robot::Config& config,
                            const typename Robot::State& state) noexcept {
  uint32_t faults = 0;
  for (int i = 0; i < Robot::kJoints; ++i) {
    faults |= (magnitude(state.drift[i]) <= config.jump) ? 0U : kFaultJump;
  }
  return faults;
}

/// Forgets drift, such as after a reset.
template <class Robot>
inline void clear_drift(typename Robot::State& state) noexcept {
  for (RealOf<Robot>& drift : state.drift) {
    drift = RealOf<Robot>(0);
  }
}

/// Fills in a joint's state. A lost velocity is the difference of two coordinates, within the limit
/// of speed; a lost coordinate is the last one, moved on by the velocity; where both are lost, the
/// joint is taken to stand where it last was.
template <class Robot>
inline void complete_joint(const typename Robot::Config& config, const typename Robot::Input& input,
                           int i, Measured<Robot>& at,
                           const typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  const bool has_q = is_finite(input.q[i]);
  const bool has_qd = is_finite(input.qd[i]);
  at.lost[i] = !has_q && !has_qd;
  at.qd[i] = has_qd ? input.qd[i] : Real(0);
  if (has_q && !has_qd && (state.posed != 0)) {
    const Real moved = way_to<Robot>(i, state.sound_q[i], input.q[i]);
    at.qd[i] = within(moved / config.period, config.speed[i]);
  }
  const Real onward = config.period * within(at.qd[i], config.speed[i]);
  at.q[i] = has_q ? input.q[i] : (state.sound_q[i] + onward);
}

/// Leads numbers that describe the robot a share nearer to what they have become.
template <size_t N, class Real>
inline void lead_to(const Real (&now)[N], Real share, Real (&led)[N]) noexcept {
  for (size_t i = 0; i < N; ++i) {
    led[i] = (share < Real(1)) ? (led[i] + (share * (now[i] - led[i]))) : now[i];
  }
}

/// The share of a change of the robot, such as a payload, that a step takes over: 98 % of it are
/// there after `fade`, so that the torque has no step. All of it in the first.
template <class Robot>
inline RealOf<Robot> adopted_share(const typename Robot::Config& config, bool first) noexcept {
  using Real = RealOf<Robot>;
  const Real part = Real(4) * config.period;
  return (!first && (part < config.fade)) ? (part / config.fade) : Real(1);
}

/// Fills in the state to compute with: what was measured, where all of it was `seen`. Returns
/// whether there is one: every coordinate has been measured, now or before, and the arguments that
/// change the robot are finite.
template <class Robot>
inline bool complete_state(const typename Robot::Config& config, const typename Robot::Input& input,
                           bool seen, Measured<Robot>& at, typename Robot::State& state) noexcept {
  if (!seen && (((state.posed == 0) && !all_finite(input.q)) || !Robot::finite(input))) {
    return false;
  }
  bool lost = false;
  for (int i = 0; i < Robot::kJoints; ++i) {
    if (seen) {
      at.lost[i] = false;
      at.q[i] = input.q[i];
      at.qd[i] = input.qd[i];
    } else {
      complete_joint<Robot>(config, input, i, at, state);
    }
    lost = lost || at.lost[i];
    state.sound_q[i] = at.q[i];
    state.sound_qd[i] = at.qd[i];
  }
  Robot::adopt(config, input, state.posed == 0, state);
  state.posed = 1;
  state.blind_ticks = lost ? state.blind_ticks : 0;
  Robot::measure(input, state, at);
  return true;
}

}  // namespace treeline::core
