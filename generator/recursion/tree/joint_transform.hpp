#pragma once

#include <span>
#include <vector>

#include "recursion/tree/model_inputs.hpp"

namespace treeline {

/// Pose of a link's frame in its parent for given q: x_parent = R (Q x) + p. R is the rotation of
/// the joint's placement, Q that of the joint: about z, or the matrix of a quaternion.
template <class Scalar>
struct JointTransform {
  Rotation<Scalar> R;
  PlanarRotation<Scalar> turn;
  bool general = false;  ///< `Q` is used instead of `turn`
  Matrix3<Scalar> Q;
  Vector3<Scalar> p;  ///< in the parent's axes
  Scalar q{};         ///< the joint's coordinate, if it has one

  [[nodiscard]] Vector3<Scalar> to_parent(const Vector3<Scalar>& v) const {
    return rotate(R, general ? Q * v : rotate_z(turn, v));
  }
  [[nodiscard]] Vector3<Scalar> to_child(const Vector3<Scalar>& v) const {
    const Vector3<Scalar> in_placement = rotate_back(R, v);
    return general ? transposed_times(Q, in_placement) : rotate_z(turn.inverse(), in_placement);
  }
  /// R Q A Q^T R^T, where columns of A are rotated too: with them, `congruent` shares Q A.
  [[nodiscard]] Symmetric3<Scalar> matrix_to_parent(const Symmetric3<Scalar>& A) const {
    return rotate(R, general ? congruent(Q, A) : rotate_z(turn, A));
  }
  /// R Q A Q^T R^T of an articulated inertia, of which no columns are rotated.
  [[nodiscard]] Symmetric3<Scalar> lone_matrix_to_parent(const Symmetric3<Scalar>& A) const {
    return rotate(R, general ? turned(Q, A) : rotate_z(turn, A));
  }
  /// R Q A Q^T R^T for a matrix without symmetry.
  [[nodiscard]] Matrix3<Scalar> matrix_to_parent(const Matrix3<Scalar>& A) const {
    return rotate(R, general ? turned(Q, A) : rotate_z(turn, A));
  }
  /// Q^T R^T A R Q for a matrix with or without symmetry.
  template <class Turned>
  [[nodiscard]] Turned matrix_to_child(const Turned& A) const {
    const Turned in_placement = rotate_back(R, A);
    return general ? turned(transposed(Q), in_placement) : rotate_z(turn.inverse(), in_placement);
  }
};

/// The rotation by a ball joint's quaternion in the axes of its first step, which are those of the
/// joint, y z x. The placement is taken in, because it would be applied to every vector otherwise.
template <class Scalar>
JointTransform<Scalar> ball_transform(const TreeLink<Scalar>& link, std::span<const Scalar> q) {
  const auto at = static_cast<std::size_t>(link.q_index);
  const Matrix3<Scalar> turn = rotation_from_quaternion(q[at + 1], q[at + 2], q[at], q[at + 3]);
  const Matrix3<Scalar> columns = transposed(turn);
  JointTransform<Scalar> X;
  X.p = link.p;
  X.general = true;
  X.Q = transposed(Matrix3<Scalar>{rotate(link.R, columns.row_x), rotate(link.R, columns.row_y),
                                   rotate(link.R, columns.row_z)});
  return X;
}

template <class Scalar>
JointTransform<Scalar> joint_transform(const TreeLink<Scalar>& link, std::span<const Scalar> q,
                                       std::size_t index) {
  using std::cos;
  using std::sin;
  JointTransform<Scalar> X;
  X.R = link.R;
  X.p = link.p;
  const auto at = static_cast<std::size_t>(link.q_index);
  if (link.continues_joint()) return X;
  if (link.is_of_ball()) return ball_transform(link, q);
  if (link.is_floating()) {
    X.general = true;
    X.Q = rotation_from_quaternion(q[at + 3], q[at + 4], q[at + 5], q[at + 6]);
    X.p = X.p + rotate(X.R, Vector3<Scalar>{q[at], q[at + 1], q[at + 2]});
    return X;
  }
  X.q = q[at];
  if (link.spins) {
    X.R.b = {};
    return X;
  }
  const Scalar displacement = link.multiplier * q[at] + link.offset;
  if (link.turns_by_angle()) {
    const Scalar s = sin(displacement);
    const Scalar c = cos(displacement);
    label(s, "s", index);
    label(c, "c", index);
    X.turn = {c, s};
    // The last rotation of the placement is about the joint's own axis. If it is a quarter turn, it
    // is added to the joint's rotation at no cost.
    X.R.b = {};
    X.turn = {link.R.b.c * c - link.R.b.s * s, link.R.b.s * c + link.R.b.c * s};
  } else {
    X.p = X.p + rotate(X.R, Vector3<Scalar>{Scalar(0.0), Scalar(0.0), displacement});
  }
  return X;
}

template <class Scalar>
std::vector<JointTransform<Scalar>> joint_transforms(const Tree<Scalar>& tree,
                                                     std::span<const Scalar> q) {
  std::vector<JointTransform<Scalar>> transforms;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    transforms.push_back(joint_transform(tree.links[i], q, i));
  }
  return transforms;
}

}  // namespace treeline
