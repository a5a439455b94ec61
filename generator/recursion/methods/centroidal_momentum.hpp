#pragma once

#include <span>
#include <vector>

#include "recursion/methods/center_of_mass.hpp"
#include "recursion/methods/link_velocities.hpp"
#include "recursion/methods/mass_matrix.hpp"

// Momentum of the whole robot about its centre of mass (Orin & Goswami 2008), world axes, linear
// over angular. Regrouping leaves it as it is: it moves only matter that has the same momentum on
// either link. The rotors of motors are no links: M has their inertia, the momentum has not.

namespace treeline {

template <class Scalar>
bool is_massless(const TreeInertia<Scalar>& inertia) {
  const Scalar zero(0.0);
  const auto& [mass, h, Sigma, J] = inertia;
  for (const Scalar& entry : {mass, h.x, h.y, h.z, J.xx, J.xy, J.xz, J.yy, J.yz, J.zz}) {
    if (!(entry == zero)) return false;
  }
  return true;
}

/// The link from which the centre of mass is seen: the first that has matter, if it carries all
/// others; -1: the world. So no digits are lost where a floating or sliding base is far from the
/// world's origin.
template <class Scalar>
int link_with_all_matter(const Tree<Scalar>& tree) {
  int all = -1;
  if (tree.has_world_matter) return all;
  while (true) {
    int next = -1;
    for (std::size_t i = 0; i < tree.links.size(); ++i) {
      if (tree.links[i].parent != all) continue;
      if (next >= 0) return all;
      next = static_cast<int>(i);
    }
    if (next < 0) return all;
    all = next;
    if (!is_massless(tree.links[static_cast<std::size_t>(all)].inertia)) return all;
  }
}

/// The centre of mass from the origin of link `from`, which carries all matter, in its axes; from
/// the world's for -1. `composites` have the first moments `h` of everything beyond each joint,
/// times `scale`.
template <class Scalar, class Composite>
Vector3<Scalar> center_seen_from(const Tree<Scalar>& tree,
                                 const std::vector<JointTransform<Scalar>>& X,
                                 const std::vector<Composite>& composites, int from,
                                 const Scalar& scale) {
  if (from >= 0) return composites[static_cast<std::size_t>(from)].h * scale;
  Vector3<Scalar> center = tree.world_moment * tree.inverse_total_mass;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    if (tree.links[i].parent < 0) center = center + to_parent(X[i], composites[i]).h * scale;
  }
  return center;
}

/// The centre of mass from the origin of each link, in its axes, where link `from` has it at
/// `center`: inward to the root, then outward. Rotors are left out.
template <class Scalar>
std::vector<Vector3<Scalar>> centers_seen_from_links(const Tree<Scalar>& tree,
                                                     const std::vector<JointTransform<Scalar>>& X,
                                                     int from, const Vector3<Scalar>& center) {
  std::vector<Vector3<Scalar>> centers(tree.links.size());
  std::vector<bool> seen(tree.links.size());
  Vector3<Scalar> world = center;
  for (int at = from; at >= 0;) {
    const auto i = static_cast<std::size_t>(at);
    centers[i] = world;
    seen[i] = true;
    world = X[i].to_parent(world) + X[i].p;
    at = tree.links[i].parent;
  }
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    if (seen[i]) continue;
    section(link, i, "centre of mass");
    const Vector3<Scalar>& parent =
        link.parent < 0 ? world : centers[static_cast<std::size_t>(link.parent)];
    centers[i] = X[i].to_child(parent - X[i].p);
  }
  return centers;
}

/// The links that carry all matter: `from` and those before it.
template <class Scalar>
std::vector<bool> carriers_of_all(const Tree<Scalar>& tree, int from) {
  std::vector<bool> carries(tree.links.size());
  for (int i = from; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
    carries[static_cast<std::size_t>(i)] = true;
  }
  return carries;
}

/// A_G, 6 x nv, with h_G = A_G qd. A unit of a velocity gives everything beyond its joint the
/// momentum of its composite inertia, of which the moment is taken about the centre of mass in the
/// link's axes. Nothing is carried inward but inertias.
template <class Scalar>
DenseMatrix<Scalar> centroidal_momentum_matrix(const Tree<Scalar>& tree,
                                               const std::vector<JointTransform<Scalar>>& X) {
  const int from = link_with_all_matter(tree);
  const auto composites = composite_inertias(tree, X);
  const auto centers = centers_seen_from_links(
      tree, X, from, center_seen_from(tree, X, composites, from, tree.inverse_total_mass));
  const auto carries_all = carriers_of_all(tree, from);
  const auto poses = world_poses(tree, X);
  DenseMatrix<Scalar> A(6, static_cast<std::size_t>(tree.nv));
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "momentum");
    for (int k = 0; k < link.velocities(); ++k) {
      const Wrench<Scalar> own = unit_acceleration_wrench(link, composites[i], k);
      // To move all matter without turning it has no moment about its centre.
      const bool shifts_all = carries_all[i] && !link.is_angular(k);
      const Vector3<Scalar> f = poses[i].R * (own.f * link.multiplier);
      const Vector3<Scalar> n =
          shifts_all ? Vector3<Scalar>{}
                     : poses[i].R * ((own.n - cross(centers[i], own.f)) * link.multiplier);
      const auto column = static_cast<std::size_t>(link.v_index + k);
      const Scalar entries[6] = {f.x, f.y, f.z, n.x, n.y, n.z};
      for (std::size_t row = 0; row < 6; ++row) A(row, column) = A(row, column) + entries[row];
    }
  }
  return A;
}

