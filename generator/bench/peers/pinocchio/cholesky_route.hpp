#pragma once

#include <pinocchio/algorithm/cholesky.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>

#include "bench/peers/pinocchio/solve_positive.hpp"
#include "bench/peers/pinocchio/solver.hpp"

namespace treeline::peer::pin {

/// M. `out` receives its upper triangle.
template <class Scalar>
void crba(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_position(in[0]);
  Eigen::Map<Matrix<Scalar>>(out, s.model.nv, s.model.nv) =
      pinocchio::crba(s.model, s.data, s.q, pinocchio::Convention::LOCAL);
}

template <class Scalar>
void crba_in_world_axes(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_position(in[0]);
  Eigen::Map<Matrix<Scalar>>(out, s.model.nv, s.model.nv) =
      pinocchio::crba(s.model, s.data, s.q, pinocchio::Convention::WORLD);
}

/// Computes s.J from joint Jacobians and poses that are up to date.
template <class Scalar>
void find_point_jacobians(Solver<Scalar>& s) {
  Eigen::Index row = 0;
  for (const auto point : s.points) {
    pinocchio::updateFramePlacement(s.model, s.data, point);
    pinocchio::getFrameJacobian(s.model, s.data, point, pinocchio::LOCAL_WORLD_ALIGNED,
                                s.J.template middleRows<6>(row));
    row += 6;
  }
}

/// Computes s.lambda_inverse: M = U D U^T, W = U^-1 J^T, then W^T D^-1 W. U^-1 uses the zeros due
/// to the tree.
template <class Scalar>
void find_lambda_inverse_by_cholesky(Solver<Scalar>& s) {
  pinocchio::crba(s.model, s.data, s.q, pinocchio::Convention::WORLD);
  pinocchio::cholesky::decompose(s.model, s.data);
  find_point_jacobians(s);
  s.JT = s.J.transpose();
  pinocchio::cholesky::Uiv(s.model, s.data, s.JT);
  s.scaled.noalias() = s.data.Dinv.asDiagonal() * s.JT;
  s.lambda_inverse.noalias() = s.JT.transpose() * s.scaled;
}

template <class Scalar>
void lambda_inverse_by_cholesky(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_position(in[0]);
  find_lambda_inverse_by_cholesky(s);
  Eigen::Map<Matrix<Scalar>>(out, s.rows(), s.rows()) = s.lambda_inverse;
}

template <class Scalar>
void lambda_by_cholesky(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_position(in[0]);
  find_lambda_inverse_by_cholesky(s);
  Eigen::Map<Matrix<Scalar>> lambda(out, s.rows(), s.rows());
  lambda.setIdentity();
  solve_positive(s.lambda_inverse, lambda);
}

}  // namespace treeline::peer::pin
