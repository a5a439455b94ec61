#pragma once

#include <vector>

#include "recursion/methods/outward_motion.hpp"

namespace treeline {

/// Velocity of a link's origin and angular velocity, in its axes.
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
    if (link.is_floating()) {
      own.v = own.v + velocity_triple(rates, at);
      own.w = own.w + velocity_triple(rates, at + 3);
    } else {
      Scalar& along = along_axis(link.kind, own.v, own.w);
      along = along + link.multiplier * rates.velocity(at);
    }
    label(own.v, "v", i);
    label(own.w, "w", i);
    velocities.push_back(own);
  }
  return velocities;
}

}  // namespace treeline
