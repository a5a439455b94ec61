#pragma once
// References of an emitted controller: quintic splines to goals, stretched where limits of speed
// ask for it. C++17, freestanding, fixed size.

#include "core/controller_measurement.hpp"
#include "core/quintic.hpp"
#include "core/square_root.hpp"
#include "core/turn_motion.hpp"

namespace treeline::core {

/// Whether the point exerts a force in place of moving.
template <class Robot>
inline bool is_pressing(const typename Robot::State& state, int point) noexcept {
  if constexpr (Robot::kForce) {
    return (state.pressing != 0) && (state.press_point == point);
  }
  return false;
}

/// Desired motion of one point in world axes, linear over angular.
template <class Real>
struct PointMotion {
  Real position[3];
  Real rotation[9];
  Real velocity[6];
  Real acceleration[6];
};

template <size_t N, class Real>
inline void copy_numbers(const Real* from, Real (&to)[N]) noexcept {
  for (size_t i = 0; i < N; ++i) {
    to[i] = from[i];
  }
}

template <class Real>
inline Real seconds(int32_t ticks, Real period) noexcept {
  return static_cast<Real>(ticks) * period;
}

/// Counts a step; stops where a counter would run over.
inline void count_tick(int32_t& ticks) noexcept {
  constexpr int32_t kMost = 0x3fffffff;
  ticks += (ticks < kMost) ? 1 : 0;
}

/// Share of duration times speed that a stop takes which does not turn back (quintic, whose first
/// coefficient is then 0).
template <class Real>
inline constexpr Real kStopShare = Real(0.4);

/// Reference of the joints at this step.
template <class Robot>
inline void joint_reference(const typename Robot::Config& config,
                            const typename Robot::State& state, RealOf<Robot> (&p)[Robot::kJoints],
                            RealOf<Robot> (&v)[Robot::kJoints],
                            RealOf<Robot> (&a)[Robot::kJoints]) noexcept {
  const auto left = share_left(seconds(state.joint_ticks, config.period), state.joint_rate);
  quintic_at(&state.joint_motion[0], left, state.joint_rate, p, v, a);
}

/// The duration, and as much longer as keeps a motion over `way` within its limit of speed, which
/// it reaches within `rise` seconds at the soonest. `way` is a share of the limit times a second,
/// `speed` the share of it that the motion begins with. From rest a quintic is fastest at 15/8 of
/// its mean, and its acceleration is largest at 10/sqrt(3) way / duration^2; from a speed v that of
/// a stop is 4 v / duration.
template <class Real>
inline Real stretch(Real duration, Real way, Real speed, Real rise) noexcept {
  const Real by_speed = Real(1.875) * way * (Real(1) + (Real(0.8) * speed));
  const Real by_rise = square_root(Real(5.7735) * way * rise);
  const Real by_stop = Real(4) * speed * rise;
  duration = (duration > by_speed) ? duration : by_speed;
  duration = (duration > by_rise) ? duration : by_rise;
  return (duration > by_stop) ? duration : by_stop;
}

/// Whether the duration is at least a step, and at most an hour, up to which time can be counted.
template <class Real>
constexpr bool is_duration(Real duration, Real period) noexcept {
  return (duration >= period) && (duration <= Real(3600));
}

/// Whether a motion of the joints stays within their limits on its way, at 15 places of it. From
/// rest it does; in the midst of a motion it may swing out.
template <class Robot>
inline bool stays_within(const typename Robot::Config& config,
                         const RealOf<Robot> (&motion)[4 * Robot::kJoints],
                         const RealOf<Robot> (&from)[Robot::kJoints], RealOf<Robot> rate) noexcept {
  using Real = RealOf<Robot>;
  constexpr Real kStep = Real(0.0625);
  bool within_all = true;
  for (int k = 1; k < 16; ++k) {
    Real p[Robot::kJoints];
    Real v[Robot::kJoints];
    Real a[Robot::kJoints];
    quintic_at(&motion[0], kStep * static_cast<Real>(k), rate, p, v, a);
    for (int i = 0; i < Robot::kJoints; ++i) {
      const Real margin = Real(0.5) * config.position_margin;
      const Real most = (Real(1) + (Real(0.5) * config.speed_margin)) * config.speed[i];
      within_all = within_all && ((p[i] <= (config.upper[i] + margin)) || (p[i] <= from[i])) &&
                   ((p[i] >= (config.lower[i] - margin)) || (p[i] >= from[i])) &&
                   (magnitude(v[i]) <= most);
    }
  }
  return within_all;
}

/// Leads the joints from a state to rest in `goal`. The motion takes `duration`, and as much longer
/// as keeps it within the limits of speed. Joints that turn without end go the short way round.
/// Returns whether there is such a motion; where there is none the old one goes on.
template <class Robot>
inline bool move_joints(const typename Robot::Config& config,
                        const RealOf<Robot> (&p)[Robot::kJoints],
                        const RealOf<Robot> (&v)[Robot::kJoints],
                        const RealOf<Robot> (&a)[Robot::kJoints],
                        const RealOf<Robot> (&goal)[Robot::kJoints], RealOf<Robot> duration,
                        typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  Real end[Robot::kJoints];
  Real longest = Real(0);
  Real fastest = Real(0);
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real way = way_to<Robot>(i, p[i], goal[i]);
    end[i] = Robot::kTurns[i] ? (p[i] + way) : goal[i];
    const Real share = magnitude(way) / config.speed[i];
    const Real speed = magnitude(v[i]) / config.speed[i];
    longest = (share > longest) ? share : longest;
    fastest = (speed > fastest) ? speed : fastest;
  }
  duration = stretch(duration, longest, fastest, config.speed_rise);
  Real motion[4 * Robot::kJoints];
  quintic_to_rest(p, v, a, end, duration, &motion[0]);
  const Real rate = Real(1) / duration;
  if (!is_duration(duration, config.period) ||
      ((fastest > Real(0)) && !stays_within<Robot>(config, motion, p, rate))) {
    return false;
  }
  copy_numbers(&motion[0], state.joint_motion);
  state.joint_rate = rate;
  state.joint_ticks = 0;
  return true;
}

