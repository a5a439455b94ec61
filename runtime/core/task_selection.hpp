#pragma once
// Motion control in some directions, force control in the others (Khatib 1987, "A unified approach
// for motion and force control"): the generalised task specification matrices
//
//     Omega = [S_F^T Sigma_F S_F, 0; 0, S_M^T Sigma_M S_M],  Omega-bar its complement,
//
// in frames that move with the contact. C++17, freestanding, fixed size.

#include "core/prioritized_solve.hpp"

namespace treeline::core {

/// Selects the directions that move and those that press. Frames are rotations from the selection
/// frame to the axes of the operational point's rows, row-major, given anew in every cycle.
template <class Real>
struct TaskSelection {
  Real R_force[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};          ///< S_F^T
  Real R_moment[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};         ///< S_M^T
  bool motion[6] = {true, true, true, true, true, true};  ///< Sigma: x y z rx ry rz of the frames
};

namespace steps {

/// out = R diag(chosen == motion) R^T in.
template <class Real>
inline void keep_directions(const Real (&R)[9], const bool* motion, bool chosen, const Real* in,
                            Real* out) noexcept {
  Real kept[3];
  for (int axis = 0; axis < 3; ++axis) {
    const Real along = R[axis] * in[0] + R[3 + axis] * in[1] + R[6 + axis] * in[2];
    kept[axis] = motion[axis] == chosen ? along : Real(0);
  }
  for (int i = 0; i < 3; ++i) {
    out[i] = R[3 * i] * kept[0] + R[3 * i + 1] * kept[1] + R[3 * i + 2] * kept[2];
  }
}

}  // namespace steps

/// Omega x: what of a motion is to be controlled as motion.
template <class Real>
inline void select_motion(const TaskSelection<Real>& selection, const Real (&x)[6],
                          Real (&selected)[6]) noexcept {
  steps::keep_directions(selection.R_force, selection.motion, true, x, selected);
  steps::keep_directions(selection.R_moment, selection.motion + 3, true, x + 3, selected + 3);
}

/// Omega-bar x: the other part, of forces and moments.
template <class Real>
inline void select_force(const TaskSelection<Real>& selection, const Real (&x)[6],
                         Real (&selected)[6]) noexcept {
  steps::keep_directions(selection.R_force, selection.motion, false, x, selected);
  steps::keep_directions(selection.R_moment, selection.motion + 3, false, x + 3, selected + 3);
}

/// Gains of `force_law`.
template <class Real>
struct ForceGains {
  Real kp = Real(0);  ///< of the force error, 1
  Real ki = Real(0);  ///< of its integral, 1/s
  Real kv = Real(0);  ///< 1/s, damps what motion remains along the directions of force
};

/// F = wanted + kp (wanted - sensed) + ki integral: forces the robot exerts on its surroundings, N
/// and N m. `integral` (N s) grows by (wanted - sensed) dt within +-`largest`.
template <class Real>
constexpr void force_law(const ForceGains<Real>& gains, const Real (&wanted)[6],
                         const Real (&sensed)[6], Real dt, Real largest, Real (&integral)[6],
                         Real (&force)[6]) noexcept {
  for (int i = 0; i < 6; ++i) {
    const Real error = wanted[i] - sensed[i];
    const Real sum = integral[i] + error * dt;
    integral[i] = sum > largest ? largest : (sum < -largest ? -largest : sum);
    force[i] = wanted[i] + gains.kp * error + gains.ki * integral[i];
  }
}

/// xdd_cmd of one operational point of six rows, for control_torque:
///     Omega motion - Omega-bar kv xd + Lambda^-1 Omega-bar force,
/// so that F = Lambda xdd_cmd + ... exerts `force` along the directions of force (Khatib 1987, eq.
/// 61-63). `Lambda_inv` is the point's 6 x 6 block; `motion` the commanded acceleration, `velocity`
/// the point's.
template <class Real>
inline void motion_force_command(const TaskSelection<Real>& selection, const Real (&Lambda_inv)[36],
                                 const Real (&motion)[6], const Real (&velocity)[6],
                                 const Real (&force)[6], Real kv, Real (&xdd_cmd)[6]) noexcept {
  Real moving[6];
  Real pressing[6];
  Real residual[6];
  select_motion(selection, motion, moving);
  select_force(selection, force, pressing);
  select_force(selection, velocity, residual);
  for (int i = 0; i < 6; ++i) {
    xdd_cmd[i] = moving[i] - kv * residual[i];
    for (int j = 0; j < 6; ++j) {
      xdd_cmd[i] += Lambda_inv[6 * i + j] * pressing[j];
    }
  }
}

}  // namespace treeline::core
