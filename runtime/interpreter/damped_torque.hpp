#pragma once

#include <Eigen/Eigenvalues>

#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/lambda_inverse.hpp"
#include "interpreter/point_accelerations.hpp"

namespace treeline::interpreter {

/// Which directions of a task yield: those that feel heavier than `heaviest` (kg, kg m^2, by rows).
template <class Scalar>
struct Damping {
  Vector<Scalar> heaviest;
  /// Where the arithmetic of the code leaves eases near 1 no digit, they yield sooner: below this
  /// part of the largest ease. 0: the law as it is defined.
  Scalar resolution = 0;
};

template <class To, class From>
Damping<To> cast(const Damping<From>& damping) {
  return {damping.heaviest.template cast<To>(), static_cast<To>(damping.resolution)};
}

/// The forces of a damped task, and the least of the eases: 1 and more where nothing yields.
template <class Scalar>
struct DampedForce {
  Vector<Scalar> F;
  Scalar ease{};
};

/// s + delta(s), delta(s) = b (1 - s / b)^3 for s < b and else 0, b = max(1, resolution x largest).
template <class Scalar>
Vector<Scalar> damped_eases(const Vector<Scalar>& eases, const Scalar& resolution) {
  const Scalar resolved = resolution * eases(eases.size() - 1);
  const Scalar border = resolved > Scalar(1) ? resolved : Scalar(1);
  Vector<Scalar> damped = eases;
  for (Eigen::Index k = 0; k < eases.size(); ++k) {
    const Scalar lack = eases(k) < border ? Scalar(1 - eases(k) / border) : Scalar(0);
    damped(k) += border * lack * lack * lack;
  }
  return damped;
}

/// The directions of a task and how easily they move, ascending: S A S = V diag(values) V^T with
/// S = diag(sqrt(heaviest)).
template <class Scalar>
struct Eases {
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Vector<Scalar> roots;  ///< S
  Vector<Scalar> values;
  Dense directions;  ///< V

  Eases(const Matrix<Scalar>& A, const Vector<Scalar>& heaviest) : roots(heaviest.cwiseSqrt()) {
    const Matrix<Scalar> scaled = roots.asDiagonal() * A * roots.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Dense> eigen{Dense(scaled)};
    values = eigen.eigenvalues();
    directions = eigen.eigenvectors();
  }
};

/// F of (A + Delta) F = b, where Delta lets heavy directions yield: see `core::damped_solve`, of
/// which this is the definition as it stands, F = S V diag(1 / (s + delta(s))) V^T S b with
/// S = diag(sqrt(heaviest)), S A S = V diag(s) V^T.
template <class Scalar>
DampedForce<Scalar> damped_force(const Matrix<Scalar>& A, const Damping<Scalar>& damping,
                                 VectorArg<Scalar> b) {
  const Eases<Scalar> of(A, damping.heaviest);
  const Vector<Scalar> along = of.directions.transpose() * of.roots.cwiseProduct(b);
  const Vector<Scalar> force =
      along.cwiseQuotient(damped_eases<Scalar>(of.values, damping.resolution));
  return {of.roots.cwiseProduct(of.directions * force), of.values(0)};
}

/// A torque, and the least ease of its task.
template <class Scalar>
struct DampedTorque {
  Vector<Scalar> tau;
  Scalar ease{};
};

/// `control_torque` (Chang table 6.1) with the force of the task damped.
template <class Scalar>
DampedTorque<Scalar> damped_control_torque(const Model<Scalar>& model, PointsArg<Scalar> points,
                                           VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                           VectorArg<Scalar> qdd_0, VectorArg<Scalar> xdd_cmd,
                                           const Damping<Scalar>& damping,
                                           PointsArg<Scalar> external = {},
                                           VectorArg<Scalar> f_ext = Vector<Scalar>()) {
  const Vector<Scalar> missing = xdd_cmd - point_accelerations<Scalar>(model, points, q, qd, qdd_0);
  const auto of = damped_force<Scalar>(lambda_inverse<Scalar>(model, points, q), damping, missing);
  return {inverse_dynamics<Scalar>(model, q, qd, qdd_0, external, f_ext) +
              jacobian<Scalar>(model, points, q).transpose() * of.F,
          of.ease};
}

}  // namespace treeline::interpreter
