#pragma once

#include <vector>

#include "recursion/methods/articulated_inertia.hpp"
#include "recursion/methods/factor_mass_matrix.hpp"
#include "recursion/methods/mass_matrix.hpp"

namespace treeline {

/// Acceleration of a link in its axes, linear over angular.
template <class Scalar>
struct LinkAcceleration {
  Vector3<Scalar> a, wd;
};

/// Transforms a parent's acceleration to a link. It has no velocity terms here, see
/// `solve_articulated`.
template <class Scalar>
LinkAcceleration<Scalar> to_child(const JointTransform<Scalar>& X,
                                  const LinkAcceleration<Scalar>& parent) {
  return {X.to_child(parent.a + cross(parent.wd, X.p)), X.to_child(parent.wd)};
}

template <class Scalar>
Scalar work(const Wrench<Scalar>& wrench, const LinkAcceleration<Scalar>& acceleration) {
  return dot(wrench.f, acceleration.a) + dot(wrench.n, acceleration.wd);
}

template <class Scalar>
std::vector<Scalar> accelerate_outward(const Tree<Scalar>& tree,
                                       const std::vector<JointTransform<Scalar>>& X,
                                       const ArticulatedTree<Scalar>& bodies,
                                       const std::vector<Scalar>& force) {
  std::vector<Scalar> qdd(static_cast<std::size_t>(tree.nv));
  std::vector<LinkAcceleration<Scalar>> accelerations;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "acceleration");
    const auto at = static_cast<std::size_t>(link.v_index);
    LinkAcceleration<Scalar> acceleration;
    if (link.parent >= 0) {
      acceleration = to_child(X[i], accelerations[static_cast<std::size_t>(link.parent)]);
    }
    if (link.is_floating()) {
      const auto relative = solve(
          bodies.floating[i],
          std::vector<Scalar>(force.begin() + link.v_index, force.begin() + link.v_index + 6));
      const Scalar carried[6] = {acceleration.a.x,  acceleration.a.y,  acceleration.a.z,
                                 acceleration.wd.x, acceleration.wd.y, acceleration.wd.z};
      for (std::size_t k = 0; k < 6; ++k) {
        qdd[at + k] = relative[k] - carried[k];
      }
      acceleration = {{relative[0], relative[1], relative[2]},
                      {relative[3], relative[4], relative[5]}};
    } else {
      const JointProjection<Scalar>& joint = bodies.joints[i];
      qdd[at] = joint.inverse_D * force[at] - work(joint.u, acceleration);
      Scalar& own = along_axis(link.kind, acceleration.a, acceleration.wd);
      own = own + qdd[at];
    }
    accelerations.push_back(acceleration);
  }
  return qdd;
}

/// M^-1 times a vector of joint forces, by articulated bodies without bias (Chang table 4.2 with c
/// = 0, p = 0). Inward: force = force - S^T pA, pA_h += X (pA + U D^-1 force). Outward: qdd = D^-1
/// force - (U D^-1)^T X^T a_h.
template <class Scalar>
std::vector<Scalar> solve_articulated(const Tree<Scalar>& tree,
                                      const std::vector<JointTransform<Scalar>>& X,
                                      const ArticulatedTree<Scalar>& bodies,
                                      const std::vector<Scalar>& forces) {
  const std::size_t n = tree.links.size();
  std::vector<Wrench<Scalar>> pA(n);
  std::vector<Scalar> force = forces;
  for (std::size_t i = n; i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "bias force");
    const auto at = static_cast<std::size_t>(link.v_index);
    Wrench<Scalar> felt;
    if (link.is_floating()) {
      felt = {{force[at], force[at + 1], force[at + 2]},
              {force[at + 3], force[at + 4], force[at + 5]}};
    } else {
      Scalar& own = along_axis(link.kind, pA[i].f, pA[i].n);
      force[at] = force[at] - own;
      const JointProjection<Scalar>& joint = bodies.joints[i];
      felt = pA[i] + Wrench<Scalar>{joint.u.f * force[at], joint.u.n * force[at]};
      // own + (1 - held) (force - own)
      along_axis(link.kind, felt.f, felt.n) = forces[at] - joint.held * force[at];
    }
    if (link.parent >= 0) {
      auto& parent = pA[static_cast<std::size_t>(link.parent)];
      parent = parent + to_parent(X[i], felt);
    }
    if (link.is_floating()) {
      const Wrench<Scalar>& p = pA[i];
      const Scalar parts[6] = {p.f.x, p.f.y, p.f.z, p.n.x, p.n.y, p.n.z};
      for (std::size_t k = 0; k < 6; ++k) {
        force[at + k] = force[at + k] - parts[k];
      }
    }
  }
  return accelerate_outward(tree, X, bodies, force);
}

}  // namespace treeline
