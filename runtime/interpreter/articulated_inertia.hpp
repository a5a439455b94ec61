#pragma once

#include <Eigen/Cholesky>

#include "interpreter/inverse_dynamics.hpp"

namespace treeline::interpreter {

/// Inverse of a symmetric positive definite matrix by LDL^T.
template <class Scalar, class Derived>
Matrix<Scalar> inverse_of_positive_definite(const Eigen::MatrixBase<Derived>& A) {
  if (A.rows() == 1) return Matrix<Scalar>::Constant(1, 1, Scalar(1) / A(0, 0));
  return Matrix<Scalar>(A).ldlt().solve(Matrix<Scalar>::Identity(A.rows(), A.rows()));
}

/// Result of the part of the inward recursion of Chang table 4.2 that depends only on q.
template <class Scalar>
struct ArticulatedInertia {
  explicit ArticulatedInertia(int bodies)
      : IA(bodies, Matrix6<Scalar>::Zero()),
        U(bodies, JointMatrix<Scalar>(6, 0)),
        D_inverse(bodies, Matrix<Scalar>(0, 0)) {}

  PerBody<Matrix6<Scalar>> IA;        ///< inertia of a body with everything beyond it, joints free
  PerBody<JointMatrix<Scalar>> U;     ///< IA S
  PerBody<Matrix<Scalar>> D_inverse;  ///< (S^T IA S)^-1
};

/// Articulated-body inertias: D = S^T IA S + armature, U = IA S, IA_h = I_h + sum X (IA - U D^-1
/// U^T) X^T. Not valid with mimic joints, whose forces depend on other bodies.
template <class Scalar>
ArticulatedInertia<Scalar> articulated_inertia(const Model<Scalar>& model,
                                               const Kinematics<Scalar>& k) {
  ArticulatedInertia<Scalar> result(model.size());
  auto& [IA, U, D_inverse] = result;
  for (int i = 0; i < model.size(); ++i) IA[i] = detail::body_inertia(model.body(i));
  for (int i = model.size() - 1; i >= 0; --i) {
    Matrix6<Scalar> felt_by_parent = IA[i];
    if (k.S[i].cols() > 0) {
      U[i] = IA[i] * k.S[i];
      Matrix<Scalar> D = k.S[i].transpose() * U[i];
      D.diagonal().array() += model.body(i).armature;
      D_inverse[i] = inverse_of_positive_definite<Scalar>(D);
      felt_by_parent -= U[i] * D_inverse[i] * U[i].transpose();
    }
    IA[model.body(i).parent] += k.X[i] * felt_by_parent * k.X[i].transpose();
  }
  return result;
}

}  // namespace treeline::interpreter
