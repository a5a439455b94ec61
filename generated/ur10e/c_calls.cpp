// SPDX-License-Identifier: 0BSD
// The functions of ur10e.hpp for C: see ur10e.h.
// Generated. Each call is passed on as it is; programs that make none do not link this file.
#include "ur10e_calls.hpp"
#include "ur10e_damped.h"
#include "ur10e_damped.hpp"

extern "C" {

void ur10e_forward_kinematics(const double q[TREELINE_UR10E_ARRAY(6)],
    double position[TREELINE_UR10E_ARRAY(3)], double rotation[TREELINE_UR10E_ARRAY(9)]) {
  ur10e::forward_kinematics(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<3>(position),
      ur10e::calls::array_at<9>(rotation));
}

void ur10e_jacobian(const double q[TREELINE_UR10E_ARRAY(6)], double J[TREELINE_UR10E_ARRAY(36)]) {
  ur10e::jacobian(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<36>(J));
}

void ur10e_bias_acceleration(const double q[TREELINE_UR10E_ARRAY(6)],
    const double qd[TREELINE_UR10E_ARRAY(6)], double bias[TREELINE_UR10E_ARRAY(6)]) {
  ur10e::bias_acceleration(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<6>(qd),
      ur10e::calls::array_at<6>(bias));
}

void ur10e_inverse_dynamics(const double q[TREELINE_UR10E_ARRAY(6)],
    const double qd[TREELINE_UR10E_ARRAY(6)], const double qdd[TREELINE_UR10E_ARRAY(6)],
    double tau[TREELINE_UR10E_ARRAY(6)]) {
  ur10e::inverse_dynamics(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<6>(qd),
      ur10e::calls::array_at<6>(qdd), ur10e::calls::array_at<6>(tau));
}

void ur10e_gravity(const double q[TREELINE_UR10E_ARRAY(6)], double g[TREELINE_UR10E_ARRAY(6)]) {
  ur10e::gravity(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<6>(g));
}

void ur10e_nonlinear_effects(const double q[TREELINE_UR10E_ARRAY(6)],
    const double qd[TREELINE_UR10E_ARRAY(6)], double h[TREELINE_UR10E_ARRAY(6)]) {
  ur10e::nonlinear_effects(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<6>(qd),
      ur10e::calls::array_at<6>(h));
}

void ur10e_mass_matrix(const double q[TREELINE_UR10E_ARRAY(6)],
    double M[TREELINE_UR10E_ARRAY(36)]) {
  ur10e::mass_matrix(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<36>(M));
}

void ur10e_forward_dynamics(const double q[TREELINE_UR10E_ARRAY(6)],
    const double qd[TREELINE_UR10E_ARRAY(6)], const double tau[TREELINE_UR10E_ARRAY(6)],
    double qdd[TREELINE_UR10E_ARRAY(6)]) {
  ur10e::forward_dynamics(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<6>(qd),
      ur10e::calls::array_at<6>(tau), ur10e::calls::array_at<6>(qdd));
}

void ur10e_lambda_inverse(const double q[TREELINE_UR10E_ARRAY(6)],
    double Lambda_inv[TREELINE_UR10E_ARRAY(36)]) {
  ur10e::lambda_inverse(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<36>(Lambda_inv));
}

void ur10e_lambda(const double q[TREELINE_UR10E_ARRAY(6)],
    double Lambda[TREELINE_UR10E_ARRAY(36)]) {
  ur10e::lambda(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<36>(Lambda));
}

void ur10e_control_torque(const double q[TREELINE_UR10E_ARRAY(6)],
    const double qd[TREELINE_UR10E_ARRAY(6)], const double qdd_0[TREELINE_UR10E_ARRAY(6)],
    const double xdd_cmd[TREELINE_UR10E_ARRAY(6)], double tau[TREELINE_UR10E_ARRAY(6)]) {
  ur10e::control_torque(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<6>(qd),
      ur10e::calls::array_at<6>(qdd_0), ur10e::calls::array_at<6>(xdd_cmd),
      ur10e::calls::array_at<6>(tau));
}

double ur10e_damped_control_torque(const double q[TREELINE_UR10E_ARRAY(6)],
    const double qd[TREELINE_UR10E_ARRAY(6)], const double qdd_0[TREELINE_UR10E_ARRAY(6)],
    const double xdd_cmd[TREELINE_UR10E_ARRAY(6)], double tau[TREELINE_UR10E_ARRAY(6)],
    const double heaviest[TREELINE_UR10E_ARRAY(6)]) {
  return ur10e::damped_control_torque(ur10e::calls::array_at<6>(q), ur10e::calls::array_at<6>(qd),
      ur10e::calls::array_at<6>(qdd_0), ur10e::calls::array_at<6>(xdd_cmd),
      ur10e::calls::array_at<6>(tau), ur10e::calls::array_at<6>(heaviest));
}

}  // extern "C"
