#pragma once

#include <span>
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

/// qdd of a floating joint whose parent has this acceleration, which becomes the link's.
template <class Scalar>
void accelerate_floating(const LdltFactor<Scalar>& IA, std::span<const Scalar> force,
                         std::span<Scalar> qdd, LinkAcceleration<Scalar>& acceleration) {
  const auto relative = solve(IA, std::vector<Scalar>(force.begin(), force.end()));
  const Scalar carried[6] = {acceleration.a.x,  acceleration.a.y,  acceleration.a.z,
                             acceleration.wd.x, acceleration.wd.y, acceleration.wd.z};
  for (std::size_t k = 0; k < 6; ++k) qdd[k] = relative[k] - carried[k];
  acceleration = {{relative[0], relative[1], relative[2]}, {relative[3], relative[4], relative[5]}};
}

template <class Scalar>
std::vector<Scalar> accelerate_outward(const Tree<Scalar>& tree,
                                       const std::vector<JointTransform<Scalar>>& X,
                                       const ArticulatedTree<Scalar>& bodies,
                                       const std::vector<Scalar>& force) {
  std::vector<Scalar> qdd(static_cast<std::size_t>(tree.nv));
  std::vector<LinkAcceleration<Scalar>> accelerations;
  const auto of = [&](int link) {
    return link < 0 ? LinkAcceleration<Scalar>{} : accelerations[static_cast<std::size_t>(link)];
  };
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "acceleration");
    const auto at = static_cast<std::size_t>(link.v_index);
    const JointCluster& shape = bodies.shapes[at];
    LinkAcceleration<Scalar> acceleration;
    if (link.parent >= 0) acceleration = to_child(X[i], of(link.parent));
    if (link.is_floating()) {
      accelerate_floating<Scalar>(bodies.floating[i], std::span(force).subspan(at, 6),
                                  std::span(qdd).subspan(at, 6), acceleration);
    } else if (!shape.is_shared()) {
      const JointProjection<Scalar>& joint = bodies.joints[i];
      qdd[at] = joint.inverse_D * force[at] - work(joint.u, acceleration);
      Scalar& own = along_axis(link.kind, acceleration.a, acceleration.wd);
      own = own + qdd[at];
    } else {
      const ClusterProjection<Scalar>& cluster = bodies.clusters[at];
      if (shape.begins_at(i)) {
        qdd[at] = cluster.inverse_D * force[at] - work(cluster.u, of(shape.anchor));
      }
      Scalar& own = along_axis(link.kind, acceleration.a, acceleration.wd);
      own = own + link.multiplier * qdd[at];
    }
    accelerations.push_back(acceleration);
  }
  return qdd;
}

/// Returns the part of a link's bias force `pA` that its joint passes on, for the joint force
/// `told`. `force` is reduced by the bias force along the joint's axis.
template <class Scalar>
Wrench<Scalar> pass_bias_force(const TreeLink<Scalar>& link, const JointProjection<Scalar>& joint,
                               const Wrench<Scalar>& pA, const Scalar& told, Scalar& force) {
  force = force - along_axis(link.kind, pA.f, pA.n);
  Wrench<Scalar> felt = pA + Wrench<Scalar>{joint.u.f * force, joint.u.n * force};
  // own + (1 - held) (force - own)
  along_axis(link.kind, felt.f, felt.n) = told - joint.held * force;
  return felt;
}

/// M^-1 times a vector of joint forces, by articulated bodies without bias (Chang table 4.2 with c
/// = 0, p = 0). Inward: force = force - S^T pA, pA_h += X (pA + U D^-1 force). Outward: qdd = D^-1
/// force - (U D^-1)^T X^T a_h. A cluster of joints passes pA on, and adds U D^-1 force to its
/// anchor.
template <class Scalar>
std::vector<Scalar> solve_articulated(const Tree<Scalar>& tree,
                                      const std::vector<JointTransform<Scalar>>& X,
                                      const ArticulatedTree<Scalar>& bodies,
                                      const std::vector<Scalar>& forces) {
  std::vector<Wrench<Scalar>> pA(tree.links.size());
  std::vector<Scalar> force = forces;
  const auto add = [&pA](int link, const Wrench<Scalar>& wrench) {
    auto& sum = pA[static_cast<std::size_t>(link)];
    sum = sum + wrench;
  };
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "bias force");
    const auto at = static_cast<std::size_t>(link.v_index);
    const JointCluster& shape = bodies.shapes[at];
    Wrench<Scalar> felt = pA[i];
    if (link.is_floating()) {
      felt = {{force[at], force[at + 1], force[at + 2]},
              {force[at + 3], force[at + 4], force[at + 5]}};
    } else if (!shape.is_shared()) {
      felt = pass_bias_force(link, bodies.joints[i], pA[i], forces[at], force[at]);
    } else {
      force[at] = force[at] - link.multiplier * along_axis(link.kind, felt.f, felt.n);
    }
    if (link.parent >= 0) add(link.parent, to_parent(X[i], felt));
    if (shape.begins_at(i) && shape.anchor >= 0) {
      const Wrench<Scalar>& u = bodies.clusters[at].u;
      add(shape.anchor, {u.f * force[at], u.n * force[at]});
    }
    if (link.is_floating()) {
      const Wrench<Scalar>& p = pA[i];
      const Scalar parts[6] = {p.f.x, p.f.y, p.f.z, p.n.x, p.n.y, p.n.z};
      for (std::size_t k = 0; k < 6; ++k) force[at + k] = force[at + k] - parts[k];
    }
  }
  return accelerate_outward(tree, X, bodies, force);
}

}  // namespace treeline
