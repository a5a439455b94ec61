#pragma once

#include <vector>

#include "recursion/methods/control_torque.hpp"
#include "recursion/tree/object_tree.hpp"

namespace treeline {

template <class Scalar>
std::vector<Scalar> operator*(const DenseMatrix<Scalar>& A, const std::vector<Scalar>& x) {
  std::vector<Scalar> y(A.rows(), Scalar(0.0));
  for (std::size_t i = 0; i < A.rows(); ++i) {
    for (std::size_t j = 0; j < A.cols(); ++j) {
      y[i] = y[i] + A(i, j) * x[j];
    }
  }
  return y;
}

/// Lambda_obj xdd + mu_obj + p_obj at the object's origin, in its axes, as seen from its first
/// grasp.
template <class Scalar>
Wrench<Scalar> object_wrench(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                             const TreeObject<Scalar>& object,
                             const std::vector<LinkMotion<Scalar>>& motions,
                             const Vector3<Scalar>& acceleration,
                             const Vector3<Scalar>& angular_acceleration) {
  const TreeGrasp<Scalar>& first = object.grasps.front();
  const auto to_object = [&](const Vector3<Scalar>& v) {
    return transposed_times(first.R, carried_to_link(tree, X, first.link, v));
  };
  LinkMotion<Scalar> motion;
  motion.w = transposed_times(first.R, motions[static_cast<std::size_t>(first.link)].w);
  motion.wd = to_object(angular_acceleration);
  motion.a = to_object(acceleration - tree.gravity);
  motion.U = angular_matrix(motion.w, motion.wd);
  return inertial_wrench(object.inertia, motion);
}

template <class Scalar>
struct ObjectCommand {
  std::span<const Scalar> xdd_object, internal;
};

/// Wrenches on the links due to the hands' reactions: -W^-1 [F_obj; F_int].
template <class Scalar>
std::vector<Wrench<Scalar>> grasp_reactions(const Tree<Scalar>& tree,
                                            const std::vector<JointTransform<Scalar>>& X,
                                            const std::vector<TreeObject<Scalar>>& objects,
                                            const std::vector<LinkMotion<Scalar>>& motions,
                                            const ObjectCommand<Scalar>& command) {
  std::vector<Wrench<Scalar>> reactions(tree.links.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const TreeObject<Scalar>& object = objects[k];
    const auto xdd = command.xdd_object.subspan(6 * k, 6);
    const Wrench<Scalar> F = object_wrench<Scalar>(
        tree, X, object, motions, {xdd[0], xdd[1], xdd[2]}, {xdd[3], xdd[4], xdd[5]});
    std::vector<Scalar> wanted{F.f.x, F.f.y, F.f.z, F.n.x, F.n.y, F.n.z};
    const auto internal = command.internal.subspan(next, 6 * (object.grasps.size() - 1));
    wanted.insert(wanted.end(), internal.begin(), internal.end());
    next += internal.size();
    const std::vector<Scalar> forces = object.split * wanted;
    for (std::size_t i = 0; i < object.grasps.size(); ++i) {
      const TreeGrasp<Scalar>& grasp = object.grasps[i];
      const Scalar* own = forces.data() + 6 * i;
      const Vector3<Scalar> f = grasp.R * Vector3<Scalar>{own[0], own[1], own[2]};
      const Vector3<Scalar> n = grasp.R * Vector3<Scalar>{own[3], own[4], own[5]};
      Wrench<Scalar>& wrench = reactions[static_cast<std::size_t>(grasp.link)];
      wrench = wrench - wrench_at(f, n, grasp.p + grasp.R * grasp.r);
    }
  }
  return reactions;
}

/// tau = RNEA(q, qd, qdd_0) + J^T f with f = Lambda_e (C xdd - Jd qd - J qdd_0) + W^-1 [F_obj;
/// F_int] (Chang table 7.1): the control torque of the robot alone at the points that hold objects,
/// with the objects' reactions as external forces. `tree` must come from `holding_tree`.
template <class Scalar>
std::vector<Scalar> object_control_torque(const Tree<Scalar>& tree,
                                          const std::vector<TreeObject<Scalar>>& objects,
                                          const std::vector<JointTransform<Scalar>>& X,
                                          const JointRates<Scalar>& rates,
                                          const ObjectCommand<Scalar>& command,
                                          const LambdaChoice& choice, const PivotRule& rule = {}) {
  const auto motions = outward_motion(tree, X, rates, -tree.gravity);
  std::vector<Scalar> xdd_points;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const auto own = command.xdd_object.subspan(6 * k, 6);
    for (std::size_t i = 0; i < objects[k].grasps.size(); ++i) {
      xdd_points.insert(xdd_points.end(), own.begin(), own.end());
    }
  }
  return control_torque<Scalar>(
      tree, X, {rates, xdd_points, grasp_reactions(tree, X, objects, motions, command)}, choice,
      xdd_points.size(), rule);
}

}  // namespace treeline
