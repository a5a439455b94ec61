#pragma once

#include "interpreter/lambda_inverse.hpp"
#include "interpreter/propagate_inertia.hpp"

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

/// Lambda_i of every body at its frame, in its axes, in O(n) by Chang table 8.1: articulated
/// inertias inward, then outward the inertia of everything except the body's subtree, N = Lambda_h
/// - X (IA - U D^-1 U^T) X^T moved to the body's frame, and Lambda_i = IA_i + N - N S (S^T N S)^-1
/// S^T N. The loss in the subtraction grows with the square of the distance between bodies relative
/// to their size. Through a floating joint nothing of the rest is felt, so Lambda = IA there, where
/// the table begins. A fixed base is a "big base" whose inertia is `base_size` (kg, kg m^2) times
/// the unit matrix, which causes an error of about 1 / base_size and a loss of digits due to its
/// size. Precondition: no mimic joints.
template <class Scalar>
PerBody<Matrix6<Scalar>> link_inertias(const Model<Scalar>& model, VectorArg<Scalar> q,
                                       const std::type_identity_t<Scalar>& base_size) {
  assert(!model.has_mimics());
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const auto inertia = articulated_inertia(model, k);
  const auto& [IA, U, D_inverse] = inertia;
  PerBody<Matrix6<Scalar>> Lambda = IA;
  Lambda[kWorld] += base_size * Matrix6<Scalar>::Identity();
  for (int i = 0; i < model.size(); ++i) {
    Matrix6<Scalar> subtree = IA[i];
    if (k.S[i].cols() > 0) subtree -= U[i] * D_inverse[i] * U[i].transpose();
    const Matrix6<Scalar> rest =
        Lambda[model.body(i).parent] - k.X[i] * subtree * k.X[i].transpose();
    const Matrix6<Scalar> X_inverse = detail::inverse_force_transform(k.X[i]);
    const Matrix6<Scalar> N = X_inverse * rest * X_inverse.transpose();
    Lambda[i] += detail::felt_through_joint(N, k.S[i], model.body(i).armature);
  }
  return Lambda;
}

}  // namespace treeline::interpreter
