// SPDX-License-Identifier: 0BSD
// The functions of puma560.hpp for C: see puma560.h.
// Generated. Each call is passed on as it is; programs that make none do not link this file.
#include "puma560_calls.hpp"
#include "puma560.h"

extern "C" {

void puma560_forward_kinematics(const double q[TREELINE_PUMA560_ARRAY(6)],
    double position[TREELINE_PUMA560_ARRAY(3)], double rotation[TREELINE_PUMA560_ARRAY(9)]) {
  puma560::forward_kinematics(puma560::calls::array_at<6>(q), puma560::calls::array_at<3>(position),
      puma560::calls::array_at<9>(rotation));
}

void puma560_jacobian(const double q[TREELINE_PUMA560_ARRAY(6)],
    double J[TREELINE_PUMA560_ARRAY(36)]) {
  puma560::jacobian(puma560::calls::array_at<6>(q), puma560::calls::array_at<36>(J));
}

void puma560_bias_acceleration(const double q[TREELINE_PUMA560_ARRAY(6)],
    const double qd[TREELINE_PUMA560_ARRAY(6)], double bias[TREELINE_PUMA560_ARRAY(6)]) {
  puma560::bias_acceleration(puma560::calls::array_at<6>(q), puma560::calls::array_at<6>(qd),
      puma560::calls::array_at<6>(bias));
}

void puma560_inverse_dynamics(const double q[TREELINE_PUMA560_ARRAY(6)],
    const double qd[TREELINE_PUMA560_ARRAY(6)], const double qdd[TREELINE_PUMA560_ARRAY(6)],
    double tau[TREELINE_PUMA560_ARRAY(6)]) {
  puma560::inverse_dynamics(puma560::calls::array_at<6>(q), puma560::calls::array_at<6>(qd),
      puma560::calls::array_at<6>(qdd), puma560::calls::array_at<6>(tau));
}

void puma560_gravity(const double q[TREELINE_PUMA560_ARRAY(6)],
    double g[TREELINE_PUMA560_ARRAY(6)]) {
  puma560::gravity(puma560::calls::array_at<6>(q), puma560::calls::array_at<6>(g));
}

void puma560_nonlinear_effects(const double q[TREELINE_PUMA560_ARRAY(6)],
    const double qd[TREELINE_PUMA560_ARRAY(6)], double h[TREELINE_PUMA560_ARRAY(6)]) {
  puma560::nonlinear_effects(puma560::calls::array_at<6>(q), puma560::calls::array_at<6>(qd),
      puma560::calls::array_at<6>(h));
}

void puma560_mass_matrix(const double q[TREELINE_PUMA560_ARRAY(6)],
    double M[TREELINE_PUMA560_ARRAY(36)]) {
  puma560::mass_matrix(puma560::calls::array_at<6>(q), puma560::calls::array_at<36>(M));
}

void puma560_forward_dynamics(const double q[TREELINE_PUMA560_ARRAY(6)],
    const double qd[TREELINE_PUMA560_ARRAY(6)], const double tau[TREELINE_PUMA560_ARRAY(6)],
    double qdd[TREELINE_PUMA560_ARRAY(6)]) {
  puma560::forward_dynamics(puma560::calls::array_at<6>(q), puma560::calls::array_at<6>(qd),
      puma560::calls::array_at<6>(tau), puma560::calls::array_at<6>(qdd));
}

void puma560_lambda_inverse(const double q[TREELINE_PUMA560_ARRAY(6)],
    double Lambda_inv[TREELINE_PUMA560_ARRAY(36)]) {
  puma560::lambda_inverse(puma560::calls::array_at<6>(q), puma560::calls::array_at<36>(Lambda_inv));
}

void puma560_lambda(const double q[TREELINE_PUMA560_ARRAY(6)],
    double Lambda[TREELINE_PUMA560_ARRAY(36)]) {
  puma560::lambda(puma560::calls::array_at<6>(q), puma560::calls::array_at<36>(Lambda));
}

void puma560_control_torque(const double q[TREELINE_PUMA560_ARRAY(6)],
    const double qd[TREELINE_PUMA560_ARRAY(6)], const double qdd_0[TREELINE_PUMA560_ARRAY(6)],
    const double xdd_cmd[TREELINE_PUMA560_ARRAY(6)], double tau[TREELINE_PUMA560_ARRAY(6)]) {
  puma560::control_torque(puma560::calls::array_at<6>(q), puma560::calls::array_at<6>(qd),
      puma560::calls::array_at<6>(qdd_0), puma560::calls::array_at<6>(xdd_cmd),
      puma560::calls::array_at<6>(tau));
}

}  // extern "C"
