#pragma once
// Laws of an emitted controller: references along quintic splines, and the commanded accelerations
// that follow them. C++17, freestanding, fixed size.
//
//   joints: qdd = a + 2 zeta w (v - qd) + w^2 (p - q), tau = M qdd + b + g
//   task:   xdd = a + 2 zeta w (v - xd) + w^2 e, tau = control_torque(xdd), see Khatib 1987
//   force:  along the direction n of a point, in place of the task's,
//           xdd . n = k (f - f_n + r integral (f - f_n)) - d xd . n,
//           and tau += J^T n f_n for the measured force f_n

#include "core/controller_references.hpp"

namespace treeline::core {

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

/// Whether all three rows are controlled of which `row` is one, of position or of orientation.
template <class Robot>
constexpr bool is_whole(int row) noexcept {
  const int first = row - (row % 3);
  return Robot::kControls[first] && Robot::kControls[first + 1] && Robot::kControls[first + 2];
}

/// Larger than any bound, with room for a product.
template <class Real>
inline constexpr Real kUnbounded = Real(1e15);

/// How a point should move and does, and the way from one pose to the other, m and rad, world axes.
template <class Robot>
inline void compare_point(const typename Robot::Config& config, const Measured<Robot>& at,
                          const typename Robot::State& state, int point,
                          PointMotion<RealOf<Robot>>& wanted, PointMotion<RealOf<Robot>>& now,
                          RealOf<Robot> (&error)[6]) noexcept {
  point_reference<Robot>(config, state, point, wanted);
  measured_motion<Robot>(at, point, now);
  pose_error(now.position, now.rotation, wanted.position, wanted.rotation, error);
}

/// Adds the torque against forces and moments on the points, which `Robot::push_torque` gives.
template <class Robot, size_t N>
inline void add_push_torque(const typename Robot::Input& input, const Measured<Robot>& at,
                            const typename Robot::State& state, const RealOf<Robot> (&f)[N],
                            RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  RealOf<Robot> push[Robot::kJoints];
  Robot::push_torque(input, state, at, f, push);
  for (int i = 0; i < Robot::kJoints; ++i) {
    tau[i] += push[i];
  }
}

/// Acceleration, world axes, that leads a point along its reference. What leads a point back is
/// bounded where all three directions are controlled: it brings it nearer with half of its limit of
/// speed, by twice the acceleration of references. So errors that are large make no torque that is.
template <class Robot>
inline void point_law(const typename Robot::Config& config, const Measured<Robot>& at, int point,
                      typename Robot::State& state, typename Robot::Output& output,
                      RealOf<Robot> (&xdd)[6]) noexcept {
  using Real = RealOf<Robot>;
  PointMotion<Real> wanted;
  PointMotion<Real> now;
  Real error[6];
  compare_point<Robot>(config, at, state, point, wanted, now, error);
  const Real rise = (config.speed_rise > config.period) ? config.speed_rise : config.period;
  for (int i = 0; i < 6; ++i) {
    const int row = (6 * point) + i;
    const Real w = config.task_frequency[row];
    const Real fastest = (i < 3) ? config.point_speed : config.point_turn;
    const Real most = is_whole<Robot>(row) ? fastest : kUnbounded<Real>;
    output.task_error[row] = error[i];
    const Real slower = Real(2) * config.task_damping[row] * (wanted.velocity[i] - now.velocity[i]);
    const Real back = w * (slower + within(w * error[i], most));
    xdd[i] = wanted.acceleration[i] + within(back, Real(2) * most / rise);
  }
  const bool moves = (point_time<Robot>(config, state, point) * state.point_rate[point]) < Real(1);
  state.point_lag[point] += moves ? (state.point_slow[point] * config.period) : Real(0);
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
      if (is_pressing<Robot>(state, point)) {
        force = force_law<Robot>(config, input, at, state, output, xdd);
      }
    }
    select_rows<Robot>(at, point, xdd, row, xdd_cmd);
  }
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real w = config.posture_frequency[i];
    const Real way = way_to<Robot>(i, input.q[i], state.posture[i]);
    const Real wanted = within(w * way, config.speed[i]);  // twice what the joint gets to
    qdd_0[i] = w * (wanted - (Real(2) * input.qd[i]));
  }
}

}  // namespace treeline::core
