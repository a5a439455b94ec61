#pragma once
// The safe state of an emitted controller: the robot is braked along a reference that slows down,
// and then held where that comes to rest. C++17, freestanding, fixed size.

#include "core/controller_laws.hpp"

namespace treeline::core {

/// Begins to brake from the present motion.
template <class Robot>
inline void start_braking(const typename Robot::Config& config, const Measured<Robot>& at,
                          typename Robot::State& state) noexcept {
  state.braking = 1;
  state.brake_share = RealOf<Robot>(0);
  for (int i = 0; i < Robot::kJoints; ++i) {
    state.brake_q[i] = at.q[i];
    state.brake_qd[i] = within(at.qd[i], config.speed[i]);
    state.stand_q[i] = at.q[i];
    state.load[i] = RealOf<Robot>(0);
  }
}

/// Lets the braking begin gently: its share of `brake_damping` grows to 1 within twice the time
/// that a torque needs to rise to its limit.
template <class Robot>
inline RealOf<Robot> grow_braking(const typename Robot::Config& config,
                                  typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  Real slowest = config.torque_rate[0] / config.torque[0];
  for (int i = 1; i < Robot::kJoints; ++i) {
    const Real rate = config.torque_rate[i] / config.torque[i];
    slowest = (rate < slowest) ? rate : slowest;
  }
  const Real share = state.brake_share + (Real(0.5) * slowest * config.period);
  state.brake_share = (share < Real(1)) ? share : Real(1);
  return config.brake_damping * state.brake_share;
}

/// Moves a joint's reference on by one step: it slows down by `damping`, stands at a limit of
/// position, and stays within `hold_reach` of the joint. Returns whether it stands.
template <class Robot>
inline bool move_brake_reference(const typename Robot::Config& config, const Measured<Robot>& at,
                                 RealOf<Robot> damping, int i,
                                 typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  const bool stands = magnitude(state.brake_qd[i]) <= config.rest_speed;
  const Real before = state.brake_q[i];
  const Real slower = Real(1) - (damping * config.period);
  state.brake_qd[i] = stands ? Real(0) : (slower * state.brake_qd[i]);
  Real next = before + (config.period * state.brake_qd[i]);
  if (((next > config.upper[i]) && (next > before)) ||
      ((next < config.lower[i]) && (next < before))) {
    next = before;
    state.brake_qd[i] = Real(0);
  }
  const Real ahead = way_to<Robot>(i, at.q[i], next);
  const bool beyond = magnitude(ahead) > config.hold_reach;
  state.brake_q[i] = beyond ? (at.q[i] + within(ahead, config.hold_reach)) : next;
  state.stand_q[i] = stands ? state.stand_q[i] : state.brake_q[i];
  return stands;
}

/// Acceleration that leads a joint along its reference, critically damped with `hold_frequency`.
template <class Robot>
inline RealOf<Robot> brake_acceleration(const typename Robot::Config& config,
                                        const Measured<Robot>& at, RealOf<Robot> damping, int i,
                                        const typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  const Real w = config.hold_frequency;
  const Real error = way_to<Robot>(i, at.q[i], state.brake_q[i]);
  return (w * ((Real(2) * (state.brake_qd[i] - at.qd[i])) + (w * error))) -
         (damping * state.brake_qd[i]);
}

/// Torque of a spring at a share of `hold_reach`: soft near its reference, firm at the reach, up to
/// three fifths of the motor's torque. It bears what the law by inertias cannot, a payload on a
/// light wrist. Where the torque has no limit there is none.
template <class Robot>
inline RealOf<Robot> firm_torque(const typename Robot::Config& config, int i,
                                 RealOf<Robot> share) noexcept {
  using Real = RealOf<Robot>;
  constexpr Real kLargest = Real(1000000);  // N m
  const Real most = (config.torque[i] < kLargest) ? (Real(0.6) * config.torque[i]) : Real(0);
  return most * share * share * share;
}

/// Torque of the firm spring, which damps as it stiffens, and of the load that it has handed over.
/// While the joint stands, the spring hands over what it bears beyond half its reach, within some
/// tenths of a second: the torque stays, and the reference comes near the joint again.
template <class Robot>
inline RealOf<Robot> hold_torque(const typename Robot::Config& config, const Measured<Robot>& at,
                                 int i, bool stands, typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  constexpr Real kDampingTime = Real(0.01);  // s
  const Real share =
      within(way_to<Robot>(i, at.q[i], state.brake_q[i]) / config.hold_reach, Real(1));
  const Real firm = firm_torque<Robot>(config, i, share);
  const Real slope =
      (magnitude(share) > Real(0.01)) ? (Real(3) * firm / (share * config.hold_reach)) : Real(0);
  const Real damping =
      within(slope * kDampingTime * (state.brake_qd[i] - at.qd[i]), Real(0.6) * config.torque[i]);
  if (stands && (magnitude(share) > Real(0.5))) {
    const Real rate = Real(10) * config.period;
    const Real left =
        share - (((rate < Real(1)) ? rate : Real(1)) * (share - within(share, Real(0.5))));
    state.load[i] =
        within(state.load[i] + (firm - firm_torque<Robot>(config, i, left)), config.torque[i]);
    state.brake_q[i] = at.q[i] + (left * config.hold_reach);
    return firm_torque<Robot>(config, i, left) + damping + state.load[i];
  }
  return firm + damping + state.load[i];
}

/// Torque that brakes the robot to rest and holds it there. A joint of which nothing is measured is
/// held against gravity alone, for `blind_ticks` steps. Returns whether a joint that stood was
/// dragged away by more than twice `hold_reach`. NaN where the state was beyond all numbers.
template <class Robot>
inline bool brake_torque(const typename Robot::Config& config, const typename Robot::Input& input,
                         const Measured<Robot>& at, typename Robot::State& state,
                         RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  if (state.braking == 0) {
    start_braking<Robot>(config, at, state);
  }
  const Real damping = grow_braking<Robot>(config, state);
  bool dragged = false;
  bool lost = false;
  const bool lately = state.blind_ticks < config.blind_ticks;
  Real qdd[Robot::kJoints];
  Real held[Robot::kJoints];
  for (int i = 0; i < Robot::kJoints; ++i) {
    lost = lost || at.lost[i];
    if (at.lost[i]) {
      state.brake_q[i] = at.q[i];
      state.brake_qd[i] = Real(0);
      qdd[i] = Real(0);
      held[i] = Real(0);
    } else {
      const bool stands = move_brake_reference<Robot>(config, at, damping, i, state);
      held[i] = hold_torque<Robot>(config, at, i, stands, state);
      qdd[i] = brake_acceleration<Robot>(config, at, damping, i, state);
      const Real moved = magnitude(way_to<Robot>(i, state.stand_q[i], at.q[i]));
      dragged = dragged || (moved > (Real(2) * config.hold_reach));
    }
  }
  Robot::joint_torque(input, state, at, qdd, tau);
  for (int i = 0; i < Robot::kJoints; ++i) {
    tau[i] = (at.lost[i] && !lately) ? Real(0) : (tau[i] + held[i]);
  }
  state.blind_ticks += (lost && lately) ? 1 : 0;
  return dragged;
}

/// Whether the reference stands, and the robot within its reach, whatever noise velocities have.
template <class Robot>
inline bool rests(const typename Robot::Config& config, const Measured<Robot>& at,
                  const typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  bool rests = true;
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real away = magnitude(way_to<Robot>(i, at.q[i], state.brake_q[i]));
    rests = rests && (magnitude(state.brake_qd[i]) <= config.rest_speed) &&
            (away <= (Real(0.6) * config.hold_reach)) && !at.lost[i];
  }
  return rests;
}

/// The torque that holds the robot at rest, within its limits.
template <class Robot>
inline void hold_gravity(const typename Robot::Config& config, const Measured<Robot>& at,
                         typename Robot::State& state) noexcept {
  for (int i = 0; i < Robot::kJoints; ++i) {
    state.held[i] = within(at.gravity[i], config.torque[i]);
  }
}

/// Torque of a robot of which nothing can be computed: what held it against gravity when something
/// last could, and nothing once that is too long ago, when mechanical brakes have taken over.
template <class Robot>
inline void blind_torque(const typename Robot::Config& config, typename Robot::State& state,
                         RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  const bool lately = state.blind_ticks < config.blind_ticks;
  for (int i = 0; i < Robot::kJoints; ++i) {
    tau[i] = lately ? state.held[i] : RealOf<Robot>(0);
  }
  state.blind_ticks += lately ? 1 : 0;
}

}  // namespace treeline::core
