#pragma once

#include <Eigen/Eigenvalues>

#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/lambda_inverse.hpp"
#include "interpreter/point_accelerations.hpp"

namespace treeline::interpreter {

/// Damping of a task: directions with a larger effective mass than `effective_mass_limits` (kg, kg
/// m^2, by row) are relaxed.
template <class Scalar>
struct Damping {
  Vector<Scalar> effective_mass_limits;
  /// Relaxation begins below this share of the largest eigenvalue, where the arithmetic of the code
  /// has no correct digit. 0: the law as it is defined.
  Scalar resolution = 0;
};

template <class To, class From>
Damping<To> cast(const Damping<From>& damping) {
  return {damping.effective_mass_limits.template cast<To>(), static_cast<To>(damping.resolution)};
}

/// Forces of a damped task, and the smallest eigenvalue of S Lambda^-1 S. It is at least 1 if
/// nothing is relaxed.
template <class Scalar>
struct DampedForce {
  Vector<Scalar> F;
  Scalar least_eigenvalue{};
};

/// s + delta(s) for each eigenvalue s, with delta(s) = b (1 - s / b)^3 for s < b and 0 otherwise, b
/// = max(1, resolution x largest eigenvalue).
template <class Scalar>
Vector<Scalar> damped_eigenvalues(const Vector<Scalar>& eigenvalues, const Scalar& resolution) {
  const Scalar resolved = resolution * eigenvalues(eigenvalues.size() - 1);
  const Scalar border = resolved > Scalar(1) ? resolved : Scalar(1);
  Vector<Scalar> damped = eigenvalues;
  for (Eigen::Index k = 0; k < eigenvalues.size(); ++k) {
    const Scalar lack = eigenvalues(k) < border ? Scalar(1 - eigenvalues(k) / border) : Scalar(0);
    damped(k) += border * lack * lack * lack;
  }
  return damped;
}

/// Directions of a task, with the eigenvalues in ascending order: S A S = V diag(values) V^T with S
/// = diag(sqrt(effective_mass_limits)).
template <class Scalar>
struct ScaledEigensystem {
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Vector<Scalar> roots;  ///< S
  Vector<Scalar> values;
  Dense directions;  ///< V

  ScaledEigensystem(const Matrix<Scalar>& A, const Vector<Scalar>& effective_mass_limits)
      : roots(effective_mass_limits.cwiseSqrt()) {
    const Matrix<Scalar> scaled = roots.asDiagonal() * A * roots.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Dense> eigen{Dense(scaled)};
    values = eigen.eigenvalues();
    directions = eigen.eigenvectors();
  }
};

/// F of (A + Delta) F = b, where Delta relaxes heavy directions. This is the definition of what
/// `core::damped_solve` computes: F = S V diag(1 / (s + delta(s))) V^T S b with S =
/// diag(sqrt(effective_mass_limits)) and S A S = V diag(s) V^T.
template <class Scalar>
DampedForce<Scalar> damped_force(const Matrix<Scalar>& A, const Damping<Scalar>& damping,
                                 VectorArg<Scalar> b) {
  const ScaledEigensystem<Scalar> of(A, damping.effective_mass_limits);
  const Vector<Scalar> along = of.directions.transpose() * of.roots.cwiseProduct(b);
  const Vector<Scalar> force =
      along.cwiseQuotient(damped_eigenvalues<Scalar>(of.values, damping.resolution));
  return {of.roots.cwiseProduct(of.directions * force), of.values(0)};
}

/// A control torque, and the smallest eigenvalue of its task.
template <class Scalar>
struct DampedTorque {
  Vector<Scalar> tau;
  Scalar least_eigenvalue{};
};

/// `control_torque` (Chang table 6.1) with damped task forces.
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
          of.least_eigenvalue};
}

}  // namespace treeline::interpreter
