#pragma once

#include <span>
#include <vector>

#include "recursion/methods/composite_momentum.hpp"
#include "recursion/tree/joint_axes.hpp"

namespace treeline {

/// Wrenches per unit of one velocity, sent inward from everything beyond its joint. For a
/// particle dm that the velocity moves by e and that moves at v: sums of de/dt dm, e dm, v x e
/// dm.
template <class Scalar>
struct VelocityWrenches {
  Wrench<Scalar> rate;      ///< of de/dt: at constant velocities, what turns e
  Wrench<Scalar> momentum;  ///< of e
  Vector3<Scalar> crossed;  ///< of v x e, with v relative to the link's origin
};

/// Wrenches of degree of freedom `k`, at its link. A joint's axes turn with its link: their own
/// rate is w x e.
template <class Scalar>
VelocityWrenches<Scalar> own_wrenches(const TreeLink<Scalar>& link,
                                      const CompositeInertia<Scalar>& inertia,
                                      const CompositeMomentum<Scalar>& twice,
                                      const Vector3<Scalar>& w, int k) {
  const Scalar half(0.5);
  const UnitMotion<Scalar> e = unit_motion(link, k);
  const Vector3<Scalar> a = cross(w, e.v);
  const Vector3<Scalar> alpha = cross(w, e.w);
  const Vector3<Scalar> P = twice.P * half;
  const Wrench<Scalar> turned{a * inertia.mass + cross(alpha, inertia.h),
                              cross(inertia.h, a) + inertia.J * alpha};
  const Wrench<Scalar> carried{cross(e.w, P), turned_moment(twice.C, e.w) * half};
  return {turned + carried, unit_acceleration_wrench(link, inertia, k),
          cross(P, e.v) + turned_moment(transposed(twice.C), e.w) * half};
}

/// Moves these wrenches to the parent, in its axes; `velocity` is that of the link's origin
/// relative to the parent's.
template <class Scalar>
VelocityWrenches<Scalar> to_parent(const JointTransform<Scalar>& X,
                                   const VelocityWrenches<Scalar>& wrenches,
                                   const Vector3<Scalar>& velocity) {
  const Wrench<Scalar> momentum = to_parent(X, wrenches.momentum);
  return {to_parent(X, wrenches.rate), momentum,
          X.to_parent(wrenches.crossed) + cross(velocity, momentum.f)};
}

/// Adds the entries of velocity `column`, of a joint at or beyond `ancestor`, with those of
/// `ancestor`: e.(de'/dt) and, where it is another joint, (de/dt).e'.
template <class Scalar>
void add_coriolis_entries(const TreeLink<Scalar>& ancestor, const Vector3<Scalar>& w,
                          const VelocityWrenches<Scalar>& wrenches, std::size_t column,
                          const Scalar& multiplier, bool own, DenseMatrix<Scalar>& C) {
  const Vector3<Scalar> f = cross(wrenches.momentum.f, w);
  const Vector3<Scalar> n = wrenches.crossed + cross(wrenches.momentum.n, w);
  for (int k = 0; k < ancestor.velocities(); ++k) {
    const UnitMotion<Scalar> e = unit_motion(ancestor, k);
    const auto row = static_cast<std::size_t>(ancestor.v_index + k);
    const Scalar scale = multiplier * ancestor.multiplier;
    C(row, column) =
        C(row, column) + scale * (dot(e.v, wrenches.rate.f) + dot(e.w, wrenches.rate.n));
    if (!own) C(column, row) = C(column, row) + scale * (dot(e.v, f) + dot(e.w, n));
  }
}

/// Angular velocities of the axes of each link's joint, in these axes. They are fixed to the link,
/// or to the last link of a joint of several axes.
template <class Scalar>
std::vector<Vector3<Scalar>> angular_velocities_of_axes(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
    const std::vector<LinkMotion<Scalar>>& motions) {
  std::vector<Vector3<Scalar>> w;
  for (const LinkMotion<Scalar>& motion : motions) w.push_back(motion.w);
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    if (tree.links[i].continues_joint()) {
      w[static_cast<std::size_t>(tree.links[i].parent)] = X[i].to_parent(w[i]);
    }
  }
  return w;
}

/// C, nv x nv, with C qd = b and dM/dt = C + C^T: the sum over all particles of e_i.(de_j/dt) dm,
/// where a unit of velocity j moves the particle by e_j. Composite inertias and momenta of all that
/// is beyond a joint, times its axis, are carried inward (Echeandia & Wensing 2021). Coordinates
/// that several joints share collect the terms of all of them.
template <class Scalar>
DenseMatrix<Scalar> coriolis_matrix(const Tree<Scalar>& tree,
                                    const std::vector<JointTransform<Scalar>>& X,
                                    std::span<const Scalar> qd) {
  const Scalar zero(0.0);
  const Vector3<Scalar> none{zero, zero, zero};
  const JointRates<Scalar> rates{qd, {}};
  const auto motions = outward_motion(tree, X, rates, none);
  std::vector<Vector3<Scalar>> twice;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const int parent = tree.links[i].parent;
    twice.push_back(twice_relative_velocity(
        tree.links[i], X[i], parent < 0 ? none : motions[static_cast<std::size_t>(parent)].w,
        rates));
  }
  const auto inertias = composite_inertias(tree, X);
  const auto momenta = composite_momenta(tree, X, inertias, motions, twice);
  const auto w = angular_velocities_of_axes(tree, X, motions);
  const auto n = static_cast<std::size_t>(tree.nv);
  DenseMatrix<Scalar> C(n, n);
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "Coriolis matrix");
    for (int k = 0; k < link.velocities(); ++k) {
      const auto column = static_cast<std::size_t>(link.v_index + k);
      auto wrenches = own_wrenches(link, inertias[i], momenta[i], w[i], k);
      for (std::size_t j = i;;) {
        const TreeLink<Scalar>& ancestor = tree.links[j];
        add_coriolis_entries(ancestor, w[j], wrenches, column, link.multiplier, j == i, C);
        if (ancestor.parent < 0) break;
        wrenches = to_parent(X[j], wrenches, twice[j] * Scalar(0.5));
        j = static_cast<std::size_t>(ancestor.parent);
      }
    }
  }
  return C;
}

}  // namespace treeline
