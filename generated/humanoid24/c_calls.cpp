// SPDX-License-Identifier: 0BSD
// The functions of humanoid24.hpp for C: see humanoid24.h.
// Generated. Each call is passed on as it is; programs that make none do not link this file.
#include "humanoid24_calls.hpp"
#include "humanoid24.h"

extern "C" {

void humanoid24_forward_kinematics(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    double position[TREELINE_HUMANOID24_ARRAY(6)], double rotation[TREELINE_HUMANOID24_ARRAY(18)]) {
  humanoid24::forward_kinematics(humanoid24::calls::array_at<24>(q),
      humanoid24::calls::array_at<6>(position), humanoid24::calls::array_at<18>(rotation));
}

void humanoid24_jacobian(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    double J[TREELINE_HUMANOID24_ARRAY(288)]) {
  humanoid24::jacobian(humanoid24::calls::array_at<24>(q), humanoid24::calls::array_at<288>(J));
}

void humanoid24_bias_acceleration(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    const double qd[TREELINE_HUMANOID24_ARRAY(24)], double bias[TREELINE_HUMANOID24_ARRAY(12)]) {
  humanoid24::bias_acceleration(humanoid24::calls::array_at<24>(q),
      humanoid24::calls::array_at<24>(qd), humanoid24::calls::array_at<12>(bias));
}

void humanoid24_inverse_dynamics(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    const double qd[TREELINE_HUMANOID24_ARRAY(24)], const double qdd[TREELINE_HUMANOID24_ARRAY(24)],
    double tau[TREELINE_HUMANOID24_ARRAY(24)]) {
  humanoid24::inverse_dynamics(humanoid24::calls::array_at<24>(q),
      humanoid24::calls::array_at<24>(qd), humanoid24::calls::array_at<24>(qdd),
      humanoid24::calls::array_at<24>(tau));
}

void humanoid24_gravity(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    double g[TREELINE_HUMANOID24_ARRAY(24)]) {
  humanoid24::gravity(humanoid24::calls::array_at<24>(q), humanoid24::calls::array_at<24>(g));
}

void humanoid24_nonlinear_effects(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    const double qd[TREELINE_HUMANOID24_ARRAY(24)], double h[TREELINE_HUMANOID24_ARRAY(24)]) {
  humanoid24::nonlinear_effects(humanoid24::calls::array_at<24>(q),
      humanoid24::calls::array_at<24>(qd), humanoid24::calls::array_at<24>(h));
}

void humanoid24_mass_matrix(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    double M[TREELINE_HUMANOID24_ARRAY(576)]) {
  humanoid24::mass_matrix(humanoid24::calls::array_at<24>(q), humanoid24::calls::array_at<576>(M));
}

void humanoid24_forward_dynamics(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    const double qd[TREELINE_HUMANOID24_ARRAY(24)], const double tau[TREELINE_HUMANOID24_ARRAY(24)],
    double qdd[TREELINE_HUMANOID24_ARRAY(24)]) {
  humanoid24::forward_dynamics(humanoid24::calls::array_at<24>(q),
      humanoid24::calls::array_at<24>(qd), humanoid24::calls::array_at<24>(tau),
      humanoid24::calls::array_at<24>(qdd));
}

void humanoid24_lambda_inverse(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    double Lambda_inv[TREELINE_HUMANOID24_ARRAY(144)]) {
  humanoid24::lambda_inverse(humanoid24::calls::array_at<24>(q),
      humanoid24::calls::array_at<144>(Lambda_inv));
}

void humanoid24_lambda(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    double Lambda[TREELINE_HUMANOID24_ARRAY(144)]) {
  humanoid24::lambda(humanoid24::calls::array_at<24>(q), humanoid24::calls::array_at<144>(Lambda));
}

void humanoid24_control_torque(const double q[TREELINE_HUMANOID24_ARRAY(24)],
    const double qd[TREELINE_HUMANOID24_ARRAY(24)],
    const double qdd_0[TREELINE_HUMANOID24_ARRAY(24)],
    const double xdd_cmd[TREELINE_HUMANOID24_ARRAY(12)],
    double tau[TREELINE_HUMANOID24_ARRAY(24)]) {
  humanoid24::control_torque(humanoid24::calls::array_at<24>(q),
      humanoid24::calls::array_at<24>(qd), humanoid24::calls::array_at<24>(qdd_0),
      humanoid24::calls::array_at<12>(xdd_cmd), humanoid24::calls::array_at<24>(tau));
}

}  // extern "C"
