#pragma once

#include <Eigen/QR>
#include <type_traits>
#include <vector>

#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/jacobian.hpp"
#include "interpreter/mass_matrix.hpp"
#include "interpreter/point_accelerations.hpp"

namespace treeline::interpreter {

/// A task: points, and the commanded accelerations of their controlled rows.
template <class Scalar>
struct Task {
  Points<Scalar> points;
  Vector<Scalar> xdd_cmd;
};

namespace detail {

/// A^+ of a symmetric positive semidefinite A. Pivots up to `least` count as zero.
template <class Scalar>
Matrix<Scalar> pseudo_inverse(const Matrix<Scalar>& A, const Scalar& least) {
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  const Scalar size = A.colwise().norm().maxCoeff();
  if (!(size > least)) return Matrix<Scalar>::Zero(A.rows(), A.cols());
  Eigen::CompleteOrthogonalDecomposition<Dense> decomposition(A.rows(), A.cols());
  decomposition.setThreshold(Scalar(least / size));
  decomposition.compute(Dense(A));
  return decomposition.pseudoInverse();
}

}  // namespace detail

/// Control torque of any number of tasks in strict priority, the most important first, by recursive
/// projection. Task k acts in the dynamically consistent null space N of all tasks before it,
///     J_k|prec = J_k N,  Lambda_k|prec = (J_k|prec M^-1 J_k|prec^T)^+,
///     tau += J_k|prec^T Lambda_k|prec (xdd_k - Jd_k qd - J_k qdd),  N -= Jbar_k|prec J_k|prec
/// (Khatib, Sentis, Park & Warren 2004), starting from the posture qdd_0. O(n^3) per task. A task
/// does not attempt what it cannot do there: pivots below `tolerance` times the largest of J_k M^-1
/// J_k^T count as zero. `core::prioritized_solve` gives the same result from one factorization.
template <class Scalar>
Vector<Scalar> prioritized_torque(const Model<Scalar>& model,
                                  const std::vector<Task<Scalar>>& tasks, VectorArg<Scalar> q,
                                  VectorArg<Scalar> qd, VectorArg<Scalar> qdd_0,
                                  const std::type_identity_t<Scalar>& tolerance) {
  const Matrix<Scalar> M_inverse =
      inverse_of_positive_definite<Scalar>(mass_matrix<Scalar>(model, q));
  Vector<Scalar> qdd = qdd_0;
  Vector<Scalar> tau = inverse_dynamics<Scalar>(model, q, qd, qdd_0);
  Matrix<Scalar> N = Matrix<Scalar>::Identity(model.nv, model.nv);
  for (const Task<Scalar>& task : tasks) {
    const Matrix<Scalar> J = jacobian<Scalar>(model, task.points, q);
    const Matrix<Scalar> J_prec = J * N;
    const Matrix<Scalar> own = J * M_inverse * J.transpose();
    const Matrix<Scalar> left = J_prec * M_inverse * J_prec.transpose();
    const Scalar least = tolerance * own.diagonal().maxCoeff();
    const Matrix<Scalar> Lambda_prec = detail::pseudo_inverse<Scalar>(left, least);
    const Vector<Scalar> missing =
        task.xdd_cmd - bias_acceleration<Scalar>(model, task.points, q, qd) - J * qdd;
    const Vector<Scalar> added = J_prec.transpose() * (Lambda_prec * missing);
    tau += added;
    qdd += M_inverse * added;
    N -= M_inverse * J_prec.transpose() * Lambda_prec * J_prec;
  }
  return tau;
}

}  // namespace treeline::interpreter
