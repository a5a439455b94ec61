#pragma once

#include <algorithm>
#include <vector>

#include "recursion/methods/control_torque.hpp"

namespace treeline {

/// Whether the robot has six joints for six task rows in the simplest arrangement: one point with
/// all rows on the last of six links, whose last three rotate about axes through one point, a
/// spherical wrist. The Jacobian at the wrist's centre is then block triangular.
template <class Scalar>
bool permits_resolved_acceleration(const Tree<Scalar>& tree) {
  if (tree.links.size() != 6 || tree.nv != 6 || tree.operational_points.size() != 1 ||
      tree.operational_points.front().link != 5 || !has_all_rows(tree.operational_points.front())) {
    return false;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    if (tree.links[i].parent != static_cast<int>(i) - 1 || !tree.links[i].has_one_coordinate()) {
      return false;
    }
  }
  const auto is_zero = [](const Vector3<Scalar>& v) {
    const Scalar zero(0.0);
    return v.x == zero && v.y == zero && v.z == zero;
  };
  const auto turns = [&](std::size_t i) { return tree.links[i].turns_by_angle(); };
  return turns(3) && turns(4) && turns(5) && is_zero(tree.links[4].p) && is_zero(tree.links[5].p);
}

/// Solves [a b c] x = v by cofactors. If the three directions are far from lying in a plane, this
/// is as accurate as pivoting.
template <class Scalar>
Vector3<Scalar> solve_columns(const Vector3<Scalar>& a, const Vector3<Scalar>& b,
                              const Vector3<Scalar>& c, const Vector3<Scalar>& v) {
  const Vector3<Scalar> bc = cross(b, c);
  const Scalar inverse_det = Scalar(1.0) / dot(a, bc);
  const Vector3<Scalar> va = cross(v, a);  // v.(c x a) = c.(a x v)
  return Vector3<Scalar>{dot(v, bc), -dot(c, va), dot(b, va)} * inverse_det;
}

/// The accelerations of a task without a null space that is done to the share of its point, and for
/// the rest those of the posture: with one point F is s^2-fold, see `TaskShares`.
template <class Scalar>
std::vector<Scalar> shared_with_posture(const TreePoint<Scalar>& point, std::vector<Scalar> qdd,
                                        const JointRates<Scalar>& rates) {
  const Scalar done = point.share * point.share;
  const Scalar left = Scalar(1.0) - done;
  for (std::size_t v = 0; v < qdd.size(); ++v) {
    qdd[v] = done * qdd[v] + left * rates.acceleration(v);
  }
  return qdd;
}

/// Control torque of a robot without a null space. With as many joints as rows, J^T Lambda J = M,
/// so tau = J^T F + M qdd_0 + b + g of Chang table 6.1 equals M qdd + b + g with J qdd = xdd_cmd -
/// Jd qd, whatever qdd_0 is, unless the task is done in part. J is computed at the wrist's centre
/// in the axes of link `axes_link`.
template <class Scalar>
std::vector<Scalar> control_torque_by_resolved_acceleration(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
    const ControlInputs<Scalar>& inputs, int axes_link) {
  const TaskBasis basis{false, true, axes_link};
  const auto poses = poses_seen_from(tree, X, axes_link);
  const TreePoint<Scalar>& point = tree.operational_points.front();
  const auto motions = outward_motion(tree, X, {inputs.rates.qd, {}}, -tree.gravity);
  const auto of_rows = motions_of_rows(tree, X, motions, inputs.rates.qd, -tree.gravity);
  const auto error = acceleration_error(tree, X, point, task_point(point, basis, poses), basis,
                                        of_rows.front(), inputs.xdd_cmd);
  const auto J = jacobian_world(tree, poses, basis, 6);
  const auto column = [&J](std::size_t row, std::size_t j) {
    return Vector3<Scalar>{J(row, j), J(row + 1, j), J(row + 2, j)};
  };
  const Vector3<Scalar> arm = solve_columns<Scalar>(column(0, 0), column(0, 1), column(0, 2),
                                                    {error[0], error[1], error[2]});
  const Vector3<Scalar> rest = Vector3<Scalar>{error[3], error[4], error[5]} -
                               column(3, 0) * arm.x - column(3, 1) * arm.y - column(3, 2) * arm.z;
  const Vector3<Scalar> wrist = solve_columns(column(3, 3), column(3, 4), column(3, 5), rest);
  const auto qdd =
      shared_with_posture(point, {arm.x, arm.y, arm.z, wrist.x, wrist.y, wrist.z}, inputs.rates);
  return inverse_dynamics<Scalar>(tree, X, {inputs.rates.qd, qdd}, inputs.applied);
}

}  // namespace treeline
