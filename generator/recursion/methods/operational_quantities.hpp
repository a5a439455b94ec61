#pragma once

#include <span>
#include <vector>

#include "recursion/methods/forward_dynamics.hpp"
#include "recursion/methods/lambda_routes.hpp"

// The quantities of operational-space control by themselves (Khatib 1987; Chang sect. 2.2, 2.3).
// Where rows yield, all of them have the Lambda whose pivots `rule` inverts.

namespace treeline {

/// J L^-1 with M = L^T D L.
template <class Scalar>
DenseMatrix<Scalar> rows_through_factor(const LtdlFactor<Scalar>& factor, DenseMatrix<Scalar> J) {
  for (std::size_t k = J.cols(); k-- > 0;) {
    for (std::size_t r = 0; r < J.rows(); ++r) {
      for (std::size_t i = 0; i < k; ++i) J(r, i) = J(r, i) - factor.L(k, i) * J(r, k);
    }
  }
  return J;
}

/// Jbar = M^-1 J^T Lambda, nv x rows, J Jbar = 1: the generalized inverse of J that weighs
/// velocities with M, so that motions outside of the task have no kinetic energy in common with it.
/// With M = L^T D L and Y = J L^-1: L Jbar = D^-1 Y^T Lambda.
template <class Scalar>
DenseMatrix<Scalar> dynamically_consistent_inverse(const Tree<Scalar>& tree,
                                                   const std::vector<JointTransform<Scalar>>& X,
                                                   const DenseMatrix<Scalar>& J,
                                                   const PivotRule& rule = {}) {
  const auto factor = factor_ltdl(mass_matrix(tree, X));
  const auto Lambda_inv = factor_ldlt(inverse_inertia_in_rows(factor, J), rule);
  const auto Y = rows_through_factor(factor, J);
  DenseMatrix<Scalar> Jbar(J.cols(), J.rows());
  for (std::size_t k = 0; k < J.cols(); ++k) {
    std::vector<Scalar> column(J.rows());
    for (std::size_t r = 0; r < J.rows(); ++r) column[r] = Y(r, k) * factor.inverse_D[k];
    const auto solved = solve(Lambda_inv, column);
    for (std::size_t r = 0; r < J.rows(); ++r) {
      Jbar(k, r) = solved[r];
      for (std::size_t i = 0; i < k; ++i) Jbar(k, r) = Jbar(k, r) - factor.L(k, i) * Jbar(i, r);
    }
  }
  return Jbar;
}

/// N = 1 - Jbar J, nv x nv: J N = 0 and N M^-1 J^T = 0. Joint forces N^T tau_0 do not accelerate
/// the task, and joint velocities N qd do not move it.
template <class Scalar>
DenseMatrix<Scalar> null_space_projector(const DenseMatrix<Scalar>& Jbar,
                                         const DenseMatrix<Scalar>& J) {
  const std::size_t n = J.cols();
  DenseMatrix<Scalar> N(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      Scalar sum(0.0);
      for (std::size_t r = 0; r < J.rows(); ++r) sum = sum + Jbar(i, r) * J(r, j);
      N(i, j) = i == j ? Scalar(1.0) - sum : -sum;
    }
  }
  return N;
}

/// Solves M qdd = forces in the way that fits the algorithm for Lambda^-1, of which it shares the
/// factors.
template <class Scalar>
std::vector<Scalar> accelerate(const Tree<Scalar>& tree,
                               const std::vector<JointTransform<Scalar>>& X, LambdaRoute route,
                               const std::vector<Scalar>& forces) {
  return uses_factors(route) ? solve(factor_ltdl(mass_matrix(tree, X)), forces)
                             : solve_articulated(tree, X, articulate(tree, X), forces);
}

/// Lambda times the accelerations of the task rows, negative, that the robot has when it moves at
/// qd and these joint forces act against it: Lambda (J M^-1 forces - Jd qd).
template <class Scalar>
std::vector<Scalar> force_against_motion(const Tree<Scalar>& tree,
                                         const std::vector<JointTransform<Scalar>>& X,
                                         const LambdaChoice& choice, std::size_t rows,
                                         const PivotRule& rule, std::span<const Scalar> qd,
                                         std::vector<Scalar> forces) {
  for (Scalar& force : forces) force = -force;
  const auto qdd = accelerate(tree, X, choice.route, forces);
  const auto motions = outward_motion<Scalar>(tree, X, {qd, qdd}, Vector3<Scalar>{});
  auto accelerations =
      row_accelerations(tree, X, task_points(tree, {}, world_poses(tree, X)), motions, qd);
  for (Scalar& acceleration : accelerations) acceleration = -acceleration;
  return solve(factor_ldlt(lambda_inverse_as_asked(tree, X, choice, rows), rule), accelerations);
}

/// mu = Jbar^T b - Lambda Jd qd, without gravity: the task forces that velocities need where the
/// task does not accelerate.
template <class Scalar>
std::vector<Scalar> operational_bias_force(const Tree<Scalar>& tree,
                                           const std::vector<JointTransform<Scalar>>& X,
                                           const LambdaChoice& choice, std::size_t rows,
                                           const PivotRule& rule, std::span<const Scalar> qd) {
  const auto motions = outward_motion<Scalar>(tree, X, {qd, {}}, Vector3<Scalar>{});
  auto b = inward_forces(tree, X, inertial_wrenches(tree, motions));
  add_rotor_and_friction_forces<Scalar>(tree, {qd, {}}, b);
  return force_against_motion<Scalar>(tree, X, choice, rows, rule, qd, std::move(b));
}

/// p = Jbar^T g: the task forces that hold the task against gravity.
template <class Scalar>
std::vector<Scalar> operational_gravity(const Tree<Scalar>& tree,
                                        const std::vector<JointTransform<Scalar>>& X,
                                        const LambdaChoice& choice, std::size_t rows,
                                        const PivotRule& rule) {
  return force_against_motion<Scalar>(tree, X, choice, rows, rule, {},
                                      inverse_dynamics<Scalar>(tree, X, {}, {}));
}

}  // namespace treeline
