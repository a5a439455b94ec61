// SPDX-License-Identifier: 0BSD
// The functions of samm.hpp for C: see samm.h.
// Generated. Each call is passed on as it is; programs that make none do not link this file.
#include "samm_calls.hpp"
#include "samm.h"

extern "C" {

void samm_forward_kinematics(const double q[TREELINE_SAMM_ARRAY(9)],
    double position[TREELINE_SAMM_ARRAY(3)], double rotation[TREELINE_SAMM_ARRAY(9)]) {
  samm::forward_kinematics(samm::calls::array_at<9>(q), samm::calls::array_at<3>(position),
      samm::calls::array_at<9>(rotation));
}

void samm_jacobian(const double q[TREELINE_SAMM_ARRAY(9)], double J[TREELINE_SAMM_ARRAY(54)]) {
  samm::jacobian(samm::calls::array_at<9>(q), samm::calls::array_at<54>(J));
}

void samm_bias_acceleration(const double q[TREELINE_SAMM_ARRAY(9)],
    const double qd[TREELINE_SAMM_ARRAY(9)], double bias[TREELINE_SAMM_ARRAY(6)]) {
  samm::bias_acceleration(samm::calls::array_at<9>(q), samm::calls::array_at<9>(qd),
      samm::calls::array_at<6>(bias));
}

void samm_inverse_dynamics(const double q[TREELINE_SAMM_ARRAY(9)],
    const double qd[TREELINE_SAMM_ARRAY(9)], const double qdd[TREELINE_SAMM_ARRAY(9)],
    double tau[TREELINE_SAMM_ARRAY(9)]) {
  samm::inverse_dynamics(samm::calls::array_at<9>(q), samm::calls::array_at<9>(qd),
      samm::calls::array_at<9>(qdd), samm::calls::array_at<9>(tau));
}

void samm_gravity(const double q[TREELINE_SAMM_ARRAY(9)], double g[TREELINE_SAMM_ARRAY(9)]) {
  samm::gravity(samm::calls::array_at<9>(q), samm::calls::array_at<9>(g));
}

void samm_nonlinear_effects(const double q[TREELINE_SAMM_ARRAY(9)],
    const double qd[TREELINE_SAMM_ARRAY(9)], double h[TREELINE_SAMM_ARRAY(9)]) {
  samm::nonlinear_effects(samm::calls::array_at<9>(q), samm::calls::array_at<9>(qd),
      samm::calls::array_at<9>(h));
}

void samm_mass_matrix(const double q[TREELINE_SAMM_ARRAY(9)], double M[TREELINE_SAMM_ARRAY(81)]) {
  samm::mass_matrix(samm::calls::array_at<9>(q), samm::calls::array_at<81>(M));
}

void samm_forward_dynamics(const double q[TREELINE_SAMM_ARRAY(9)],
    const double qd[TREELINE_SAMM_ARRAY(9)], const double tau[TREELINE_SAMM_ARRAY(9)],
    double qdd[TREELINE_SAMM_ARRAY(9)]) {
  samm::forward_dynamics(samm::calls::array_at<9>(q), samm::calls::array_at<9>(qd),
      samm::calls::array_at<9>(tau), samm::calls::array_at<9>(qdd));
}

void samm_lambda_inverse(const double q[TREELINE_SAMM_ARRAY(9)],
    double Lambda_inv[TREELINE_SAMM_ARRAY(36)]) {
  samm::lambda_inverse(samm::calls::array_at<9>(q), samm::calls::array_at<36>(Lambda_inv));
}

void samm_lambda(const double q[TREELINE_SAMM_ARRAY(9)], double Lambda[TREELINE_SAMM_ARRAY(36)]) {
  samm::lambda(samm::calls::array_at<9>(q), samm::calls::array_at<36>(Lambda));
}

void samm_control_torque(const double q[TREELINE_SAMM_ARRAY(9)],
    const double qd[TREELINE_SAMM_ARRAY(9)], const double qdd_0[TREELINE_SAMM_ARRAY(9)],
    const double xdd_cmd[TREELINE_SAMM_ARRAY(6)], double tau[TREELINE_SAMM_ARRAY(9)]) {
  samm::control_torque(samm::calls::array_at<9>(q), samm::calls::array_at<9>(qd),
      samm::calls::array_at<9>(qdd_0), samm::calls::array_at<6>(xdd_cmd),
      samm::calls::array_at<9>(tau));
}

}  // extern "C"
