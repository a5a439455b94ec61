#pragma once
// Laws of a controller: commanded accelerations that follow the references.
//
//   joints: qdd = a + 2 zeta w (v - qd) + w^2 (p - q), tau = M qdd + b + g
//   task:   xdd = a + 2 zeta w (v - xd) + w^2 e, tau = control_torque(xdd), see
//           Khatib 1987
//   force:  along the direction n of a point, in place of the task's,
//           xdd . n = k (f - f_n + r integral (f - f_n)) - d xd . n,
//           and tau += J^T n f_n for the measured force f_n

#include "controller_points.h"

TL_INLINE void tl_joint_law(const TlConfig* config, const TlMeasured* at,
    TlState* state, TlOutput* output, TlJointsOut qdd) {
  real p[TL_JOINTS];
  real v[TL_JOINTS];
  tl_joint_reference(config, state, &p[0], &v[0], &qdd[0]);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real w = config->joint_frequency[i];
    output->joint_error[i] = tl_way_to(i, at->q[i], p[i]);
    qdd[i] += w *
        ((TL_REAL(2.0) * config->joint_damping[i] * (v[i] - at->qd[i])) +
            (w * output->joint_error[i]));
  }
  state->joint_ticks = tl_count_tick(state->joint_ticks);
}

#if TL_TASK
/// Whether all three rows are controlled of which `row` is one, of position or of
/// orientation.
TL_INLINE bool tl_is_whole(int32_t row) {
  const int32_t first = row - (row % 3);
  return TL_CONTROLS[first] && TL_CONTROLS[first + 1] && TL_CONTROLS[first + 2];
}

/// How a point should move and does, and the way from one pose to the other, m and
/// rad, world axes.
TL_INLINE void tl_compare_point(const TlConfig* config, const TlMeasured* at,
    const TlState* state, int32_t point, TlPointMotion* wanted, TlPointMotion* now,
    real* error) {
  tl_point_reference(config, state, point, wanted);
  tl_measured_motion(at, point, now);
  tl_pose_error(&now->position[0], &now->rotation[0], &wanted->position[0],
      &wanted->rotation[0], error);
}

/// Acceleration, world axes, that leads a point along its reference. What leads a
/// point back is bounded where all three directions are controlled: it brings it
/// nearer with half of its limit of speed, by twice the acceleration of references.
/// So errors that are large make no torque that is.
TL_INLINE void tl_point_law(const TlConfig* config, const TlMeasured* at,
    int32_t point, TlState* state, TlOutput* output, real* xdd) {
  TlPointMotion wanted;
  TlPointMotion now;
  real error[6];
  tl_compare_point(config, at, state, point, &wanted, &now, &error[0]);
  const real rise = tl_larger(config->speed_rise, config->period);
  for (int32_t i = 0; i < 6; ++i) {
    const int32_t row = (6 * point) + i;
    const real w = config->task_frequency[row];
    const real fastest = (i < 3) ? config->point_speed : config->point_turn;
    // Larger than any bound, with room for a product.
    const real most = tl_is_whole(row) ? fastest : TL_REAL(1e15);
    output->task_error[row] = error[i];
    const real slower = TL_REAL(2.0) * config->task_damping[row] *
        (wanted.velocity[i] - now.velocity[i]);
    const real back = w * (slower + tl_within(w * error[i], most));
    xdd[i] = wanted.acceleration[i] + tl_within(back, TL_REAL(2.0) * most / rise);
  }
  const bool moves =
      (tl_point_time(config, state, point) * state->point_rate[point]) < TL_ONE;
  state->point_lag[point] +=
      moves ? (state->point_slow[point] * config->period) : TL_ZERO;
  state->point_ticks[point] = tl_count_tick(state->point_ticks[point]);
}

