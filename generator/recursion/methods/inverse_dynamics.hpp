#pragma once

#include <span>
#include <vector>

#include "recursion/methods/outward_motion.hpp"

namespace treeline {

/// Force and moment about a link's origin, in the link's axes.
template <class Scalar>
struct Wrench {
  Vector3<Scalar> f, n;
};
template <class Scalar>
Wrench<Scalar> operator+(const Wrench<Scalar>& a, const Wrench<Scalar>& b) {
  return {a.f + b.f, a.n + b.n};
}
template <class Scalar>
Wrench<Scalar> operator-(const Wrench<Scalar>& a, const Wrench<Scalar>& b) {
  return {a.f - b.f, a.n - b.n};
}
/// Wrench about the origin of a force and a moment that act at p.
template <class Scalar>
Wrench<Scalar> wrench_at(const Vector3<Scalar>& f, const Vector3<Scalar>& n,
                         const Vector3<Scalar>& p) {
  return {f, n + cross(p, f)};
}

template <class Scalar>
Wrench<Scalar> to_parent(const JointTransform<Scalar>& X, const Wrench<Scalar>& wrench) {
  const Vector3<Scalar> f = X.to_parent(wrench.f);
  return {f, X.to_parent(wrench.n) + cross(X.p, f)};
}

/// u Sigma_a - v Sigma_b for the entries u = ww + wd and v = ww - wd of U, where J is the sum of
/// both moments. It has two forms of three operations each. If a moment is zero, the first form
/// takes one operation. If the moments are equal, the second one does and does not use u and v.
template <class Scalar>
Scalar moment_of_pair(const Scalar& u, const Scalar& v, const Scalar& ww, const Scalar& wd,
                      const Scalar& Sigma_a, const Scalar& Sigma_b, const Scalar& J) {
  const Scalar zero(0.0);
  if (Sigma_a == zero || Sigma_b == zero) {
    return u * Sigma_a - v * Sigma_b;
  }
  return ww * (Sigma_a - Sigma_b) + wd * J;
}

/// Rate of change of a link's momentum: f = m a + U h, n = vee(U Sigma) + h x a. With the second
/// moment in place of J, n uses entries of U that the outward pass computes anyway.
template <class Scalar>
Wrench<Scalar> inertial_wrench(const TreeInertia<Scalar>& inertia,
                               const LinkMotion<Scalar>& motion) {
  const AngularMatrix<Scalar>& U = motion.U;
  const Vector3<Scalar>& wd = motion.wd;
  const Symmetric3<Scalar>& Sigma = inertia.Sigma;
  const Symmetric3<Scalar>& J = inertia.J;
  const Vector3<Scalar> n{moment_of_pair(U.zy, U.yz, U.wywz, wd.x, Sigma.yy, Sigma.zz, J.xx) +
                              U.zx * Sigma.xy - U.yx * Sigma.xz + (U.wz2 - U.wy2) * Sigma.yz,
                          moment_of_pair(U.xz, U.zx, U.wxwz, wd.y, Sigma.zz, Sigma.xx, J.yy) +
                              U.xy * Sigma.yz - U.zy * Sigma.xy + (U.wx2 - U.wz2) * Sigma.xz,
                          moment_of_pair(U.yx, U.xy, U.wxwy, wd.z, Sigma.xx, Sigma.yy, J.zz) +
                              U.yz * Sigma.xz - U.xz * Sigma.yz + (U.wy2 - U.wx2) * Sigma.xy};
  return {motion.a * inertia.mass + U.matrix() * inertia.h, n + cross(inertia.h, motion.a)};
}

/// Adds tau = S^T f of a joint. Joints that share a coordinate add up.
template <class Scalar>
void add_joint_force(const TreeLink<Scalar>& link, const Wrench<Scalar>& wrench,
                     std::vector<Scalar>& tau) {
  const auto at = static_cast<std::size_t>(link.v_index);
  if (!link.is_floating()) {
    tau[at] = tau[at] + link.multiplier * along_axis(link.kind, wrench.f, wrench.n);
    return;
  }
  const Scalar parts[6] = {wrench.f.x, wrench.f.y, wrench.f.z, wrench.n.x, wrench.n.y, wrench.n.z};
  for (std::size_t k = 0; k < 6; ++k) {
    tau[at + k] = tau[at + k] + parts[k];
  }
}

/// Inward pass: turns the wrenches of all links, each including what acts on the link itself, into
/// nv joint forces.
template <class Scalar>
std::vector<Scalar> inward_forces(const Tree<Scalar>& tree,
                                  const std::vector<JointTransform<Scalar>>& X,
                                  std::vector<Wrench<Scalar>> wrenches) {
  std::vector<Scalar> tau(static_cast<std::size_t>(tree.nv), Scalar(0.0));
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "inward");
    label(wrenches[i].f, "f", i);
    label(wrenches[i].n, "n", i);
    add_joint_force(link, wrenches[i], tau);
    if (link.parent >= 0) {
      Wrench<Scalar>& parent = wrenches[static_cast<std::size_t>(link.parent)];
      parent = parent + to_parent(X[i], wrenches[i]);
    }
  }
  return tau;
}

template <class Scalar>
std::vector<Wrench<Scalar>> inertial_wrenches(const Tree<Scalar>& tree,
                                              const std::vector<LinkMotion<Scalar>>& motions) {
  std::vector<Wrench<Scalar>> wrenches;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    section(tree.links[i], i, "inertial wrench");
    wrenches.push_back(inertial_wrench(tree.links[i].inertia, motions[i]));
  }
  return wrenches;
}

/// tau = M qdd + b + g - J_ext^T f_ext by the recursive Newton-Euler algorithm (Chang table 4.1).
/// Friction is part of b, springs are part of g. `applied` are the external wrenches on each link;
/// empty: none.
template <class Scalar>
std::vector<Scalar> inverse_dynamics(const Tree<Scalar>& tree,
                                     const std::vector<JointTransform<Scalar>>& X,
                                     const JointRates<Scalar>& rates,
                                     const std::vector<Wrench<Scalar>>& applied) {
  const auto motions = outward_motion(tree, X, rates, -tree.gravity);
  std::vector<Wrench<Scalar>> wrenches = inertial_wrenches(tree, motions);
  for (std::size_t i = 0; i < applied.size(); ++i) {
    wrenches[i] = wrenches[i] - applied[i];
  }
  auto tau = inward_forces(tree, X, std::move(wrenches));
  add_drive_forces(tree, X, rates, tau);
  return tau;
}

}  // namespace treeline
