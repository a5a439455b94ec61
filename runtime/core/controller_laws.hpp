#pragma once
// Laws of an emitted controller: references along quintic splines, and the commanded accelerations
// that follow them. C++17, freestanding, fixed size.
//
//   joints: qdd = a + 2 zeta w (v - qd) + w^2 (p - q), tau = M qdd + b + g
//   task:   xdd = a + 2 zeta w (v - xd) + w^2 e, tau = control_torque(xdd), see Khatib 1987
//   force:  along the direction n of a point, in place of the task's,
//           xdd . n = k (f - f_n + r integral (f - f_n)) - d xd . n,
//           and tau += J^T n f_n for the measured force f_n

#include "core/controller_measurement.hpp"
#include "core/quintic.hpp"
#include "core/square_root.hpp"
#include "core/turn_motion.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

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

/// Reference of the joints at this step.
template <class Robot>
inline void joint_reference(const typename Robot::Config& config,
                            const typename Robot::State& state, RealOf<Robot> (&p)[Robot::kJoints],
                            RealOf<Robot> (&v)[Robot::kJoints],
                            RealOf<Robot> (&a)[Robot::kJoints]) noexcept {
  const auto left = share_left(seconds(state.joint_ticks, config.period), state.joint_rate);
  quintic_at(&state.joint_motion[0], left, state.joint_rate, p, v, a);
}

/// Leads the joints from a state to rest in `goal`. The motion takes `duration`, and as much longer
/// as keeps a motion from rest within the limits of speed: it is fastest at 15/8 of its mean.
/// Joints that turn without end go the short way round.
template <class Robot>
inline void move_joints(const typename Robot::Config& config,
                        const RealOf<Robot> (&p)[Robot::kJoints],
                        const RealOf<Robot> (&v)[Robot::kJoints],
                        const RealOf<Robot> (&a)[Robot::kJoints],
                        const RealOf<Robot> (&goal)[Robot::kJoints], RealOf<Robot> duration,
                        typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  Real end[Robot::kJoints];
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real way = way_to<Robot>(i, p[i], goal[i]);
    end[i] = Robot::kTurns[i] ? (p[i] + way) : goal[i];
    const Real least = Real(1.875) * magnitude(way) / config.speed[i];
    duration = (duration > least) ? duration : least;
  }
  quintic_to_rest(p, v, a, end, duration, &state.joint_motion[0]);
  state.joint_rate = Real(1) / duration;
  state.joint_ticks = 0;
}

template <class Robot>
inline void joint_law(const typename Robot::Config& config, const typename Robot::Input& input,
                      typename Robot::State& state, typename Robot::Output& output,
                      RealOf<Robot> (&qdd)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  Real p[Robot::kJoints];
  Real v[Robot::kJoints];
  joint_reference<Robot>(config, state, p, v, qdd);
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real w = config.joint_frequency[i];
    output.joint_error[i] = way_to<Robot>(i, input.q[i], p[i]);
    qdd[i] += w * ((Real(2) * config.joint_damping[i] * (v[i] - input.qd[i])) +
                   (w * output.joint_error[i]));
  }
  count_tick(state.joint_ticks);
}

/// Reference of a point at this step.
template <class Robot>
inline void point_reference(const typename Robot::Config& config,
                            const typename Robot::State& state, int point,
                            PointMotion<RealOf<Robot>>& motion) noexcept {
  using Real = RealOf<Robot>;
  const Real rate = state.point_rate[point];
  const Real left = share_left(seconds(state.point_ticks[point], config.period), rate);
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
  for (int i = 0; i < 3; ++i) {
    motion.position[i] = x[i];
    motion.velocity[i] = v[i];
    motion.velocity[3 + i] = w[i];
    motion.acceleration[i] = a[i];
    motion.acceleration[3 + i] = wd[i];
  }
}

/// The duration, and as much longer as keeps a quintic motion from rest over `way` below `speed`.
template <class Real>
inline Real stretch(Real duration, const Real (&way)[3], Real speed) noexcept {
  const Real square = (way[0] * way[0]) + (way[1] * way[1]) + (way[2] * way[2]);
  const Real least = Real(1.875) * square_root(square) / speed;
  return (duration > least) ? duration : least;
}

