#pragma once

#include <vector>

#include "recursion/lambda_inverse.hpp"
#include "recursion/shift_lambda_inverse.hpp"

namespace treeline {

/// A world vector in a link's axes, carried joint by joint. Points that share a trunk share its
/// part of the way if they carry the same vector.
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

/// A vector given in a point's axes, in its link's.
template <class Scalar>
Vector3<Scalar> to_link_axes(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                             const TreePoint<Scalar>& point, const Vector3<Scalar>& v) {
  return point.axes == Axes::world ? carried_to_link(tree, X, point.link, v) : point.R * v;
}

/// Wrenches on links from the external forces, six numbers a point.
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

/// How Lambda^-1 is computed.
enum class LambdaRoute { force_propagation, factors_inward, factors_world };

/// Whether `route` can serve the tree: articulated recursions end where joints share a coordinate;
/// world Jacobians serve tasks asked in world axes.
template <class Scalar>
bool permits(const Tree<Scalar>& tree, TaskBasis basis, LambdaRoute route) {
  if (!permits(tree, basis) || (tree.has_mimics && route == LambdaRoute::force_propagation)) {
    return false;
  }
  const bool all_world =
      std::all_of(tree.operational_points.begin(), tree.operational_points.end(),
                  [](const TreePoint<Scalar>& point) { return point.axes == Axes::world; });
  return route != LambdaRoute::factors_world || (all_world && !basis.in_link_axes);
}

/// Lambda^-1 in `basis`.
template <class Scalar>
DenseMatrix<Scalar> lambda_inverse(const Tree<Scalar>& tree,
                                   const std::vector<JointTransform<Scalar>>& X,
                                   const std::vector<WorldPose<Scalar>>& poses, TaskBasis basis,
                                   LambdaRoute route, std::size_t rows) {
  if (route == LambdaRoute::factors_world) {
    return lambda_inverse_by_factors(tree, X,
                                     jacobian_world(tree, poses, basis.at_link_origin, rows));
  }
  const auto tasks = task_points(tree, basis, poses);
  return route == LambdaRoute::force_propagation
             ? lambda_inverse_by_force_propagation(tree, X, tasks, rows)
             : lambda_inverse_by_factors(tree, X, jacobian_inward(tree, X, tasks, rows));
}

/// xdd_cmd - (Jd qd + J qdd_0) of one point, all in `basis`, gravity taken out of the motion again
/// (motion.a is the true acceleration minus g).
template <class Scalar>
std::vector<Scalar> acceleration_error(const Tree<Scalar>& tree,
                                       const std::vector<JointTransform<Scalar>>& X,
                                       const TreePoint<Scalar>& point,
                                       const TaskPoint<Scalar>& task, TaskBasis basis,
                                       const LinkMotion<Scalar>& motion,
                                       std::span<const Scalar> xdd) {
  if (!basis.in_link_axes && !basis.at_link_origin) {
    const Vector3<Scalar> linear =
        acceleration_at(motion, point.p) + carried_to_link(tree, X, point.link, tree.gravity);
    std::vector<Scalar> error;
    for (std::size_t k = 0; k < task.rows.size(); ++k) {
      const TaskRow<Scalar>& row = task.rows[k];
      error.push_back(xdd[k] - dot(row.e, row.angular ? motion.wd : linear));
    }
    return error;
  }
  const bool linear_rows = point.rows[0];
  const bool angular_rows = point.rows[3];
  const bool world = point.axes == Axes::world;
  std::vector<Scalar> error;
  Vector3<Scalar> wd_error;
  if (angular_rows) {
    const std::size_t at = linear_rows ? 3 : 0;
    wd_error = to_link_axes(tree, X, point, Vector3<Scalar>{xdd[at], xdd[at + 1], xdd[at + 2]}) -
               motion.wd;
  }
  if (linear_rows) {
    const Vector3<Scalar> asked{xdd[0], xdd[1], xdd[2]};
    const Vector3<Scalar> wanted =
        world ? carried_to_link(tree, X, point.link, asked - tree.gravity)
              : point.R * asked - carried_to_link(tree, X, point.link, tree.gravity);
    const Vector3<Scalar> at_point = wanted - acceleration_at(motion, point.p);
    const Vector3<Scalar> linear =
        basis.at_link_origin ? at_point - cross(wd_error, point.p) : at_point;
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

/// tau = RNEA(q, qd, qdd_0) + J^T F, F = Lambda (xdd_cmd - Jd qd - J qdd_0) (Chang table 6.1),
/// fused: the outward pass of RNEA yields the accelerations of the points, and F enters its inward
/// pass as forces at the points, so that no Jacobian is formed.
template <class Scalar>
std::vector<Scalar> control_torque(const Tree<Scalar>& tree,
                                   const std::vector<JointTransform<Scalar>>& X,
                                   const ControlInputs<Scalar>& inputs, TaskBasis basis,
                                   LambdaRoute route, std::size_t row_count) {
  const auto poses = world_poses(tree, X);
  const auto motions = outward_motion(tree, X, inputs.rates, -tree.gravity);
  const auto tasks = task_points(tree, basis, poses);
  std::vector<Scalar> errors;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const TreePoint<Scalar>& point = tree.operational_points[k];
    LinkMotion<Scalar> motion;
    motion.a = -tree.gravity;
    if (point.link >= 0) {
      motion = motions[static_cast<std::size_t>(point.link)];
    }
    const auto error = acceleration_error(tree, X, point, tasks[k], basis, motion,
                                          inputs.xdd_cmd.subspan(errors.size()));
    errors.insert(errors.end(), error.begin(), error.end());
  }
  const auto F =
      solve(factor_ldlt(lambda_inverse(tree, X, poses, basis, route, row_count)), errors);
  std::vector<Wrench<Scalar>> wrenches = inertial_wrenches(tree, motions);
  for (std::size_t i = 0; i < inputs.applied.size(); ++i) {
    wrenches[i] = wrenches[i] - inputs.applied[i];
  }
  std::size_t row = 0;
  for (const TaskPoint<Scalar>& task : tasks) {
    Wrench<Scalar> at_point;
    for (const TaskRow<Scalar>& direction : task.rows) {
      Vector3<Scalar>& sum = direction.angular ? at_point.n : at_point.f;
      sum = sum + direction.e * F[row++];
    }
    if (task.link >= 0) {
      Wrench<Scalar>& wrench = wrenches[static_cast<std::size_t>(task.link)];
      wrench = wrench + wrench_at(at_point.f, at_point.n, task.r);
    }
  }
  return inward_forces(tree, X, std::move(wrenches));
}

}  // namespace treeline
