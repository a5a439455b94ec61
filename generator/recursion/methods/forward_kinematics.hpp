#pragma once

#include <vector>

#include "recursion/tree/joint_transform.hpp"

namespace treeline {

/// Pose of a link's frame in the world: x_world = R x_link + p.
template <class Scalar>
struct WorldPose {
  Matrix3<Scalar> R;
  Vector3<Scalar> p;
  Vector3<Scalar> step;  ///< from the parent's origin to this one, world axes
};

/// Poses of all links in the world, by an outward recursion. A row of R_world_child is
/// R_parent_child^T times the parent's row.
template <class Scalar>
std::vector<WorldPose<Scalar>> world_poses(const Tree<Scalar>& tree,
                                           const std::vector<JointTransform<Scalar>>& X) {
  std::vector<WorldPose<Scalar>> poses;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "pose");
    const WorldPose<Scalar> parent = link.parent < 0
                                         ? WorldPose<Scalar>{identity3<Scalar>(), {}, {}}
                                         : poses[static_cast<std::size_t>(link.parent)];
    WorldPose<Scalar> pose;
    pose.R = {X[i].to_child(parent.R.row_x), X[i].to_child(parent.R.row_y),
              X[i].to_child(parent.R.row_z)};
    pose.step = parent.R * X[i].p;
    pose.p = parent.p + pose.step;
    label(pose.p, "p", i);
    poses.push_back(pose);
  }
  return poses;
}

/// Matrix product A B.
template <class Scalar>
Matrix3<Scalar> operator*(const Matrix3<Scalar>& A, const Matrix3<Scalar>& B) {
  return {transposed_times(B, A.row_x), transposed_times(B, A.row_y), transposed_times(B, A.row_z)};
}

/// Pose of a point's frame in the world. It is constant for points of the world itself.
template <class Scalar>
WorldPose<Scalar> point_pose(const std::vector<WorldPose<Scalar>>& poses,
                             const TreePoint<Scalar>& point) {
  if (point.link < 0) {
    return {point.R, point.p, {}};
  }
  const WorldPose<Scalar>& link = poses[static_cast<std::size_t>(point.link)];
  const Vector3<Scalar> arm = link.R * point.p;
  return {link.R * point.R, link.p + arm, arm};
}

}  // namespace treeline
