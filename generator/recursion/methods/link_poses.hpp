#pragma once

#include <vector>

#include "recursion/methods/forward_kinematics.hpp"

namespace treeline {

/// Poses of all links seen from link `from`: x_from = R x_link + p. -1 means the world. The
/// recursion goes inward to the root first, then outward to all other branches. A row of R_from_h
/// is R_h_i times the row of R_from_i.
template <class Scalar>
std::vector<WorldPose<Scalar>> poses_seen_from(const Tree<Scalar>& tree,
                                               const std::vector<JointTransform<Scalar>>& X,
                                               int from) {
  if (from < 0) {
    return world_poses(tree, X);
  }
  std::vector<WorldPose<Scalar>> poses(tree.links.size());
  std::vector<bool> seen(tree.links.size());
  WorldPose<Scalar> world{identity3<Scalar>(), {}, {}};
  for (int at = from; at >= 0;) {
    const auto i = static_cast<std::size_t>(at);
    section(tree.links[i], i, "pose");
    poses[i] = world;
    seen[i] = true;
    world.R = {X[i].to_parent(world.R.row_x), X[i].to_parent(world.R.row_y),
               X[i].to_parent(world.R.row_z)};
    poses[i].step = world.R * X[i].p;
    world.p = world.p - poses[i].step;
    at = tree.links[i].parent;
  }
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    if (seen[i]) {
      continue;
    }
    section(tree.links[i], i, "pose");
    const int h = tree.links[i].parent;
    const WorldPose<Scalar>& parent = h < 0 ? world : poses[static_cast<std::size_t>(h)];
    poses[i].R = {X[i].to_child(parent.R.row_x), X[i].to_child(parent.R.row_y),
                  X[i].to_child(parent.R.row_z)};
    poses[i].step = parent.R * X[i].p;
    poses[i].p = parent.p + poses[i].step;
  }
  return poses;
}

}  // namespace treeline
