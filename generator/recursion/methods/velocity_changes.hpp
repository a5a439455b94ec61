#pragma once

#include <utility>
#include <vector>

#include "recursion/methods/inverse_dynamics.hpp"
#include "recursion/methods/link_velocities.hpp"
#include "recursion/tree/joint_axes.hpp"

namespace treeline {

/// Momentum of a link over its angular momentum about the link's origin, in its axes.
template <class Scalar>
Wrench<Scalar> momentum_of(const TreeInertia<Scalar>& inertia, const LinkVelocity<Scalar>& at) {
  return {at.v * inertia.mass + cross(at.w, inertia.h), inertia.J * at.w + cross(inertia.h, at.v)};
}

/// Velocities, and what derivatives of quantities of momentum need of every link.
template <class Scalar>
struct MomentumParts {
  /// Momentum of everything beyond the joint, about the link's origin and in its axes.
  std::vector<Wrench<Scalar>> momenta;
  /// Velocity of the link that carries the joint, at the link's origin and in its axes.
  std::vector<LinkVelocity<Scalar>> carriers;
};

template <class Scalar>
MomentumParts<Scalar> momentum_parts(const Tree<Scalar>& tree,
                                     const std::vector<JointTransform<Scalar>>& X,
                                     const JointRates<Scalar>& rates) {
  const auto velocities = link_velocities(tree, X, rates);
  MomentumParts<Scalar> parts;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "momentum");
    parts.momenta.push_back(momentum_of(link.inertia, velocities[i]));
    LinkVelocity<Scalar> carrier;
    if (link.parent >= 0) {
      const auto h = static_cast<std::size_t>(link.parent);
      carrier = link.continues_joint() ? parts.carriers[h] : velocities[h];
    }
    parts.carriers.push_back(
        {X[i].to_child(carrier.v + cross(carrier.w, X[i].p)), X[i].to_child(carrier.w)});
  }
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    if (tree.links[i].parent < 0) continue;
    Wrench<Scalar>& parent = parts.momenta[static_cast<std::size_t>(tree.links[i].parent)];
    parent = parent + to_parent(X[i], parts.momenta[i]);
  }
  return parts;
}

/// Change of the velocity of everything beyond a joint by a unit displacement along the axis, for
/// an observer who moves with it: it sees the motion of the carrier from another side or place.
template <class Scalar>
LinkVelocity<Scalar> velocity_change(const JointAxis<Scalar>& axis,
                                     const LinkVelocity<Scalar>& carrier) {
  if (axis.turns) return {cross(carrier.v, axis.turn), cross(carrier.w, axis.turn)};
  return {cross(carrier.w, axis.slide), {}};
}

}  // namespace treeline
