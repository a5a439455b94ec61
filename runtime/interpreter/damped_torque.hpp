#pragma once

#include <Eigen/Eigenvalues>

#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/lambda_inverse.hpp"
#include "interpreter/point_accelerations.hpp"

namespace treeline::interpreter {

/// F of (A + Delta) F = b, where Delta lets directions yield that feel heavier than `heaviest` (kg,
/// kg m^2, by rows): see `core::damped_solve`, of which this is the definition as it stands,
/// F = S V diag(1 / (s + delta(s))) V^T S b with S = diag(sqrt(heaviest)), S A S = V diag(s) V^T,
/// delta(s) = (1 - s)^3 for s < 1 and else 0.
template <class Scalar>
Vector<Scalar> damped_force(const Matrix<Scalar>& A, VectorArg<Scalar> heaviest,
                            VectorArg<Scalar> b) {
  const Vector<Scalar> S = heaviest.cwiseSqrt();
  const Matrix<Scalar> scaled = S.asDiagonal() * A * S.asDiagonal();
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::SelfAdjointEigenSolver<Dense> eigen{Dense(scaled)};
  Vector<Scalar> along = eigen.eigenvectors().transpose() * S.cwiseProduct(b);
  for (Eigen::Index k = 0; k < along.size(); ++k) {
    const Scalar s = eigen.eigenvalues()(k);
    const Scalar lack = s < Scalar(1) ? Scalar(Scalar(1) - s) : Scalar(0);
    along(k) /= s + lack * lack * lack;
  }
  return S.cwiseProduct(eigen.eigenvectors() * along);
}

/// `control_torque` (Chang table 6.1) with the force of the task damped.
template <class Scalar>
Vector<Scalar> damped_control_torque(const Model<Scalar>& model, PointsArg<Scalar> points,
                                     VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                     VectorArg<Scalar> qdd_0, VectorArg<Scalar> xdd_cmd,
                                     VectorArg<Scalar> heaviest) {
  const Vector<Scalar> missing = xdd_cmd - point_accelerations<Scalar>(model, points, q, qd, qdd_0);
  const Vector<Scalar> F =
      damped_force<Scalar>(lambda_inverse<Scalar>(model, points, q), heaviest, missing);
  return inverse_dynamics<Scalar>(model, q, qd, qdd_0) +
         jacobian<Scalar>(model, points, q).transpose() * F;
}

}  // namespace treeline::interpreter
