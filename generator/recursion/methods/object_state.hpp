#pragma once

#include <vector>

#include "recursion/methods/forward_kinematics.hpp"
#include "recursion/methods/link_velocities.hpp"
#include "recursion/tree/object_tree.hpp"

namespace treeline {

/// Pose and velocity of an object according to one grasp, world axes.
template <class Scalar>
struct HeldObject {
  Matrix3<Scalar> R;  ///< from object's axes to world axes
  Vector3<Scalar> p;  ///< origin of the object
  Vector3<Scalar> v, w;
};

template <class Scalar>
HeldObject<Scalar> held_object(const std::vector<WorldPose<Scalar>>& poses,
                               const std::vector<LinkVelocity<Scalar>>& velocities,
                               const TreeGrasp<Scalar>& grasp) {
  const auto i = static_cast<std::size_t>(grasp.link);
  const Matrix3<Scalar>& R = poses[i].R;
  const LinkVelocity<Scalar>& link = velocities[i];
  return {R * grasp.R, poses[i].p + R * grasp.p, R * (link.v + cross(link.w, grasp.p)), R * link.w};
}

/// Drift of a grasp: the object's pose and velocity according to this grasp, minus those according
/// to its first grasp, linear over angular. The rotation is the sine of its angle along its axis.
template <class Scalar>
struct Drift {
  Vector3<Scalar> position, turn, velocity, angular_velocity;
};

template <class Scalar>
Drift<Scalar> drift_between(const HeldObject<Scalar>& first, const HeldObject<Scalar>& held) {
  const Matrix3<Scalar> a = transposed(first.R);
  const Matrix3<Scalar> b = transposed(held.R);
  const Vector3<Scalar> turn =
      cross(a.row_x, b.row_x) + cross(a.row_y, b.row_y) + cross(a.row_z, b.row_z);
  return {held.p - first.p, turn * Scalar(0.5), held.v - first.v, held.w - first.w};
}

template <class Scalar>
void append(const Vector3<Scalar>& v, std::vector<Scalar>& values) {
  values.insert(values.end(), {v.x, v.y, v.z});
}

/// Results of `object_state`.
template <class Scalar>
struct ObjectState {
  std::vector<Scalar> position, rotation, velocity;  ///< 3, 9, 6 per object, by its first grasp
  std::vector<Scalar> drift, drift_rate;             ///< 6 per further grasp
};

template <class Scalar>
ObjectState<Scalar> object_state(const Tree<Scalar>& tree,
                                 const std::vector<TreeObject<Scalar>>& objects,
                                 const std::vector<JointTransform<Scalar>>& X,
                                 std::span<const Scalar> qd) {
  const auto poses = world_poses(tree, X);
  const auto velocities = link_velocities(tree, X, {qd, {}});
  ObjectState<Scalar> state;
  for (const TreeObject<Scalar>& object : objects) {
    const auto first = held_object(poses, velocities, object.grasps.front());
    append(first.p, state.position);
    append(first.R.row_x, state.rotation);
    append(first.R.row_y, state.rotation);
    append(first.R.row_z, state.rotation);
    append(first.v, state.velocity);
    append(first.w, state.velocity);
    for (std::size_t i = 1; i < object.grasps.size(); ++i) {
      const auto drift = drift_between(first, held_object(poses, velocities, object.grasps[i]));
      append(drift.position, state.drift);
      append(drift.turn, state.drift);
      append(drift.velocity, state.drift_rate);
      append(drift.angular_velocity, state.drift_rate);
    }
  }
  return state;
}

}  // namespace treeline
