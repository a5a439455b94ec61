#pragma once

#include <utility>
#include <vector>

#include "recursion/algebra/pivot_rule.hpp"
#include "recursion/methods/forces_of_rows.hpp"
#include "recursion/methods/lambda_routes.hpp"
#include "recursion/methods/task_shares.hpp"

namespace treeline {

/// Transforms a vector from world axes to a link's axes, joint by joint. Points that share a trunk
/// share this part of the computation if they have the same vector.
template <class Scalar>
Vector3<Scalar> carried_to_link(const Tree<Scalar>& tree,
                                const std::vector<JointTransform<Scalar>>& X, int link,
                                const Vector3<Scalar>& v) {
  if (link < 0) {
    return v;
  }
  const auto i = static_cast<std::size_t>(link);
  return X[i].to_child(carried_to_link(tree, X, tree.links[i].parent, v));
}

/// Transforms a vector from a point's axes to its link's axes.
template <class Scalar>
Vector3<Scalar> to_link_axes(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                             const TreePoint<Scalar>& point, const Vector3<Scalar>& v) {
  return point.axes == Axes::world ? carried_to_link(tree, X, point.link, v) : point.R * v;
}

/// Wrenches on links due to the external forces, which have six numbers per point.
template <class Scalar>
std::vector<Wrench<Scalar>> applied_wrenches(const Tree<Scalar>& tree,
                                             const std::vector<JointTransform<Scalar>>& X,
                                             std::span<const Scalar> f_ext) {
  std::vector<Wrench<Scalar>> applied(tree.links.size());
  for (std::size_t k = 0; k < tree.external_forces.size(); ++k) {
    const TreePoint<Scalar>& point = tree.external_forces[k];
    if (point.link < 0) {
      continue;
    }
    const std::size_t at = 6 * k;
    const auto f =
        to_link_axes(tree, X, point, Vector3<Scalar>{f_ext[at], f_ext[at + 1], f_ext[at + 2]});
    const auto n =
        to_link_axes(tree, X, point, Vector3<Scalar>{f_ext[at + 3], f_ext[at + 4], f_ext[at + 5]});
    Wrench<Scalar>& wrench = applied[static_cast<std::size_t>(point.link)];
    wrench = wrench + wrench_at(f, n, point.p);
  }
  return applied;
}

/// Transforms a vector from a link's axes to the task's axes.
template <class Scalar>
Vector3<Scalar> to_task_axes(const TaskPoint<Scalar>& task, const Vector3<Scalar>& v) {
  return {dot(task.rows[0].e, v), dot(task.rows[1].e, v), dot(task.rows[2].e, v)};
}

/// Transforms a vector from a point's axes to those of `basis`.
template <class Scalar>
Vector3<Scalar> to_basis_axes(const Tree<Scalar>& tree,
                              const std::vector<JointTransform<Scalar>>& X,
                              const TreePoint<Scalar>& point, const TaskPoint<Scalar>& task,
                              TaskBasis basis, const Vector3<Scalar>& v) {
  if (basis.axes_link >= 0) {
    return point.axes == Axes::world ? carried_to_link(tree, X, basis.axes_link, v)
                                     : to_task_axes(task, point.R * v);
  }
  return to_link_axes(tree, X, point, v);
}

/// xdd_cmd - (Jd qd + J qdd_0) for one point, in the rows of the scene. `motion` is one of
/// `motions_of_rows`, from which gravity is removed: motion.a is the true acceleration minus g.
template <class Scalar>
std::vector<Scalar> asked_acceleration_error(const Tree<Scalar>& tree,
                                             const std::vector<JointTransform<Scalar>>& X,
                                             const TreePoint<Scalar>& point,
                                             const TaskPoint<Scalar>& task,
                                             const LinkMotion<Scalar>& motion,
                                             std::span<const Scalar> xdd) {
  const Vector3<Scalar> linear =
      acceleration_at(motion, point.p) + carried_to_link(tree, X, point.link, tree.gravity);
  std::vector<Scalar> error;
  for (std::size_t k = 0; k < task.rows.size(); ++k) {
    const TaskRow<Scalar>& row = task.rows[k];
    error.push_back(xdd[k] - dot(row.e, row.angular ? motion.wd : linear));
  }
  return error;
}

/// xdd_cmd - (Jd qd + J qdd_0) for one point with whole triples of rows, in the axes and at the
/// reference point of `basis`.
template <class Scalar>
std::vector<Scalar> acceleration_error(const Tree<Scalar>& tree,
                                       const std::vector<JointTransform<Scalar>>& X,
                                       const TreePoint<Scalar>& point,
                                       const TaskPoint<Scalar>& task, TaskBasis basis,
                                       const LinkMotion<Scalar>& motion,
                                       std::span<const Scalar> xdd) {
  const bool linear_rows = point.rows[0];
  const bool angular_rows = point.rows[3];
  const auto to_basis = [&](const Vector3<Scalar>& v) {
    return to_basis_axes(tree, X, point, task, basis, v);
  };
  std::vector<Scalar> error;
  Vector3<Scalar> wd_error;
  if (angular_rows) {
    const std::size_t at = linear_rows ? 3 : 0;
    wd_error = to_basis({xdd[at], xdd[at + 1], xdd[at + 2]}) - to_task_axes(task, motion.wd);
  }
  if (linear_rows) {
    const Vector3<Scalar> asked{xdd[0], xdd[1], xdd[2]};
    const int axes = basis.axes_link >= 0 ? basis.axes_link : point.link;
    const Vector3<Scalar> wanted =
        point.axes == Axes::world ? carried_to_link(tree, X, axes, asked - tree.gravity)
                                  : to_basis(asked) - carried_to_link(tree, X, axes, tree.gravity);
    const Vector3<Scalar> at_point = wanted - to_task_axes(task, acceleration_at(motion, point.p));
    const Vector3<Scalar> linear =
        basis.at_link_origin ? at_point - cross(wd_error, to_task_axes(task, point.p)) : at_point;
    error = {linear.x, linear.y, linear.z};
  }
  if (angular_rows) {
    error.insert(error.end(), {wd_error.x, wd_error.y, wd_error.z});
  }
  return error;
}

template <class Scalar>
struct ControlInputs {
  JointRates<Scalar> rates;  ///< qd, qdd_0
  std::span<const Scalar> xdd_cmd;
  std::vector<Wrench<Scalar>> applied;
};

/// Basis in which the rows of a control torque are computed.
template <class Scalar>
TaskBasis control_basis(const Tree<Scalar>& tree, const LambdaChoice& choice) {
  return has_priorities(tree) ? TaskBasis{} : choice.basis;
}

/// F = Lambda times the acceleration errors; for priorities see `prioritized_task_force`. Chang
/// table 5.1 gives Lambda itself, at one link's origin and in its axes. All other routes give its
/// inverse, and `rule` inverts the pivots of the inverse's LDL^T. Tasks that are done in part: see
/// `TaskShares`.
template <class Scalar>
std::vector<Scalar> task_force(const Tree<Scalar>& tree,
                               const std::vector<JointTransform<Scalar>>& X,
                               const std::vector<WorldPose<Scalar>>& poses,
                               const LambdaChoice& choice, std::size_t row_count,
                               const PivotRule& rule, const std::vector<Scalar>& errors) {
  const TaskShares<Scalar> shares(tree);
  const auto lacking = shares.times(errors);
  if (has_priorities(tree)) {
    const auto A = shares.weakened(lambda_inverse_as_asked(tree, X, choice, row_count));
    return shares.times(prioritized_task_force(tree, A, lacking, rule));
  }
  if (choice.route != LambdaRoute::inertia_propagation) {
    auto A = shares.weakened(lambda_inverse(tree, X, poses, choice, row_count));
    return shares.times(solve(factor_ldlt(std::move(A), rule), lacking));
  }
  const auto Lambda = dense(propagated_inertia(tree, X, tree.operational_points.front().link));
  std::vector<Scalar> F(6, Scalar(0.0));
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      F[i] = F[i] + Lambda(i, j) * lacking[j];
    }
  }
  return shares.times(std::move(F));
}

