#pragma once

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/jacobian.hpp>

#include "bench/peers/pinocchio/cholesky_route.hpp"

namespace treeline::peer::pin {

/// J M^-1 J^T with M^-1 from the articulated-body algorithm.
template <class Scalar>
void lambda_inverse_by_minverse(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_position(in[0]);
  pinocchio::computeJointJacobians(s.model, s.data, s.q);
  find_point_jacobians(s);
  pinocchio::computeMinverse(s.model, s.data, s.q);
  s.scaled.noalias() = s.data.Minv.template selfadjointView<Eigen::Upper>() * s.J.transpose();
  Eigen::Map<Matrix<Scalar>>(out, s.rows(), s.rows()).noalias() = s.J * s.scaled;
}

}  // namespace treeline::peer::pin
