#include "circle_controller.hpp"

#include <algorithm>
#include <iterator>

#include "core/ldlt.hpp"

namespace treeline::experiments {
namespace {

constexpr int kBase = 3;  // number of joints of the base, the first ones

/// Row k is column k of M^-1: the acceleration due to a unit force on joint k of the base.
void answers_to_base_forces(const double (&q)[9], double (&answers)[kBase][9]) {
  double M[81];
  samm::mass_matrix(q, M);
  core::ldlt_factor<9>(M);
  for (int k = 0; k < kBase; ++k) {
    std::fill(std::begin(answers[k]), std::end(answers[k]), 0.0);
    answers[k][k] = 1.0;
    core::ldlt_solve(M, answers[k]);
  }
}

}  // namespace

void base_posture(const double (&q)[9], const double (&qd)[9], const double (&xdd_cmd)[6],
                  const double (&b)[3], double (&qdd_0)[9]) noexcept {
  double answers[kBase][9];
  double J[54];
  double Lambda[36];
  double bias[6];
  answers_to_base_forces(q, answers);
  samm::jacobian(q, J);
  samm::lambda(q, Lambda);
  samm::bias_acceleration(q, qd, bias);
  double tip[kBase][6] = {};   // transpose of J M^-1 S^T
  double jbar[kBase][6] = {};  // S Jbar
  for (int k = 0; k < kBase; ++k) {
    for (int i = 0; i < 54; ++i) {
      tip[k][i / 9] += J[i] * answers[k][i % 9];
    }
    for (int i = 0; i < 36; ++i) {
      jbar[k][i % 6] += tip[k][i / 6] * Lambda[i];
    }
  }
  double W[kBase * kBase];
  double f[kBase];
  for (int k = 0; k < kBase; ++k) {
    f[k] = b[k];
    for (int i = 0; i < 6; ++i) {
      f[k] -= jbar[k][i] * (xdd_cmd[i] - bias[i]);
    }
    for (int l = 0; l < kBase; ++l) {
      W[kBase * k + l] = answers[k][l];
      for (int i = 0; i < 6; ++i) {
        W[kBase * k + l] -= jbar[k][i] * tip[l][i];
      }
    }
  }
  core::ldlt_factor<kBase>(W);
  core::ldlt_solve(W, f);
  for (int i = 0; i < 9; ++i) {
    qdd_0[i] = f[0] * answers[0][i] + f[1] * answers[1][i] + f[2] * answers[2][i];
  }
}

void CircleController::start(double time, const State& state) noexcept {
  start_time_ = time;
  samm::forward_kinematics(state.q, position_, rotation_);
  std::copy_n(state.q, kBase, base_);
}

void CircleController::control(double time, const State& state, double (&tau)[9]) noexcept {
  Tracking& t = tracking_;
  t.wanted = circles_at(plan_, time - start_time_);
  double position[3];
  double rotation[9];
  double J[54];
  samm::forward_kinematics(state.q, position, rotation);
  samm::jacobian(state.q, J);
  double velocity[6] = {};
  double velocity_wanted[6] = {};
  double acceleration_wanted[6] = {};
  double speed[kBase];
  for (int i = 0; i < 3; ++i) {
    t.tool[i] = position[i];
    t.tool_wanted[i] = position_[i] + t.wanted.tool[i];
    velocity_wanted[i] = t.wanted.tool_velocity[i];
    acceleration_wanted[i] = t.wanted.tool_acceleration[i];
    t.base_error[i] = base_[i] + t.wanted.base[i] - state.q[i];
    speed[i] = state.qd[i];
  }
  core::pose_error(position, rotation, t.tool_wanted, rotation_, t.error);
  for (int i = 0; i < 54; ++i) {
    velocity[i / 9] += J[i] * state.qd[i % 9];
  }
  double xdd_cmd[6];
  double b[kBase];
  double qdd_0[9];
  core::tracking_law(gains_.tool, t.error, velocity, velocity_wanted, acceleration_wanted, xdd_cmd);
  core::tracking_law(gains_.base, t.base_error, speed, t.wanted.base_velocity,
                     t.wanted.base_acceleration, b);
  base_posture(state.q, state.qd, xdd_cmd, b, qdd_0);
  samm::control_torque(state.q, state.qd, qdd_0, xdd_cmd, tau);
  double qdd[9];
  samm::forward_dynamics(state.q, state.qd, tau, qdd);
  for (int i = 0; i < 9; ++i) {
    tau[i] += gains_.rotors[i] * qdd[i];
  }
}

}  // namespace treeline::experiments