/// Seconds that all joints take to stop without turning back.
template <class Robot>
inline RealOf<Robot> stop_duration(const typename Robot::Config& config,
                                   const Measured<Robot>& at) noexcept {
  using Real = RealOf<Robot>;
  Real duration = config.period;
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real least = Real(1.8) * config.speed_rise * magnitude(at.qd[i]) / config.speed[i];
    duration = (duration > least) ? duration : least;
  }
  return duration;
}

/// Leads the joints from their present motion to rest as soon as they may, without turning back,
/// and within their limits of position.
template <class Robot>
inline void stop_joints(const typename Robot::Config& config, const Measured<Robot>& at,
                        typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  const Real duration = stop_duration<Robot>(config, at);
  Real still[Robot::kJoints];
  Real end[Robot::kJoints];
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real q = at.q[i];
    const Real onward = q + (kStopShare<Real> * duration * at.qd[i]);
    const Real most = (q > config.upper[i]) ? q : config.upper[i];
    const Real least = (q < config.lower[i]) ? q : config.lower[i];
    end[i] = (onward > most) ? most : ((onward < least) ? least : onward);
    still[i] = Real(0);
  }
  quintic_to_rest(at.q, at.qd, still, end, duration, &state.joint_motion[0]);
  state.joint_rate = Real(1) / duration;
  state.joint_ticks = 0;
  state.law = Robot::kJointLaw;
}

/// Seconds that a point's reference has moved on. Its clock runs slower than that of the steps, and
/// stands, where the robot cannot follow.
template <class Robot>
inline RealOf<Robot> point_time(const typename Robot::Config& config,
                                const typename Robot::State& state, int point) noexcept {
  return seconds(state.point_ticks[point], config.period) - state.point_lag[point];
}

