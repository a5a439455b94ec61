#pragma once

#include <pinocchio/algorithm/rnea.hpp>

#include "bench/peers/pinocchio/cholesky_route.hpp"

namespace treeline::peer::pin {

/// Writes xdd_cmd minus the points' accelerations under qdd_0 to s.xdd, using the velocities and
/// accelerations that recursive Newton-Euler has computed. Its accelerations contain -g.
template <class Scalar>
void subtract_motion_of_posture(Solver<Scalar>& s, const Scalar* xdd_cmd) {
  Eigen::Index row = 0;
  for (const auto point : s.points) {
    const auto& frame = s.model.frames[point];
    const auto v = frame.placement.actInv(s.data.v[frame.parentJoint]);
    const auto a = frame.placement.actInv(s.data.a_gf[frame.parentJoint]);
    const auto& R = s.data.oMf[point].rotation();
    const auto command = Eigen::Map<const Eigen::Matrix<Scalar, 6, 1>>(xdd_cmd + row);
    s.xdd.template segment<3>(row).noalias() = command.template head<3>() -
                                               R * (a.linear() + v.angular().cross(v.linear())) -
                                               s.model.gravity.linear();
    s.xdd.template segment<3>(row + 3).noalias() = command.template tail<3>() - R * a.angular();
    row += 6;
  }
}

/// Control torque of Chang table 6.1: J^T Lambda (xdd_cmd - Jd qd - J qdd_0) + RNEA(q, qd, qdd_0).
template <class Scalar>
void control_torque(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_motion(in);
  find_lambda_inverse_by_cholesky(s);
  pinocchio::rnea(s.model, s.data, s.q, s.qd, s.drive);
  subtract_motion_of_posture(s, in[3]);
  solve_positive(s.lambda_inverse, s.xdd);
  s.torque = s.data.tau;
  s.torque.noalias() += s.J.transpose() * s.xdd;
  s.store(s.torque, out);
}

}  // namespace treeline::peer::pin
