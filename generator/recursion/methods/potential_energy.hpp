#pragma once

#include <vector>

#include "recursion/tree/joint_transform.hpp"

namespace treeline {

/// -sum of m g.c over all links, J, zero where all mass is at the world's origin: the first moments
/// carried inward, and gravity along that of the whole robot, and that of springs. As with the
/// centre of mass, regrouped inertias give what those of the file do.
template <class Scalar>
Scalar potential_energy(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X) {
  std::vector<Scalar> masses;
  std::vector<Vector3<Scalar>> moments;
  for (const TreeLink<Scalar>& link : tree.links) {
    masses.push_back(link.inertia.mass);
    moments.push_back(link.inertia.h);
  }
  Vector3<Scalar> whole = tree.world_moment;
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "first moment");
    const Vector3<Scalar> moved = X[i].to_parent(moments[i]) + X[i].p * masses[i];
    if (link.parent < 0) {
      whole = whole + moved;
      continue;
    }
    const auto parent = static_cast<std::size_t>(link.parent);
    masses[parent] = masses[parent] + masses[i];
    moments[parent] = moments[parent] + moved;
  }
  Scalar energy = -dot(tree.gravity, whole);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeDrive<Scalar>& drive = tree.links[i].drive;
    if (drive.stiffness == Scalar(0.0)) continue;
    const Scalar stretch = X[i].q - drive.rest;
    energy = energy + Scalar(0.5) * drive.stiffness * stretch * stretch;
  }
  return energy;
}

}  // namespace treeline
