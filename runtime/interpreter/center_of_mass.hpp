#pragma once

#include "interpreter/jacobian.hpp"

namespace treeline::interpreter {

/// Centre of mass of all bodies, m, world axes. The model's mass must be positive.
template <class Scalar>
Vector3<Scalar> center_of_mass(const Model<Scalar>& model, VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  Vector3<Scalar> moment = Vector3<Scalar>::Zero();
  for (int i = 0; i < model.size(); ++i) {
    moment += model.body(i).mass * (k.p_world[i] + k.R_world[i] * model.body(i).com);
  }
  return moment / total_mass(model);
}

/// Jacobian of the centre of mass, 3 x nv: its velocity in world axes is J qd. It is the mean of
/// the Jacobians of the bodies' centres of mass, weighted with their masses.
template <class Scalar>
Matrix<Scalar> center_of_mass_jacobian(const Model<Scalar>& model, VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  Matrix<Scalar> J = Matrix<Scalar>::Zero(3, model.nv);
  for (int i = 0; i < model.size(); ++i) {
    const Points<Scalar> center{{"", i, Matrix3<Scalar>::Identity(), model.body(i).com}};
    J += model.body(i).mass * detail::all_rows_jacobian<Scalar>(model, center, k).topRows(3);
  }
  return J / total_mass(model);
}

}  // namespace treeline::interpreter
