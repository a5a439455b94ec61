#pragma once

#include <vector>

#include "recursion/algebra/shared_pivots.hpp"
#include "recursion/methods/control_torque.hpp"
#include "recursion/methods/forces_of_rows.hpp"
#include "recursion/methods/forward_dynamics.hpp"
#include "recursion/methods/lambda_inverse.hpp"
#include "recursion/methods/link_velocities.hpp"
#include "recursion/methods/loop_rows.hpp"

namespace treeline {

/// Velocities of the rows of `tasks`.
template <class Scalar>
std::vector<Scalar> row_velocities(const std::vector<TaskPoint<Scalar>>& tasks,
                                   const std::vector<LinkVelocity<Scalar>>& links) {
  std::vector<Scalar> velocities;
  for (const TaskPoint<Scalar>& task : tasks) {
    const LinkVelocity<Scalar>& link = links[static_cast<std::size_t>(task.link)];
    const Vector3<Scalar> linear = link.v + cross(link.w, task.r);
    for (const TaskRow<Scalar>& row : task.rows) {
      velocities.push_back(dot(row.e, row.angular ? link.w : linear));
    }
  }
  return velocities;
}

template <class Scalar>
struct ConstrainedInputs {
  std::span<const Scalar> q, qd, tau;
  std::span<const Scalar> stabilisation;  ///< damping 1/s, stiffness 1/s^2
  std::span<const Scalar> drift;          ///< by row of the points
  std::vector<Wrench<Scalar>> applied;
  std::vector<Scalar> shares = {};  ///< to which rows are held; empty: 1
};

/// Joint accelerations, and forces in the held rows, on the robot.
template <class Scalar>
struct ConstrainedMotion {
  std::vector<Scalar> qdd, f;
};

/// Motion under joint forces while the rows of the operational points of `tree` are held:
///     qdd_o = M^-1 (tau - b - g + J_ext^T f_ext),
///     f = Lambda (-stabilisation - J qdd_o - Jd qd),  qdd = qdd_o + M^-1 J^T f,
/// the KKT system of Gauss' principle, eliminated by Lambda^-1 = J M^-1 J^T. `solve_for_qdd` maps
/// joint forces to accelerations. `rule` inverts the pivots of Lambda^-1: a row that depends on
/// those before it gets no force, and the acceleration is the same whichever row that is. Rows that
/// are held in part, to the share w, yield: J qdd + ... = -(1 - w) / w diag(Lambda^-1) f.
template <class Scalar, class Solve>
ConstrainedMotion<Scalar> constrained_forward_dynamics(const Tree<Scalar>& tree,
                                                       const std::vector<JointTransform<Scalar>>& X,
                                                       const ConstrainedInputs<Scalar>& inputs,
                                                       const LambdaChoice& choice,
                                                       const Solve& solve_for_qdd,
                                                       const PivotRule& rule = {}) {
  std::vector<Scalar> net = inverse_dynamics<Scalar>(tree, X, {inputs.qd, {}}, inputs.applied);
  for (std::size_t i = 0; i < net.size(); ++i) {
    net[i] = inputs.tau[i] - net[i];
  }
  ConstrainedMotion<Scalar> motion;
  motion.qdd = solve_for_qdd(net);
  const auto tasks = task_points(tree, {}, world_poses(tree, X));
  const auto links = outward_motion<Scalar>(tree, X, {inputs.qd, motion.qdd}, Vector3<Scalar>{});
  std::vector<Scalar> missing = row_accelerations(tree, X, tasks, links, inputs.qd);
  const auto velocities = row_velocities(tasks, link_velocities(tree, X, {inputs.qd, {}}));
  for (std::size_t k = 0; k < missing.size(); ++k) {
    missing[k] = -(missing[k] + velocities[k] * inputs.stabilisation[0] +
                   inputs.drift[k] * inputs.stabilisation[1]);
  }
  const auto Lambda_inv = lambda_inverse_as_asked(tree, X, choice, missing.size());
  motion.f = solve(factor_shared(Lambda_inv, rule, inputs.shares), missing);
  const auto change = solve_for_qdd(forces_of_rows(tree, X, tasks, motion.f));
  for (std::size_t i = 0; i < change.size(); ++i) {
    motion.qdd[i] = motion.qdd[i] + change[i];
  }
  return motion;
}

/// J^T f.
template <class Scalar>
std::vector<Scalar> transposed_times(const DenseMatrix<Scalar>& J, const std::vector<Scalar>& f) {
  std::vector<Scalar> product(J.cols(), Scalar(0.0));
  for (std::size_t v = 0; v < J.cols(); ++v) {
    for (std::size_t i = 0; i < f.size(); ++i) product[v] = product[v] + J(i, v) * f[i];
  }
  return product;
}

/// Computes forward dynamics with the rows of points and, after them, of loops held. Unknown forces
/// between two links, or in a joint, are rows of J like any other. Everything is solved with the
/// factors of M, which permit joints that share a coordinate.
template <class Scalar>
ConstrainedMotion<Scalar> looped_forward_dynamics(const Tree<Scalar>& tree,
                                                  const std::vector<JointTransform<Scalar>>& X,
                                                  const ConstrainedInputs<Scalar>& inputs,
                                                  const PivotRule& rule) {
  const auto factor = factor_ltdl(mass_matrix(tree, X));
  std::vector<Scalar> net = inverse_dynamics<Scalar>(tree, X, {inputs.qd, {}}, inputs.applied);
  for (std::size_t i = 0; i < net.size(); ++i) net[i] = inputs.tau[i] - net[i];
  ConstrainedMotion<Scalar> motion;
  motion.qdd = solve(factor, net);
  const auto tasks = task_points(tree, {}, world_poses(tree, X));
  const auto loops = loop_rows(tree, X, inputs.q, inputs.qd);
  std::vector<Scalar> missing = bias_acceleration(tree, X, tasks, inputs.qd);
  const std::size_t anchored = missing.size();
  missing.insert(missing.end(), loops.bias.begin(), loops.bias.end());
  const auto J = jacobian_with_loops(tree, X, tasks, anchored, loops.J);
  const auto velocities = velocities_of(J, inputs.qd);
  for (std::size_t i = 0; i < missing.size(); ++i) {
    for (std::size_t v = 0; v < J.cols(); ++v) missing[i] = missing[i] + J(i, v) * motion.qdd[v];
    const Scalar& error = i < anchored ? inputs.drift[i] : loops.errors[i - anchored];
    missing[i] =
        -(missing[i] + velocities[i] * inputs.stabilisation[0] + error * inputs.stabilisation[1]);
  }
  motion.f =
      solve(factor_shared(lambda_inverse_by_factors(tree, X, J), rule, inputs.shares), missing);
  const auto change = solve(factor, transposed_times(J, motion.f));
  for (std::size_t v = 0; v < change.size(); ++v) motion.qdd[v] = motion.qdd[v] + change[v];
  return motion;
}

}  // namespace treeline