/// Sum of the links' wrenches about the centre of mass, world axes.
template <class Scalar>
Wrench<Scalar> sum_about_center(const Tree<Scalar>& tree,
                                const std::vector<JointTransform<Scalar>>& X,
                                std::vector<Wrench<Scalar>> wrenches) {
  const int from = link_with_all_matter(tree);
  const auto shares = composite_shares(tree, X);
  const Vector3<Scalar> center = center_seen_from(tree, X, shares, from, Scalar(1.0));
  Wrench<Scalar> sum;
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    if (static_cast<int>(i) == from) continue;
    section(link, i, "inward");
    Wrench<Scalar>& parent =
        link.parent < 0 ? sum : wrenches[static_cast<std::size_t>(link.parent)];
    parent = parent + to_parent(X[i], wrenches[i]);
  }
  if (from >= 0) sum = wrenches[static_cast<std::size_t>(from)];  // those before have no matter
  sum.n = sum.n - cross(center, sum.f);
  for (int i = from; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
    const auto at = static_cast<std::size_t>(i);
    sum = {X[at].to_parent(sum.f), X[at].to_parent(sum.n)};
  }
  return sum;
}

/// h_G, 6: the momenta of all links at their origins, summed inward.
template <class Scalar>
Wrench<Scalar> centroidal_momentum(const Tree<Scalar>& tree,
                                   const std::vector<JointTransform<Scalar>>& X,
                                   std::span<const Scalar> qd) {
  const auto velocities = link_velocities(tree, X, {qd, {}});
  std::vector<Wrench<Scalar>> momenta;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    section(tree.links[i], i, "momentum");
    const TreeInertia<Scalar>& inertia = tree.links[i].inertia;
    const auto& [v, w] = velocities[i];
    momenta.push_back(
        {v * inertia.mass + cross(w, inertia.h), inertia.J * w + cross(inertia.h, v)});
  }
  return sum_about_center(tree, X, std::move(momenta));
}

/// dA_G/dt qd, 6: the rate of change of h_G at qdd = 0, from the links' accelerations there.
template <class Scalar>
Wrench<Scalar> centroidal_bias(const Tree<Scalar>& tree,
                               const std::vector<JointTransform<Scalar>>& X,
                               std::span<const Scalar> qd) {
  const auto motions = outward_motion(tree, X, {qd, {}}, Vector3<Scalar>{});
  return sum_about_center(tree, X, inertial_wrenches(tree, motions));
}

/// dJ_com/dt qd, m/s^2, world axes.
template <class Scalar>
Vector3<Scalar> center_of_mass_bias_acceleration(const Tree<Scalar>& tree,
                                                 const std::vector<JointTransform<Scalar>>& X,
                                                 std::span<const Scalar> qd) {
  return center_of_mass_acceleration(tree, X, outward_motion(tree, X, {qd, {}}, Vector3<Scalar>{}));
}

/// Mass, kg, and centre of mass in the world, m, of what a joint carries.
template <class Scalar>
struct SubtreeMatter {
  Scalar mass{};
  Vector3<Scalar> center;
};

/// Mass and centre of what each joint carries, for every link that moves against its parent, in the
/// order of the file's links. They come from the masses of the file: regrouping moves masses
/// between links. Where there is no mass the centre is the origin of the link.
template <class Scalar>
std::vector<SubtreeMatter<Scalar>> subtree_matter(const Tree<Scalar>& tree,
                                                  const std::vector<JointTransform<Scalar>>& X) {
  std::vector<TreeMatter<Scalar>> sums(tree.links.size());
  for (const TreeMatter<Scalar>& matter : tree.link_matter) {
    sums[static_cast<std::size_t>(matter.link)] = matter;
  }
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "first moment");
    if (link.parent < 0) continue;
    TreeMatter<Scalar>& parent = sums[static_cast<std::size_t>(link.parent)];
    parent.h = parent.h + X[i].to_parent(sums[i].h) + X[i].p * sums[i].mass;
    parent.mass = parent.mass + sums[i].mass;
  }
  const auto poses = world_poses(tree, X);
  std::vector<SubtreeMatter<Scalar>> result;
  for (const TreePoint<Scalar>& frame : tree.link_frames) {
    const auto i = static_cast<std::size_t>(frame.link);
    section(tree.links[i], i, "centre of what it carries");
    const Scalar& mass = sums[i].mass;
    const bool has_mass = !(mass == Scalar(0.0));
    const Vector3<Scalar> from = has_mass ? sums[i].h * (Scalar(1.0) / mass) : frame.p;
    result.push_back({mass, poses[i].p + poses[i].R * from});
  }
  return result;
}

}  // namespace treeline
