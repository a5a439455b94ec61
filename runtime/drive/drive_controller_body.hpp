#pragma once

// The laws of `DriveController`; included by its header.

namespace treeline::drive {

template <class F>
void DriveController<F>::find_led_points() noexcept {
  if constexpr (kPoints > 0) {
    int rows[kPoints] = {};
    for (int row = 0; row < F::kTaskRows; ++row) {
      rows[F::kRows[row].point] += F::kRows[row].axis < 3 ? 1 : 0;
    }
    for (int k = 0; k < kPoints; ++k) {
      led_[at(k)] = rows[k] == 3;
    }
  }
}

/// Adds the accelerations away from obstacles that the joints take. Those of points that the task
/// moves are part of its rows.
template <class F>
void DriveController<F>::avoid_obstacles(const State& state, double (&qdd)[nv]) noexcept {
  if (!avoidance_.exists()) {
    return;
  }
  avoidance_.look(state, control_ == Control::task ? led_ : std::array<bool, room(kPoints)>{});
  for (int i = 0; i < nv; ++i) {
    qdd[i] += avoidance_.joint_push()[i];
  }
}

template <class F>
void DriveController<F>::begin_joints(double time, const State& state) noexcept {
  for_each_joint([&](int iq, int iv) { joints_[at(iq)].begin(time, state.q[iq], state.qd[iv]); },
                 [&](int k, int iq, int iv) {
                   const double* q = state.q + iq;
                   const double* qd = state.qd + iv;
                   const double position[3] = {q[0], q[1], q[2]};
                   const double quaternion[4] = {q[3], q[4], q[5], q[6]};
                   double rotation[9];
                   core::rotation_from_quaternion(quaternion, rotation);
                   double velocity[6];
                   for (int i = 0; i < 3; ++i) {
                     velocity[i] = 0.0;
                     velocity[3 + i] = 0.0;
                     for (int j = 0; j < 3; ++j) {
                       velocity[i] += rotation[3 * i + j] * qd[j];
                       velocity[3 + i] += rotation[3 * i + j] * qd[3 + j];
                     }
                   }
                   floating_[at(k)].begin(time, position, rotation, velocity);
                 });
}

/// Velocities of the points in world axes, of the rows that the task has; the others are 0.
template <class F>
void DriveController<F>::find_velocities(const State& state, const double* rotations,
                                         double* velocities) const noexcept {
  if constexpr (kPoints > 0) {
    for (int i = 0; i < 6 * kPoints; ++i) {
      velocities[i] = 0.0;
    }
    double J[F::kTaskRows * nv];
    F::jacobian(state.q, J);
    for (int row = 0; row < F::kTaskRows; ++row) {
      const TaskRow& place = F::kRows[row];
      double speed = 0.0;
      for (int i = 0; i < nv; ++i) {
        speed += J[row * nv + i] * state.qd[i];
      }
      double* const velocity = velocities + 6 * place.point + (place.axis < 3 ? 0 : 3);
      const double* const R = rotations + 9 * place.point;
      for (int i = 0; i < 3; ++i) {
        const double along = F::kLocalAxes[place.point] ? R[3 * i + place.axis % 3]
                                                        : (place.axis % 3 == i ? 1.0 : 0.0);
        velocity[i] += along * speed;
      }
    }
  }
}

template <class F>
void DriveController<F>::begin_points(double time, const State& state) noexcept {
  if constexpr (kPoints > 0) {
    double positions[3 * kPoints];
    double rotations[9 * kPoints];
    F::forward_kinematics(state.q, positions, rotations);
    double velocities[6 * kPoints];
    find_velocities(state, rotations, velocities);
    for (int k = 0; k < kPoints; ++k) {
      double position[3];
      double rotation[9];
      double velocity[6];
      for (int i = 0; i < 6; ++i) {
        velocity[i] = velocities[6 * k + i];
      }
      for (int i = 0; i < 3; ++i) {
        position[i] = positions[3 * k + i];
      }
      for (int i = 0; i < 9; ++i) {
        rotation[i] = rotations[9 * k + i];
      }
      points_[at(k)].begin(time, position, rotation, velocity);
      free_[at(k)] = false;
    }
  }
}

template <class F>
void DriveController<F>::hold_all(double time) noexcept {
  for_each_joint([&](int iq, int) { joints_[at(iq)].hold(time); },
                 [&](int k, int, int) { floating_[at(k)].hold(time); });
  for (int k = 0; k < kPoints; ++k) {
    points_[at(k)].hold(time);
  }
}

/// Lets points glide to rest that were dragged and are not any more.
template <class F>
void DriveController<F>::end_leases(double time) noexcept {
  for (int i = 0; i < nq; ++i) {
    if (joints_[at(i)].following() && time > joint_leases_[at(i)]) {
      joints_[at(i)].hold(time);
    }
  }
  for (int k = 0; k < kFloating; ++k) {
    if (floating_[at(k)].following() && time > floating_leases_[at(k)]) {
      floating_[at(k)].hold(time);
    }
  }
  for (int k = 0; k < kPoints; ++k) {
    if (points_[at(k)].following() && time > point_leases_[at(k)]) {
      points_[at(k)].hold(time);
    }
  }
}

/// A hand takes hold, follows and lets go smoothly.
template <class F>
void DriveController<F>::advance_pull(double time) noexcept {
  pulled_ = pulled_ && time <= pull_until_;
  const double change = settings_.period / kGrip;
  pull_share_ =
      pulled_ ? std::fmin(1.0, pull_share_ + change) : std::fmax(0.0, pull_share_ - change);
  const double share = std::fmin(1.0, kHandFilter * settings_.period);
  for (int i = 0; i < 3; ++i) {
    pull_hand_[i] += share * (pull_to_[i] - pull_hand_[i]);
  }
}

template <class F>
void DriveController<F>::advance(double time) noexcept {
  end_leases(time);
  advance_pull(time);
  for_each_joint([&](int iq, int) { joints_[at(iq)].advance(time, settings_.period); },
                 [&](int k, int, int) { floating_[at(k)].advance(time, settings_.period); });
  for (int k = 0; k < kPoints; ++k) {
    points_[at(k)].advance(time, settings_.period);
  }
  follow_reference(time);
  let_passive_follow(time);
}

/// Joints without motors go where the loops lead them: their goal is where they are.
template <class F>
void DriveController<F>::let_passive_follow(double time) noexcept {
  for_each_joint(
      [&](int iq, int iv) {
        if (is_passive(iv)) joints_[at(iq)].begin(time, state_.q[iq], 0.0);
      },
      [&](int k, int iq, int iv) {
        if (!is_passive(iv)) return;
        const double* q = state_.q + iq;
        double rotation[9];
        core::rotation_from_quaternion({q[3], q[4], q[5], q[6]}, rotation);
        floating_[at(k)].begin(time, {q[0], q[1], q[2]}, rotation, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
      });
}

template <class F>
bool DriveController<F>::moving(double time, double margin) const noexcept {
  const double then = time - margin;
  bool any = reference_.playing();
  for_each_joint(
      [&](int iq, int iv) { any = any || (!is_passive(iv) && joints_[at(iq)].moving(then)); },
      [&](int k, int, int iv) { any = any || (!is_passive(iv) && floating_[at(k)].moving(then)); });
  for (int k = 0; k < kPoints && control_ == Control::task; ++k) {
    any = any || points_[at(k)].moving(then);
  }
  return any;
}

/// Accelerates a floating joint: the law acts in the world's axes and is turned into the body's,
/// where d(R v)/dt = R (dv/dt + w x v).
template <class F>
void DriveController<F>::accelerate_floating(const core::Gains<double>& gains,
                                             const SmoothPose& goal, const double* q,
                                             const double* qd, double* qdd) const noexcept {
  const double quaternion[4] = {q[3], q[4], q[5], q[6]};
  double R[9];
  core::rotation_from_quaternion(quaternion, R);
  double wanted[3];
  goal.position(wanted);
  double error[6];
  core::pose_error({q[0], q[1], q[2]}, R, wanted, goal.rotation(), error);
  double world[6];
  for (int row = 0; row < 6; ++row) {
    const double* part = qd + (row < 3 ? 0 : 3);
    const double* r = R + 3 * (row % 3);
    const double velocity = r[0] * part[0] + r[1] * part[1] + r[2] * part[2];
    world[row] =
        goal.acceleration(row) + gains.kv * (goal.velocity(row) - velocity) + gains.kp * error[row];
  }
  const double* v = qd;
  const double* w = qd + 3;
  const double transport[3] = {w[1] * v[2] - w[2] * v[1], w[2] * v[0] - w[0] * v[2],
                               w[0] * v[1] - w[1] * v[0]};
  for (int i = 0; i < 3; ++i) {
    qdd[i] = R[i] * world[0] + R[3 + i] * world[1] + R[6 + i] * world[2] - transport[i];
    qdd[3 + i] = R[i] * world[3] + R[3 + i] * world[4] + R[6 + i] * world[5];
  }
}

template <class F>
void DriveController<F>::accelerate_joints(const core::Gains<double>& gains, const State& state,
                                           double (&qdd)[nv]) const noexcept {
  for_each_joint(
      [&](int iq, int iv) {
        const SmoothNumber& goal = joints_[at(iq)];
        qdd[iv] = goal.acceleration() + gains.kv * (goal.velocity() - state.qd[iv]) +
                  gains.kp * way(iv, state.q[iq], goal.position());
      },
      [&](int k, int iq, int iv) {
        accelerate_floating(gains, floating_[at(k)], state.q + iq, state.qd + iv, qdd + iv);
      });
}

template <class F>
void DriveController<F>::find_goal_velocity(double (&qd)[nv]) const noexcept {
  for_each_joint([&](int iq, int iv) { qd[iv] = joints_[at(iq)].velocity(); },
                 [&](int k, int, int iv) {  // in the axes of the body
                   const SmoothPose& goal = floating_[at(k)];
                   const double(&R)[9] = goal.rotation();
                   for (int i = 0; i < 6; ++i) {
                     const int first = i < 3 ? 0 : 3;
                     qd[iv + i] = 0.0;
                     for (int row = 0; row < 3; ++row) {
                       qd[iv + i] += R[3 * row + i - first] * goal.velocity(first + row);
                     }
                   }
                 });
}

/// Gravity compensation: joints are hardly damped, a hand may pull, and limits are kept.
template <class F>
void DriveController<F>::yield_to_hand(const State& state, double (&tau)[nv]) noexcept {
  double qdd[nv];
  accelerate_joints(joint_gains_, state, qdd);
  for_each_joint([&](int, int iv) { qdd[iv] = -kHandDamping * state.qd[iv]; },
                 [](int, int, int) {});
  F::inverse_dynamics(state.q, state.qd, qdd, tau);
  if (pulled() && add_pull(state, tau)) {
    F::forward_dynamics(state.q, state.qd, tau, qdd);
  }
  avoid_obstacles(state, qdd);
  stay_within(kHandBounds, 1.0, state, qdd);
  F::inverse_dynamics(state.q, state.qd, qdd, tau);
}

/// Forces of the motors alone that move the robot as forces of all joints do.
template <class F>
void DriveController<F>::leave_to_motors(const State& state, double (&tau)[nv]) const noexcept {
  bool all_have_motors = true;
  for (int i = 0; i < nv; ++i) all_have_motors = all_have_motors && !is_passive(i);
  if (all_have_motors) return;
  double qdd[nv];
  F::forward_dynamics(state.q, state.qd, tau, qdd);
  F::inverse_dynamics(state.q, state.qd, qdd, tau);
}

template <class F>
void DriveController<F>::blend(double time, double (&tau)[nv]) noexcept {
  if (blend_asked_) {
    blend_asked_ = false;
    blend_start_ = time;
    for (int i = 0; i < nv; ++i) {
      blend_from_[i] = last_torque_[i] - tau[i];
    }
  }
  const double left = 1.0 - (time - blend_start_) / kBlend;
  if (left <= 0.0) {
    return;
  }
  const double share = left * left * left * (10.0 - 15.0 * left + 6.0 * left * left);
  for (int i = 0; i < nv; ++i) {
    tau[i] += share * blend_from_[i];
  }
}

template <class F>
void DriveController<F>::control(double time, const State& state, double (&tau)[nv]) noexcept {
  if (!settings_.only_leads) observe(state);
  state_ = state;
  saturated_ = false;
  std::fill(std::begin(push_), std::end(push_), 0.0);
  advance(time);
  if (settings_.only_leads) {
    std::fill(std::begin(tau), std::end(tau), 0.0);
    return;
  }
  double J[room(task_rows() * nv)];
  if (control_ == Control::gravity) {
    yield_to_hand(state, tau);
  } else if (control_ == Control::task) {
    command_task(time, state, J, tau);
  } else {
    double qdd[nv];
    accelerate_joints(joint_gains_, state, qdd);
    avoid_obstacles(state, qdd);
    F::inverse_dynamics(state.q, state.qd, qdd, tau);
  }
  if (pulled() && control_ != Control::gravity && add_pull(state, tau)) {
    leave_to_motors(state, tau);
  }
  blend(time, tau);
  keep_limits(state, control_ == Control::task ? J : nullptr, tau);
}

}  // namespace treeline::drive