/// Reference of a point at this step.
template <class Robot>
inline void point_reference(const typename Robot::Config& config,
                            const typename Robot::State& state, int point,
                            PointMotion<RealOf<Robot>>& motion) noexcept {
  using Real = RealOf<Robot>;
  const Real rate = state.point_rate[point];
  const Real left = share_left(point_time<Robot>(config, state, point), rate);
  Real x[6];
  Real v[6];
  Real a[6];
  quintic_at(&state.point_motion[24 * point], left, rate, x, v, a);
  const Real turn[3] = {x[3], x[4], x[5]};
  const Real turn_rate[3] = {v[3], v[4], v[5]};
  const Real turn_bend[3] = {a[3], a[4], a[5]};
  Real w[3];
  Real wd[3];
  turn_rates(turn, turn_rate, turn_bend, w, wd);
  Real turned[9];
  Real from[9];
  rotation_from_vector(turn, turned);
  copy_numbers(&state.point_from[9 * point], from);
  turn_by(turned, from, motion.rotation);
  const Real pace = Real(1) - state.point_slow[point];
  const Real change = -state.point_slow_rate[point];
  for (int i = 0; i < 3; ++i) {
    motion.position[i] = x[i];
    motion.velocity[i] = pace * v[i];
    motion.velocity[3 + i] = pace * w[i];
    motion.acceleration[i] = (pace * pace * a[i]) + (change * v[i]);
    motion.acceleration[3 + i] = (pace * pace * wd[i]) + (change * w[i]);
  }
}

/// The larger of the lengths of two vectors, as shares of `most` and `most_turn`.
template <class Real>
inline Real larger_share(const Real (&x)[3], Real most, const Real (&turn)[3],
                         Real most_turn) noexcept {
  const Real length = square_root(steps::squared_norm(x)) / most;
  const Real angle = square_root(steps::squared_norm(turn)) / most_turn;
  return (length > angle) ? length : angle;
}

/// Leads a point from a motion to rest in a pose, straight and about one axis if it is at rest. The
/// motion takes `duration`, and as much longer as keeps it within `point_speed` and `point_turn`.
/// Returns whether there is such a motion; where there is none the old one goes on.
template <class Robot>
inline bool move_point(const typename Robot::Config& config, const PointMotion<RealOf<Robot>>& now,
                       const RealOf<Robot> (&position)[3], const RealOf<Robot> (&rotation)[9],
                       RealOf<Robot> duration, int point, typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  Real turn[3];
  Real way[3];
  Real v[3];
  Real w[3];
  orientation_error(now.rotation, rotation, turn);
  for (int i = 0; i < 3; ++i) {
    way[i] = position[i] - now.position[i];
    v[i] = now.velocity[i];
    w[i] = now.velocity[3 + i];
  }
  duration = stretch(duration, larger_share(way, config.point_speed, turn, config.point_turn),
                     larger_share(v, config.point_speed, w, config.point_turn), config.speed_rise);
  if (!is_duration(duration, config.period)) {
    return false;
  }
  Real from[6];
  Real to[6];
  for (int i = 0; i < 3; ++i) {
    from[i] = now.position[i];
    from[3 + i] = Real(0);
    to[i] = position[i];
    to[3 + i] = turn[i];
  }
  quintic_to_rest(from, now.velocity, now.acceleration, to, duration,
                  &state.point_motion[24 * point]);
  for (int i = 0; i < 9; ++i) {
    state.point_from[(9 * point) + i] = now.rotation[i];
  }
  state.point_rate[point] = Real(1) / duration;
  state.point_ticks[point] = 0;
  state.point_lag[point] = Real(0);
  state.point_slow[point] = Real(0);
  state.point_slow_rate[point] = Real(0);
  return true;
}

/// The measured motion of a point, without its acceleration.
template <class Robot>
inline void measured_motion(const Measured<Robot>& at, int point,
                            PointMotion<RealOf<Robot>>& motion) noexcept {
  copy_numbers(&at.position[3 * point], motion.position);
  copy_numbers(&at.rotation[9 * point], motion.rotation);
  copy_numbers(&at.velocity[6 * point], motion.velocity);
  for (RealOf<Robot>& a : motion.acceleration) {
    a = RealOf<Robot>(0);
  }
}

}  // namespace treeline::core