/// Leads a point from a motion to rest in a pose, straight and about one axis if it is at rest. The
/// motion takes `duration`, and as much longer as keeps a motion from rest within `point_speed` and
/// `point_turn`.
template <class Robot>
inline void move_point(const typename Robot::Config& config, const PointMotion<RealOf<Robot>>& now,
                       const RealOf<Robot> (&position)[3], const RealOf<Robot> (&rotation)[9],
                       RealOf<Robot> duration, int point, typename Robot::State& state) noexcept {
  using Real = RealOf<Robot>;
  Real turn[3];
  Real way[3];
  orientation_error(now.rotation, rotation, turn);
  for (int i = 0; i < 3; ++i) {
    way[i] = position[i] - now.position[i];
  }
  duration = stretch(stretch(duration, way, config.point_speed), turn, config.point_turn);
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

/// Acceleration, world axes, that leads a point along its reference.
template <class Robot>
inline void point_law(const typename Robot::Config& config, const Measured<Robot>& at, int point,
                      typename Robot::State& state, typename Robot::Output& output,
                      RealOf<Robot> (&xdd)[6]) noexcept {
  using Real = RealOf<Robot>;
  PointMotion<Real> wanted;
  PointMotion<Real> now;
  Real error[6];
  point_reference<Robot>(config, state, point, wanted);
  measured_motion<Robot>(at, point, now);
  pose_error(now.position, now.rotation, wanted.position, wanted.rotation, error);
  for (int i = 0; i < 6; ++i) {
    const Real w = config.task_frequency[(6 * point) + i];
    output.task_error[(6 * point) + i] = error[i];
    xdd[i] = wanted.acceleration[i] + (w * ((Real(2) * config.task_damping[(6 * point) + i] *
                                             (wanted.velocity[i] - now.velocity[i])) +
                                            (w * error[i])));
  }
  count_tick(state.point_ticks[point]);
}

/// Force along `state.direction` in place of motion. The force that is measured is compensated, so
/// that the point moves along the direction as a mass 1 / force_gain would under what is missing,
/// damped, and nothing else moves: at rest in contact the force is the one that is wanted, and
/// without contact the point approaches with force_gain force / force_damping. The integral stops
/// where the last torque was cut. Against a spring the law is stable for force_rate below
/// force_damping (Routh). Returns the force, N, to compensate.
template <class Robot>
inline RealOf<Robot> force_law(const typename Robot::Config& config,
                               const typename Robot::Input& input, const Measured<Robot>& at,
                               typename Robot::State& state, typename Robot::Output& output,
                               RealOf<Robot> (&xdd)[6]) noexcept {
  using Real = RealOf<Robot>;
  const int point = state.press_point;
  const Real left = share_left(seconds(state.press_ticks, config.period), state.press_rate);
  const Real wanted = state.press_force * (Real(1) - fade_out(left));
  Real along = Real(0);
  Real speed = Real(0);
  Real measured = Real(0);
  for (int i = 0; i < 3; ++i) {
    along += state.direction[i] * xdd[i];
    speed += state.direction[i] * at.velocity[(6 * point) + i];
    measured += state.direction[i] * input.force[i];
  }
  const Real lack = wanted - measured;
  const Real more = (state.cut == 0) ? (config.force_rate * config.period * lack) : Real(0);
  state.force_integral = within(state.force_integral + more, config.largest_force);
  const Real acceleration =
      (config.force_gain * (lack + state.force_integral)) - (config.force_damping * speed);
  for (int i = 0; i < 3; ++i) {
    xdd[i] += state.direction[i] * (acceleration - along);
  }
  output.force_error = lack;
  count_tick(state.press_ticks);
  return within(measured, config.largest_force);
}

/// How far a reference may be away: `following`, and half of that once it has stood for a second.
template <class Robot>
inline RealOf<Robot> admitted_error(const typename Robot::Config& config, int32_t ticks,
                                    RealOf<Robot> rate) noexcept {
  const bool stands =
      ((seconds(ticks, config.period) - RealOf<Robot>(1)) * rate) > RealOf<Robot>(1);
  return stands ? (RealOf<Robot>(0.5) * config.following) : config.following;
}

/// Whether all joints are near their reference.
template <class Robot>
inline bool joints_follow(const typename Robot::Config& config, const typename Robot::State& state,
                          const typename Robot::Output& output) noexcept {
  const RealOf<Robot> most = admitted_error<Robot>(config, state.joint_ticks, state.joint_rate);
  bool follow = true;
  for (int i = 0; i < Robot::kJoints; ++i) {
    follow = follow && (magnitude(output.joint_error[i]) <= most);
  }
  return follow;
}

/// Whether a point is near its reference, in position and orientation, each where all three of its
/// rows are controlled. Where the point presses its position is free.
template <class Robot>
inline bool point_follows(const typename Robot::Config& config, int point,
                          const typename Robot::State& state,
                          const typename Robot::Output& output) noexcept {
  using Real = RealOf<Robot>;
  const Real most =
      admitted_error<Robot>(config, state.point_ticks[point], state.point_rate[point]);
  bool pressed = false;
  if constexpr (Robot::kForce) {
    pressed = (state.pressing != 0) && (state.press_point == point);
  }
  bool follows = true;
  for (int part = pressed ? 3 : 0; part < 6; part += 3) {
    const int row = (6 * point) + part;
    const bool controlled =
        Robot::kControls[row] && Robot::kControls[row + 1] && Robot::kControls[row + 2];
    for (int i = 0; i < 3; ++i) {
      follows = follows && (!controlled || (magnitude(output.task_error[row + i]) <= most));
    }
  }
  return follows;
}

/// Whether the law's references are followed.
template <class Robot>
inline bool follows(const typename Robot::Config& config, const typename Robot::State& state,
                    const typename Robot::Output& output) noexcept {
  if constexpr (Robot::kTask) {
    if (state.law == Robot::kTaskLaw) {
      bool all = true;
      for (int point = 0; point < Robot::kPoints; ++point) {
        all = all && point_follows<Robot>(config, point, state, output);
      }
      return all;
    }
  }
  return joints_follow<Robot>(config, state, output);
}

/// Rows of the task among the six accelerations of each point, in world axes or the point's own. As
/// these turn, velocities along them have rates less by w x v.
template <class Robot>
inline void select_rows(const Measured<Robot>& at, int point, const RealOf<Robot> (&xdd)[6],
                        int& row, RealOf<Robot> (&xdd_cmd)[Robot::kRows]) noexcept {
  using Real = RealOf<Robot>;
  Real turning[3] = {Real(0), Real(0), Real(0)};
  if (Robot::kOwnAxes[point]) {
    const Real* const moved = &at.velocity[6 * point];
    const Real v[3] = {moved[0], moved[1], moved[2]};
    const Real w[3] = {moved[3], moved[4], moved[5]};
    steps::cross(w, v, turning);
  }
  for (int i = 0; i < 6; ++i) {
    if (!Robot::kControls[(6 * point) + i]) {
      continue;
    }
    Real value = xdd[i];
    if (Robot::kOwnAxes[point]) {
      const int part = (i < 3) ? 0 : 3;
      value = Real(0);
      for (int k = 0; k < 3; ++k) {
        const Real rate = (i < 3) ? (xdd[k] - turning[k]) : xdd[3 + k];
        value += at.rotation[(9 * point) + (3 * k) + (i - part)] * rate;
      }
    }
    xdd_cmd[row] = value;
    ++row;
  }
}

/// Inputs of the task's torque: accelerations of the task's rows and of the posture. `force` is
/// what the point that presses exerts along the state's direction, N.
template <class Robot>
inline void task_law(const typename Robot::Config& config, const typename Robot::Input& input,
                     const Measured<Robot>& at, typename Robot::State& state,
                     typename Robot::Output& output, RealOf<Robot> (&qdd_0)[Robot::kJoints],
                     RealOf<Robot> (&xdd_cmd)[Robot::kRows], RealOf<Robot>& force) noexcept {
  using Real = RealOf<Robot>;
  int row = 0;
  for (int point = 0; point < Robot::kPoints; ++point) {
    Real xdd[6];
    point_law<Robot>(config, at, point, state, output, xdd);
    if constexpr (Robot::kForce) {
      if ((state.pressing != 0) && (point == state.press_point)) {
        force = force_law<Robot>(config, input, at, state, output, xdd);
      }
    }
    select_rows<Robot>(at, point, xdd, row, xdd_cmd);
  }
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real w = config.posture_frequency[i];
    qdd_0[i] = w * ((w * way_to<Robot>(i, input.q[i], state.posture[i])) - (Real(2) * input.qd[i]));
  }
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
