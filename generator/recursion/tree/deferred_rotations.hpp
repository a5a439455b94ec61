#pragma once

#include <cstddef>
#include <vector>

#include "recursion/tree/joint_transform.hpp"

namespace treeline {

/// R1 R2, rotations about the same axis.
template <class Scalar>
PlanarRotation<Scalar> operator*(const PlanarRotation<Scalar>& r1,
                                 const PlanarRotation<Scalar>& r2) {
  return {r1.c * r2.c - r1.s * r2.s, r1.s * r2.c + r1.c * r2.s};
}

/// Writes the rotation of a joint whose axis is parallel to its parent's as Rx(0 or pi) followed by
/// one rotation about z: Rz(a) Rx(pi) = Rx(pi) Rz(-a).
template <class Scalar>
void join_rotations(JointTransform<Scalar>& X) {
  const bool flipped = !(X.R.alpha.c == Scalar(1.0));
  X.turn = (flipped ? X.R.a.inverse() : X.R.a) * X.R.b * X.turn;
  X.R.a = X.R.b = {};
}

template <class Scalar>
bool is_parallel(const JointTransform<Scalar>& X) {
  const PlanarRotation<Scalar>& alpha = X.R.alpha;
  return !X.general && alpha.s == Scalar(0.0) &&
         (alpha.c == Scalar(1.0) || alpha.c == Scalar(-1.0));
}

/// Turns an inertia to the axes before the rotation: Rz I Rz^T. J_zz stays constant.
template <class Scalar>
void turn_inertia(const PlanarRotation<Scalar>& turn, TreeInertia<Scalar>& inertia) {
  Symmetric3<Scalar>& Sigma = inertia.Sigma;
  inertia.h = rotate_z(turn, inertia.h);
  Sigma = rotate_z(turn, Sigma);
  inertia.J = {Sigma.yy + Sigma.zz, -Sigma.xy, -Sigma.xz,
               Sigma.xx + Sigma.zz, -Sigma.yz, inertia.J.zz};
}

template <class Scalar>
void turn_point(const PlanarRotation<Scalar>& turn, int link, TreePoint<Scalar>& point) {
  if (point.link != link) return;
  point.p = rotate_z(turn, point.p);
  const Matrix3<Scalar> columns = transposed(point.R);
  point.R = transposed<Scalar>({rotate_z(turn, columns.row_x), rotate_z(turn, columns.row_y),
                                rotate_z(turn, columns.row_z)});
}

template <class Scalar>
void turn_points(const PlanarRotation<Scalar>& turn, int link, Tree<Scalar>& tree) {
  for (auto* points : {&tree.operational_points, &tree.external_forces, &tree.contacts,
                       &tree.link_frames, &tree.payload_frames}) {
    for (TreePoint<Scalar>& point : *points) turn_point(turn, link, point);
  }
  for (TreeLoop<Scalar>& loop : tree.loops) {
    turn_point(turn, link, loop.first);
    turn_point(turn, link, loop.second);
  }
}

/// Defers joint rotations: links marked `defers_rotation` are treated in axes before their joint's
/// rotation. So constants are rotated (inertia, places of children and points) instead of motions,
/// forces and the inertia of everything beyond. Joints with parallel axes are then rotated
/// together, once, by the sum of their angles. Near a fixed base, motions keep the zeros that they
/// have in the axes of the joint before. Sines of sums follow from the addition theorems, because a
/// sum of large angles would be rounded. The recursions stay the same, since any axes will do at an
/// instant.
template <class Scalar>
void defer_rotations(Tree<Scalar>& tree, std::vector<JointTransform<Scalar>>& X) {
  std::vector<PlanarRotation<Scalar>> deferred(tree.links.size());
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    TreeLink<Scalar>& link = tree.links[i];
    const bool behind_late =
        link.parent >= 0 && tree.links[static_cast<std::size_t>(link.parent)].defers_rotation;
    if (behind_late) {
      const PlanarRotation<Scalar>& turn = deferred[static_cast<std::size_t>(link.parent)];
      X[i].p = rotate_z(turn, X[i].p);
      X[i].R.a = turn * X[i].R.a;
    }
    if (is_parallel(X[i]) && (behind_late || link.defers_rotation)) {
      join_rotations(X[i]);
    }
    if (link.defers_rotation && link.has_one_coordinate()) {
      deferred[i] = X[i].R.b * X[i].turn;
      X[i].R.b = X[i].turn = {};
      turn_inertia(deferred[i], link.inertia);
      turn_points(deferred[i], static_cast<int>(i), tree);
      for (TreeMatter<Scalar>& matter : tree.link_matter) {
        if (matter.link == static_cast<int>(i)) matter.h = rotate_z(deferred[i], matter.h);
      }
    }
  }
}

}  // namespace treeline
