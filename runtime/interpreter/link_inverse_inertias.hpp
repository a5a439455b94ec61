#pragma once

#include "interpreter/lambda_inverse.hpp"

namespace treeline::interpreter {

namespace detail {

/// J M^-1 J^T for each body's own frame, in at least O(n^3). Also valid with mimic joints.
template <class Scalar>
PerBody<Matrix6<Scalar>> link_inverse_inertias_by_mass_matrix(const Model<Scalar>& model,
                                                              VectorArg<Scalar> q) {
  PerBody<Matrix6<Scalar>> Omega(model.size(), Matrix6<Scalar>::Zero());
  const auto M = mass_matrix<Scalar>(model, q).ldlt();
  for (int i = 0; i < model.size(); ++i) {
    OperationalPoint<Scalar> origin;
    origin.body = i;
    origin.axes = PointAxes::local;
    const Matrix<Scalar> J = jacobian<Scalar>(model, {origin}, q);
    Omega[i] = J * Matrix<Scalar>(M.solve(Matrix<Scalar>(J.transpose())));
  }
  return Omega;
}

}  // namespace detail

/// Lambda_i^-1 of every body at its frame, in its axes, in O(n): the acceleration of the body per
/// force on it, Omega_i = L^T Omega_h L + S D^-1 S^T outward from zero at the world. No subtraction
/// could cancel, and neither a fixed nor a floating base needs a special rule. With mimic joints by
/// the mass matrix.
template <class Scalar>
PerBody<Matrix6<Scalar>> link_inverse_inertias(const Model<Scalar>& model, VectorArg<Scalar> q) {
  if (model.has_mimics()) {
    return detail::link_inverse_inertias_by_mass_matrix<Scalar>(model, q);
  }
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  return detail::ForcePropagation<Scalar>(model, k).Omega;
}

}  // namespace treeline::interpreter
