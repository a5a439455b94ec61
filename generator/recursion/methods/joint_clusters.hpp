#pragma once

#include <optional>
#include <vector>

#include "recursion/tree/tree.hpp"

namespace treeline {

/// Joints that move together because followers share the coordinate of their leader. All links
/// between them and the anchor belong to the cluster, so that seen from the anchor it is one joint.
struct JointCluster {
  int first = -1;   ///< lowest index of its links
  int anchor = -1;  ///< the link that carries the cluster; -1: the world
  int joints = 0;   ///< 1: an ordinary joint

  [[nodiscard]] bool is_shared() const { return joints > 1; }
  /// Whether several joints share the coordinate and this link is the first of theirs: outward
  /// recursions begin the cluster there, inward ones end it.
  [[nodiscard]] bool begins_at(std::size_t link) const {
    return is_shared() && static_cast<int>(link) == first;
  }
};

/// Clusters by the index of their velocity. Nothing where another joint lies between joints that
/// share a coordinate: such a robot has no tree of clusters with one freedom each.
template <class Scalar>
std::optional<std::vector<JointCluster>> find_clusters(const Tree<Scalar>& tree) {
  std::vector<JointCluster> clusters(static_cast<std::size_t>(tree.nv));
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    JointCluster& cluster = clusters[static_cast<std::size_t>(link.v_index)];
    const bool is_inside =
        link.parent >= 0 && cluster.joints > 0 &&
        tree.links[static_cast<std::size_t>(link.parent)].v_index == link.v_index;
    if (cluster.joints++ == 0) {
      cluster.first = static_cast<int>(i);
      cluster.anchor = link.parent;
    } else if (!is_inside && link.parent != cluster.anchor) {
      return std::nullopt;
    }
  }
  return clusters;
}

}  // namespace treeline
