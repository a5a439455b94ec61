#pragma once

// How `DriveController` leads points and lets a hand pull links; included by its header.

namespace treeline::drive {

/// Finds the points, and their errors from their goals: position over rotation vector, world axes.
template <class F>
void DriveController<F>::measure_points(double time, const State& state, double* rotations,
                                        double* errors) noexcept {
  if constexpr (kPoints > 0) {
    double positions[3 * kPoints];
    double turns[9 * kPoints];
    F::forward_kinematics(state.q, positions, turns);
    for (int k = 0; k < kPoints; ++k) {
      const double position[3] = {positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]};
      double R[9];
      for (int i = 0; i < 9; ++i) {
        R[i] = turns[9 * k + i];
        rotations[9 * k + i] = R[i];
      }
      if (free_[at(k)]) {
        points_[at(k)].begin(time, position, R, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
      }
      double wanted[3];
      points_[at(k)].position(wanted);
      double error[6];
      core::pose_error(position, R, wanted, points_[at(k)].rotation(), error);
      for (int i = 0; i < 6; ++i) {
        errors[6 * k + i] = error[i];
      }
    }
  }
}

/// w x v of the points whose axes turn, world axes, by which rates of velocities along them are
/// less than accelerations; 0 of the others.
template <class F>
void DriveController<F>::find_turning(const State& state, double* turning) const noexcept {
  for (int i = 0; i < 3 * kPoints; ++i) {
    turning[i] = 0.0;
  }
  if constexpr (requires { F::point_velocity; }) {
    double twists[6 * kPoints];
    F::point_velocity(state.q, state.qd, twists);
    for (int k = 0; k < kPoints; ++k) {
      if (!F::kLocalAxes[k]) continue;
      const double* const v = twists + 6 * k;
      const double* const w = v + 3;
      for (int i = 0; i < 3; ++i) {
        const int a = (i + 1) % 3;
        const int b = (i + 2) % 3;
        turning[3 * k + i] = w[a] * v[b] - w[b] * v[a];
      }
    }
  }
}

/// The rate that one row of the task is to have, which moves at `velocity`.
template <class F>
double DriveController<F>::command_row(int row, const double* rotations, const double* errors,
                                       const double* turning, double velocity) const noexcept {
  const TaskRow& place = F::kRows[row];
  const double* R = rotations + 9 * place.point;
  // In the point's own axes a row is the component along a column of its rotation.
  const auto component = [&](auto&& of) {
    const int part = place.axis < 3 ? 0 : 3;
    const int i = place.axis % 3;
    return F::kLocalAxes[place.point]
               ? R[i] * of(part) + R[3 + i] * of(part + 1) + R[6 + i] * of(part + 2)
               : of(part + i);
  };
  const double(&push)[3] = avoidance_.point_push(place.point);
  const double* const across = turning + 3 * place.point;
  const double aside = place.axis < 3 ? component([&](int i) { return push[i] - across[i]; }) : 0.0;
  if (free_[at(place.point)]) {
    return aside - task_gains_.kv * velocity;
  }
  const SmoothPose& goal = points_[at(place.point)];
  return aside + component([&](int i) { return goal.acceleration(i); }) +
         task_gains_.kv * (component([&](int i) { return goal.velocity(i); }) - velocity) +
         task_gains_.kp * component([&](int i) { return errors[6 * place.point + i]; });
}

/// Adds M qdd, from inverse dynamics with and without the acceleration.
template <class F>
void DriveController<F>::add_acceleration(const State& state, const double (&qdd)[nv],
                                          double (&tau)[nv]) noexcept {
  const double rest[nv] = {};
  double with[nv];
  double without[nv];
  F::inverse_dynamics(state.q, rest, qdd, with);
  F::inverse_dynamics(state.q, rest, rest, without);
  for (int i = 0; i < nv; ++i) {
    tau[i] += with[i] - without[i];
  }
}

/// The posture in the null space of the task: joints are drawn to their goals. Accelerations alone
/// would let the task move light joints before heavy ones, until they are at their limits, as it
/// withholds least in the metric of kinetic energy. So springs K of one stiffness for all joints,
/// each critically damped by its D, accelerate the robot: what the task leaves then has the least
/// sum of squares of displacements. They are taken at the end of the period, A qdd = f with
/// A = M + h D + h^2 K, for light joints would make them stiff at any period. As M A^-1 D is at
/// most M / h, no projection by the task makes them unstable. On a floating base springs would hold
/// back the base, which has goals of its own. There, in loops, and without `mass_matrix`
/// accelerations have to do.
template <class F>
void DriveController<F>::accelerate_posture(const State& state, double (&qdd)[nv]) const noexcept {
  accelerate_joints(posture_gains_, state, qdd);
  if constexpr (has_springs()) accelerate_by_springs(state, qdd);
  push_from_limits(state, qdd);
}

template <class F>
void DriveController<F>::accelerate_by_springs(const State& state,
                                               double (&qdd)[nv]) const noexcept {
  const double h = settings_.period;
  double A[nv * nv];
  F::mass_matrix(state.q, A);
  double led[nv];
  accelerate_joints({0.0, 0.0}, state, led);
  double f[nv];
  double largest_inertia = 0.0;
  for (int i = 0; i < nv; ++i) {
    f[i] = 0.0;
    for (int j = 0; j < nv; ++j) f[i] += A[i * nv + j] * led[j];
    largest_inertia = std::fmax(largest_inertia, A[i * nv + i]);
  }
  const double K = kPostureRate * kPostureRate * largest_inertia;
  for_each_joint(
      [&](int iq, int iv) {
        const SmoothNumber& goal = joints_[at(iq)];
        double& inertia = A[iv * nv + iv];
        const double D = 2.0 * std::sqrt(K * inertia);
        f[iv] += D * (goal.velocity() - state.qd[iv]) +
                 K * (way(iv, state.q[iq], goal.position()) - h * state.qd[iv]);
        inertia += h * D + h * h * K;
      },
      [](int, int, int) {});
  if (core::ldlt_factor<nv>(A)) {
    core::ldlt_solve<nv>(A, f);
    std::copy_n(f, nv, qdd);
  }
}

template <class F>
void DriveController<F>::command_task(double time, const State& state, double* jacobian,
                                      double (&tau)[nv]) noexcept {
  if constexpr (kPoints > 0) {
    double rotations[9 * kPoints];
    double errors[6 * kPoints];
    measure_points(time, state, rotations, errors);
    double J[F::kTaskRows * nv];
    F::jacobian(state.q, J);
    std::copy_n(J, F::kTaskRows * nv, jacobian);
    double aside[nv] = {};
    avoid_obstacles(state, aside);
    double turning[3 * kPoints];
    find_turning(state, turning);
    double xdd[F::kTaskRows];
    for (int row = 0; row < F::kTaskRows; ++row) {
      double velocity = 0.0;
      for (int i = 0; i < nv; ++i) {
        velocity += J[row * nv + i] * state.qd[i];
      }
      xdd[row] = command_row(row, rotations, errors, turning, velocity);
    }
    double posture[nv];
    accelerate_posture(state, posture);
    F::control_torque(state.q, state.qd, posture, xdd, tau);
    if (avoidance_.pushes()) {
      add_acceleration(state, aside, tau);
    }
  }
}

/// Finds the spring from the link to the hand, J^T f. Returns whether the motors pull by it: on a
/// ground a hand is outside.
template <class F>
bool DriveController<F>::add_pull(const State& state, double (&tau)[nv]) noexcept {
  hand_.place(state.q);
  hand_.place_of(pull_link_, pull_on_link_, pull_at_);
  double squared = 0.0;
  for (int i = 0; i < 3; ++i) {
    pull_force_[i] = settings_.pull_stiffness * (pull_hand_[i] - pull_at_[i]);
    squared += pull_force_[i] * pull_force_[i];
  }
  const double size = std::sqrt(squared);
  const double grip = pull_share_ * pull_share_ * (3.0 - 2.0 * pull_share_);
  for (double& f : pull_force_) {
    f *= grip;
    f *= size > settings_.pull_force ? settings_.pull_force / size : 1.0;
  }
  double added[nv] = {};
  hand_.joint_forces(state.q, pull_link_, pull_at_, pull_force_, added);
  for (int i = 0; i < nv; ++i) {
    (kIsOnGround<F> ? push_ : tau)[i] += added[i];
  }
  return !kIsOnGround<F>;
}

}  // namespace treeline::drive
