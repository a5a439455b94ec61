#pragma once

#include <span>
#include <vector>

#include "recursion/methods/link_velocities.hpp"

namespace treeline {

/// qd^T M qd / 2, J, outward: of each link m v.v + 2 v.(w x h) + w.(J w), with the velocity v of
/// its origin and its angular velocity w. Regrouped inertias of single links have no energies of
/// their own, but their sum is that of the robot, as M is.
template <class Scalar>
Scalar kinetic_energy(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                      std::span<const Scalar> qd) {
  const auto velocities = link_velocities(tree, X, {qd, {}});
  Scalar twice(0.0);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "energy");
    const TreeInertia<Scalar>& inertia = link.inertia;
    const Vector3<Scalar>& v = velocities[i].v;
    const Vector3<Scalar>& w = velocities[i].w;
    const Vector3<Scalar> momentum = v * inertia.mass + cross(w, inertia.h * Scalar(2.0));
    twice = twice + (dot(v, momentum) + dot(w, inertia.J * w));
    const Scalar& rate = qd[static_cast<std::size_t>(link.v_index)];
    twice = twice + link.drive.inertia * rate * rate;
  }
  return Scalar(0.5) * twice;
}

}  // namespace treeline
