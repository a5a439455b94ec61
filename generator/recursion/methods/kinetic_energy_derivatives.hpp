#pragma once

#include <vector>

#include "recursion/methods/velocity_changes.hpp"

namespace treeline {

/// Derivatives of the kinetic energy with respect to displacements and velocities, nv each. The
/// second is M qd.
template <class Scalar>
struct EnergyDerivatives {
  std::vector<Scalar> dq, dqd;
};

/// By a displacement, the momentum beyond the joint times the change of velocity there; by a
/// velocity, this momentum along the axis, and that of the joint's rotor.
template <class Scalar>
EnergyDerivatives<Scalar> kinetic_energy_derivatives(const Tree<Scalar>& tree,
                                                     const std::vector<JointTransform<Scalar>>& X,
                                                     const JointRates<Scalar>& rates) {
  const MomentumParts<Scalar> parts = momentum_parts(tree, X, rates);
  const auto nv = static_cast<std::size_t>(tree.nv);
  EnergyDerivatives<Scalar> energy{std::vector<Scalar>(nv), std::vector<Scalar>(nv)};
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    section(tree.links[i], i, "energy");
    const auto& [P, L] = parts.momenta[i];
    for (const JointAxis<Scalar>& axis : joint_axes(tree.links[i])) {
      const auto [dv, dw] = velocity_change(axis, parts.carriers[i]);
      Scalar& dq = energy.dq[axis.column];
      Scalar& dqd = energy.dqd[axis.column];
      dq = dq + axis.multiplier * (dot(P, dv) + dot(L, dw));
      dqd = dqd + axis.multiplier * (dot(P, axis.slide) + dot(L, axis.turn));
    }
    const auto v = static_cast<std::size_t>(tree.links[i].v_index);
    energy.dqd[v] = energy.dqd[v] + tree.links[i].drive.inertia * rates.velocity(v);
  }
  return energy;
}

}  // namespace treeline
