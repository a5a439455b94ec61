#include <cstddef>

#include "recursion/routes/make_link_table.hpp"

namespace treeline {
namespace {

/// From the axes y z x to x y z: makes the next axis the z axis.
Digits50Matrix3 next_axis() {
  Digits50Matrix3 turn;
  turn << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return turn;
}

/// Appends the six links of a floating joint, whose parent is already one of the split tree.
void append_free_joint(const TreeLink<double>& whole, const Digits50Matrix3& placement,
                       SplitTree& split) {
  const char* const suffixes[6] = {"_x", "_y", "_z", "_about_x", "_about_y", ""};
  for (int k = 0; k < 6; ++k) {
    TreeLink<double> link = k == 5 ? whole : TreeLink<double>{};
    link.kind = k < 3 ? JointKind::prismatic : JointKind::revolute;
    link.name = whole.name + suffixes[k];
    link.parent = k == 0 ? whole.parent : static_cast<int>(split.tree.links.size()) - 1;
    link.q_index = whole.q_index + k;
    link.v_index = whole.v_index + k;
    link.multiplier = 1;
    link.R =
        planar_factors<double>(k == 0 ? Digits50Matrix3(placement * next_axis()) : next_axis());
    link.p = k == 0 ? whole.p : Vector3<double>{};
    split.tree.links.push_back(link);
    split.axes.push_back(k + 1);
  }
}

}  // namespace

SplitTree split_free_joints(const Mechanism& mechanism) {
  const auto whole = constant_tree<double>(mechanism);
  SplitTree split{whole, {}, {}};
  split.tree.links.clear();
  const auto place_of = [&](int link) {
    return link < 0 ? link : split.places[static_cast<std::size_t>(link)];
  };
  for (std::size_t i = 0; i < whole.links.size(); ++i) {
    TreeLink<double> link = whole.links[i];
    link.parent = place_of(link.parent);
    if (link.is_floating() && i > 0) {
      append_free_joint(link, mechanism.links[i].placement.R, split);
    } else {
      split.tree.links.push_back(link);
      split.axes.push_back(static_cast<int>(link.ball));
    }
    split.places.push_back(static_cast<int>(split.tree.links.size()) - 1);
  }
  for (auto* const points : {&split.tree.operational_points, &split.tree.external_forces}) {
    for (TreePoint<double>& point : *points) point.link = place_of(point.link);
  }
  return split;
}

}  // namespace treeline
