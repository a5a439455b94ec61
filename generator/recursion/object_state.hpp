#pragma once

#include <vector>

#include "recursion/object_tree.hpp"
#include "recursion/outward_motion.hpp"

namespace treeline {

/// Velocity of a link's origin and angular velocity, in the link's axes.
template <class Scalar>
struct LinkVelocity {
  Vector3<Scalar> v, w;
};

template <class Scalar>
std::vector<LinkVelocity<Scalar>> link_velocities(const Tree<Scalar>& tree,
                                                  const std::vector<JointTransform<Scalar>>& X,
                                                  const JointRates<Scalar>& rates) {
  std::vector<LinkVelocity<Scalar>> velocities;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "velocity");
    const LinkVelocity<Scalar> parent = link.parent < 0
                                            ? LinkVelocity<Scalar>{}
                                            : velocities[static_cast<std::size_t>(link.parent)];
    LinkVelocity<Scalar> own{X[i].to_child(parent.v + cross(parent.w, X[i].p)),
                             X[i].to_child(parent.w)};
    const auto at = static_cast<std::size_t>(link.v_index);
    if (link.kind == JointKind::floating) {
      own.v = own.v + velocity_triple(rates, at);
      own.w = own.w + velocity_triple(rates, at + 3);
    } else {
      Scalar& along = link.kind == JointKind::revolute ? own.w.z : own.v.z;
      along = along + link.multiplier * rates.velocity(at);
    }
    velocities.push_back(own);
  }
  return velocities;
}

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