/// tau = RNEA(q, qd, qdd_0) + J^T F with F = Lambda (xdd_cmd - Jd qd - J qdd_0) (Chang table 6.1).
/// The two parts are fused: the outward pass of RNEA gives the accelerations of the points, and F
/// enters its inward pass as forces at the points. So no Jacobian is formed. `rule` must belong to
/// the basis from `control_basis`.
template <class Scalar>
std::vector<Scalar> control_torque(const Tree<Scalar>& tree,
                                   const std::vector<JointTransform<Scalar>>& X,
                                   const ControlInputs<Scalar>& inputs, const LambdaChoice& choice,
                                   std::size_t row_count, const PivotRule& rule = {}) {
  const TaskBasis basis = control_basis(tree, choice);
  const bool as_asked = !basis.in_link_axes && basis.axes_link < 0;
  const auto poses = poses_seen_from(tree, X, basis.axes_link);
  const auto motions = outward_motion(tree, X, inputs.rates, -tree.gravity);
  const auto tasks = task_points(tree, basis, poses);
  const auto of_rows = motions_of_rows(tree, X, motions, inputs.rates.qd, -tree.gravity);
  std::vector<Scalar> errors;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const TreePoint<Scalar>& point = tree.operational_points[k];
    const auto xdd = inputs.xdd_cmd.subspan(errors.size());
    const auto error = as_asked
                           ? asked_acceleration_error(tree, X, point, tasks[k], of_rows[k], xdd)
                           : acceleration_error(tree, X, point, tasks[k], basis, of_rows[k], xdd);
    errors.insert(errors.end(), error.begin(), error.end());
  }
  const auto F = task_force(tree, X, poses, choice, row_count, rule, errors);
  std::vector<Wrench<Scalar>> wrenches = inertial_wrenches(tree, motions);
  for (std::size_t i = 0; i < inputs.applied.size(); ++i) {
    wrenches[i] = wrenches[i] - inputs.applied[i];
  }
  add_row_forces(tasks, F, wrenches);
  auto tau = inward_forces(tree, X, std::move(wrenches));
  add_drive_forces(tree, X, inputs.rates, tau);
  return tau;
}

}  // namespace treeline
