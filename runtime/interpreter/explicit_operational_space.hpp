#pragma once

#include "interpreter/articulated_inertia.hpp"
#include "interpreter/jacobian.hpp"
#include "interpreter/mass_matrix.hpp"

namespace treeline::interpreter {

/// The operational space by its definitions (Chang chapter 2), in O(n^3): an independent check of
/// tables 5.3 and 6.1, and the method that they replace.
template <class Scalar>
struct ExplicitOperationalSpace {
  Matrix<Scalar> J;  ///< rows x nv
  Matrix<Scalar> M;  ///< nv x nv, A in the thesis
  Matrix<Scalar> M_inverse;
  Matrix<Scalar> Lambda_inverse;  ///< J M^-1 J^T, rows x rows
  Matrix<Scalar> Lambda;
  Matrix<Scalar> Jbar;  ///< M^-1 J^T Lambda, nv x rows: dynamically consistent inverse
  Matrix<Scalar> N;     ///< 1 - Jbar J, nv x nv: null-space projection
};

template <class Scalar>
ExplicitOperationalSpace<Scalar> explicit_operational_space(const Model<Scalar>& model,
                                                            PointsArg<Scalar> points,
                                                            VectorArg<Scalar> q) {
  ExplicitOperationalSpace<Scalar> o;
  o.J = jacobian<Scalar>(model, points, q);
  o.M = mass_matrix<Scalar>(model, q);
  o.M_inverse = inverse_of_positive_definite<Scalar>(o.M);
  o.Lambda_inverse = o.J * o.M_inverse * o.J.transpose();
  o.Lambda = inverse_of_positive_definite<Scalar>(o.Lambda_inverse);
  o.Jbar = o.M_inverse * o.J.transpose() * o.Lambda;
  o.N = Matrix<Scalar>::Identity(model.nv, model.nv) - o.Jbar * o.J;
  return o;
}

/// tau = J^T F + N^T tau_0 + b + g (Chang eq. 2.2, 2.10) with F = Lambda (xdd_cmd - Jd qd) and
/// tau_0 = M qdd_0. Equals `control_torque`, computed in another way. `bias` is Jd qd.
template <class Scalar>
Vector<Scalar> explicit_control_torque(const ExplicitOperationalSpace<Scalar>& o,
                                       VectorArg<Scalar> qdd_0, VectorArg<Scalar> xdd_cmd,
                                       VectorArg<Scalar> bias,
                                       VectorArg<Scalar> nonlinear_effects) {
  return o.J.transpose() * (o.Lambda * (xdd_cmd - bias)) + o.N.transpose() * (o.M * qdd_0) +
         nonlinear_effects;
}

}  // namespace treeline::interpreter
