#pragma once

#include <span>
#include <vector>

#include "recursion/methods/composite_momentum.hpp"
#include "recursion/methods/control_torque.hpp"

namespace treeline {

/// External forces that keep their direction in the world while links rotate, on everything beyond
/// a joint: their sum, the sum of their free moments, and K = sum of f r^T about the link's origin.
template <class Scalar>
struct SteadyForces {
  Vector3<Scalar> f, n;
  Matrix3<Scalar> K;
};

/// Sums up the external forces with world axes, inward.
template <class Scalar>
std::vector<SteadyForces<Scalar>> steady_forces(const Tree<Scalar>& tree,
                                                const std::vector<JointTransform<Scalar>>& X,
                                                std::span<const Scalar> f_ext) {
  std::vector<SteadyForces<Scalar>> steady(tree.links.size());
  if (f_ext.empty()) {
    return steady;
  }
  for (std::size_t k = 0; k < tree.external_forces.size(); ++k) {
    const TreePoint<Scalar>& point = tree.external_forces[k];
    if (point.link < 0 || point.axes != Axes::world) {
      continue;
    }
    const Scalar* at = &f_ext[6 * k];
    const auto f = to_link_axes(tree, X, point, Vector3<Scalar>{at[0], at[1], at[2]});
    const auto n = to_link_axes(tree, X, point, Vector3<Scalar>{at[3], at[4], at[5]});
    SteadyForces<Scalar>& sum = steady[static_cast<std::size_t>(point.link)];
    sum = {sum.f + f, sum.n + n, sum.K + outer(f, point.p)};
  }
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    section(tree.links[i], i, "steady forces");
    if (tree.links[i].parent < 0) {
      continue;
    }
    SteadyForces<Scalar>& parent = steady[static_cast<std::size_t>(tree.links[i].parent)];
    const Vector3<Scalar> f = X[i].to_parent(steady[i].f);
    parent = {parent.f + f, parent.n + X[i].to_parent(steady[i].n),
              parent.K + X[i].matrix_to_parent(steady[i].K) + outer(f, X[i].p)};
  }
  return steady;
}

}  // namespace treeline
