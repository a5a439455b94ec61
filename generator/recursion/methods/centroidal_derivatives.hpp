#pragma once

#include <vector>

#include "recursion/methods/centroidal_momentum.hpp"
#include "recursion/methods/inverse_dynamics_derivatives.hpp"
#include "recursion/methods/velocity_changes.hpp"

namespace treeline {

/// Data of every link for derivatives about the centre of mass: the inertia of everything beyond
/// its joint, the vector from its origin to the centre of mass, and its axes in the world.
template <class Scalar>
struct CentroidalParts {
  std::vector<CompositeInertia<Scalar>> composites;
  std::vector<Vector3<Scalar>> centers;
  std::vector<bool> carries_all;
  std::vector<WorldPose<Scalar>> poses;
};

template <class Scalar>
CentroidalParts<Scalar> centroidal_parts(const Tree<Scalar>& tree,
                                         const std::vector<JointTransform<Scalar>>& X) {
  const int from = link_with_all_matter(tree);
  CentroidalParts<Scalar> parts;
  parts.composites = composite_inertias(tree, X);
  parts.centers = centers_seen_from_links(
      tree, X, from, center_seen_from(tree, X, parts.composites, from, tree.inverse_total_mass));
  parts.carries_all = carriers_of_all(tree, from);
  parts.poses = world_poses(tree, X);
  return parts;
}

/// Adds columns of derivatives about the centre of mass, 6 x nv, world axes.
template <class Scalar>
class CentroidalColumns {
 public:
  CentroidalColumns(const Tree<Scalar>& tree, const CentroidalParts<Scalar>& parts)
      : tree_(tree), parts_(parts), matrix_(6, static_cast<std::size_t>(tree.nv)) {}

  /// By a freedom that changes what is beyond joint `i` by `change`, about the origin of its link
  /// and in its axes. What moves all matter without turning it has no moment about its centre.
  void add(std::size_t i, const JointAxis<Scalar>& axis, const Wrench<Scalar>& change) {
    const Matrix3<Scalar>& R = parts_.poses[i].R;
    put(axis, 0, R * (change.f * axis.multiplier));
    if (shifts_all(i, axis)) return;
    put(axis, 3, R * ((change.n - cross(parts_.centers[i], change.f)) * axis.multiplier));
  }

  /// By a displacement: moves the centre of mass, too, about which `total` (world axes) has a
  /// moment.
  void add_displaced(std::size_t i, const JointAxis<Scalar>& axis, const Wrench<Scalar>& change,
                     const Vector3<Scalar>& total) {
    add(i, axis, change);
    if (shifts_all(i, axis)) return;
    const auto& [mass, h, J] = parts_.composites[i];
    const Vector3<Scalar> moved = cross(axis.turn, h) + axis.slide * mass;
    const Scalar share = tree_.inverse_total_mass * axis.multiplier;
    put(axis, 3, cross(total, parts_.poses[i].R * (moved * share)));
  }

  [[nodiscard]] const DenseMatrix<Scalar>& matrix() const { return matrix_; }

 private:
  [[nodiscard]] bool shifts_all(std::size_t i, const JointAxis<Scalar>& axis) const {
    return parts_.carries_all[i] && !axis.turns;
  }
  void put(const JointAxis<Scalar>& axis, std::size_t row, const Vector3<Scalar>& v) {
    for (const Scalar& entry : {v.x, v.y, v.z}) {
      Scalar& sum = matrix_(row++, axis.column);
      sum = sum + entry;
    }
  }

  const Tree<Scalar>& tree_;
  const CentroidalParts<Scalar>& parts_;
  DenseMatrix<Scalar> matrix_;
};

/// Change of the momentum beyond a joint by a displacement: it turns and moves with the joint, and
/// the carrier moves it otherwise.
template <class Scalar>
Wrench<Scalar> momentum_change(const JointAxis<Scalar>& axis, const Wrench<Scalar>& momentum,
                               const CompositeInertia<Scalar>& body,
                               const LinkVelocity<Scalar>& carrier) {
  const auto [dv, dw] = velocity_change(axis, carrier);
  const auto& [P, L] = momentum;
  return {cross(axis.turn, P) + dv * body.mass + cross(dw, body.h),
          cross(axis.turn, L) + cross(axis.slide, P) + cross(body.h, dv) + body.J * dw};
}

/// Derivatives of h_G by displacements, 6 x nv. Those by velocities are A_G.
template <class Scalar>
DenseMatrix<Scalar> centroidal_momentum_by_displacements(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
    std::span<const Scalar> qd) {
  const CentroidalParts<Scalar> parts = centroidal_parts(tree, X);
  const MomentumParts<Scalar> motion = momentum_parts<Scalar>(tree, X, {qd, {}});
  const Vector3<Scalar> total = centroidal_momentum(tree, X, qd).f;
  CentroidalColumns<Scalar> columns(tree, parts);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    section(tree.links[i], i, "derivatives");
    for (const JointAxis<Scalar>& axis : joint_axes(tree.links[i])) {
      columns.add_displaced(
          i, axis,
          momentum_change(axis, motion.momenta[i], parts.composites[i], motion.carriers[i]), total);
    }
  }
  return columns.matrix();
}

/// Derivatives of dh_G/dt by displacements and velocities, 6 x nv. Those by accelerations are A_G.
template <class Scalar>
struct CentroidalRateDerivatives {
  DenseMatrix<Scalar> dq, dqd;
};

/// From the changes of the forces beyond each joint that derivatives of inverse dynamics have,
/// without gravity.
template <class Scalar>
CentroidalRateDerivatives<Scalar> centroidal_rate_derivatives(
    Tree<Scalar> tree, const std::vector<JointTransform<Scalar>>& X,
    const JointRates<Scalar>& rates) {
  tree.gravity = {};
  const CentroidalParts<Scalar> parts = centroidal_parts(tree, X);
  const DerivativeParts<Scalar> forces = derivative_parts<Scalar>(tree, X, rates, {});
  const auto motions = outward_motion(tree, X, rates, Vector3<Scalar>{});
  const Vector3<Scalar> total = sum_about_center(tree, X, inertial_wrenches(tree, motions)).f;
  CentroidalColumns<Scalar> by_q(tree, parts);
  CentroidalColumns<Scalar> by_qd(tree, parts);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    section(tree.links[i], i, "derivatives");
    const Composite<Scalar>& body = forces.composites[i];
    for (const JointFreedom<Scalar>& freedom : forces.freedoms[i]) {
      Wrench<Scalar> change = change_of_wrench(body, freedom.by_q);
      move_wrench(body.force, freedom, change);
      by_q.add_displaced(i, freedom, change, total);
      by_qd.add(i, freedom, change_of_wrench(body, freedom.by_qd));
    }
  }
  return {by_q.matrix(), by_qd.matrix()};
}

}  // namespace treeline