#if TL_FORCE
/// Force along `state.direction` in place of motion. The force that is measured is
/// compensated, so that the point moves along the direction as a mass 1 / force_gain
/// would under what is missing, damped, and nothing else moves: at rest in contact
/// the force is the one that is wanted, and without contact the point approaches with
/// force_gain force / force_damping. The integral stops where the last torque was
/// cut. Against a spring the law is stable for force_rate below force_damping
/// (Routh). Returns the force, N, to compensate.
TL_INLINE real tl_force_law(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, TlOutput* output, real* xdd) {
  const real* const velocity = &at->velocity[6 * state->press_point];
  const real left = tl_share_left(
      tl_seconds(state->press_ticks, config->period), state->press_rate);
  const real wanted = state->press_force * (TL_ONE - tl_fade_out(left));
  real along = TL_ZERO;
  real speed = TL_ZERO;
  real measured = TL_ZERO;
  for (int32_t i = 0; i < 3; ++i) {
    along += state->direction[i] * xdd[i];
    speed += state->direction[i] * velocity[i];
    measured += state->direction[i] * input->force[i];
  }
  const real lack = wanted - measured;
  const real more =
      (state->cut == 0) ? (config->force_rate * config->period * lack) : TL_ZERO;
  state->force_integral =
      tl_within(state->force_integral + more, config->largest_force);
  const real acceleration = (config->force_gain * (lack + state->force_integral)) -
      (config->force_damping * speed);
  for (int32_t i = 0; i < 3; ++i) {
    xdd[i] += state->direction[i] * (acceleration - along);
  }
  output->force_error = lack;
  state->press_ticks = tl_count_tick(state->press_ticks);
  return tl_within(measured, config->largest_force);
}

/// Adds the torque against forces and moments on the points.
TL_INLINE void tl_add_push_torque(const TlInput* input, const TlState* state,
    const TlMeasured* at, TlForcesIn f, TlJointsOut tau) {
  real push[TL_JOINTS];
  tl_push_torque(input, state, at, f, push);
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    tau[i] += push[i];
  }
}

/// tau += J^T n force, which bears the reaction to `force` along the direction n of
/// the point that presses.
TL_INLINE void tl_add_push(const TlInput* input, const TlState* state,
    const TlMeasured* at, real force, TlJointsOut tau) {
  real f[6 * TL_POINTS];
  for (int32_t i = 0; i < (6 * TL_POINTS); ++i) {
    const int32_t axis = i - (6 * state->press_point);
    f[i] = ((axis >= 0) && (axis < 3)) ? (-force * state->direction[axis]) : TL_ZERO;
  }
  tl_add_push_torque(input, state, at, f, tau);
}
#endif

/// Rows of the task among the six accelerations of each point, in world axes or the
/// point's own. As these turn, velocities along them have rates less by w x v.
TL_INLINE void tl_select_rows(const TlMeasured* at, int32_t point, const real* xdd,
    int32_t* row, TlRowsOut xdd_cmd) {
  const real* const velocity = &at->velocity[6 * point];
  real turning[3] = {TL_ZERO, TL_ZERO, TL_ZERO};
  if (TL_OWN_AXES[point]) {
    tl_cross(&velocity[3], &velocity[0], &turning[0]);
  }
  for (int32_t i = 0; i < 6; ++i) {
    if (TL_CONTROLS[(6 * point) + i]) {
      real value = xdd[i];
      if (TL_OWN_AXES[point]) {
        const int32_t part = 3 * (i / 3);
        value = TL_ZERO;
        for (int32_t k = 0; k < 3; ++k) {
          const real rate = (i < 3) ? (xdd[k] - turning[k]) : xdd[3 + k];
          value += at->rotation[(9 * point) + (3 * k) + (i - part)] * rate;
        }
      }
      xdd_cmd[*row] = value;
      *row += 1;
    }
  }
}

/// Torque of the task: accelerations of its rows and of the posture, and the force of
/// the point that presses.
TL_INLINE void tl_task_law(const TlConfig* config, const TlInput* input,
    const TlMeasured* at, TlState* state, TlOutput* output, TlJointsOut tau) {
  real qdd_0[TL_JOINTS];
  real xdd_cmd[TL_ROWS];
#if TL_FORCE
  real force = TL_ZERO;
#endif
  int32_t row = 0;
#if TL_BEHAVES
  tl_lead_shares(config, at, state);
#endif
  for (int32_t point = 0; point < TL_POINTS; ++point) {
    real xdd[6];
    tl_point_law(config, at, point, state, output, &xdd[0]);
#if TL_FORCE
    if (tl_is_pressing(state, point)) {
      force = tl_force_law(config, input, at, state, output, &xdd[0]);
    }
#endif
    tl_select_rows(at, point, &xdd[0], &row, xdd_cmd);
  }
  for (int32_t i = 0; i < TL_JOINTS; ++i) {
    const real w = config->posture_frequency[i];
    const real way = tl_way_to(i, at->q[i], state->posture[i]);
    // Twice the speed that the joint gets to.
    const real wanted = tl_within(w * way, config->speed[i]);
    qdd_0[i] = w * (wanted - (TL_REAL(2.0) * at->qd[i]));
  }
  tl_task_torque(input, state, at, qdd_0, xdd_cmd, tau);
#if TL_FORCE
  if (state->pressing != 0) {
    tl_add_push(input, state, at, force, tau);
  }
#endif
}
#endif
