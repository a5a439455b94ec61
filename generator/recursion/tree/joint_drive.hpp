#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "recursion/tree/joint_transform.hpp"

namespace treeline {

/// Rates for a pass: qd and qdd with nv entries each. An empty span means zero.
template <class Scalar>
struct JointRates {
  std::span<const Scalar> qd, qdd;
  [[nodiscard]] Scalar velocity(std::size_t i) const { return qd.empty() ? Scalar(0.0) : qd[i]; }
  [[nodiscard]] Scalar acceleration(std::size_t i) const {
    return qdd.empty() ? Scalar(0.0) : qdd[i];
  }
};

/// Constants of the smooth sign s of Coulomb friction, see runtime/emitted/link_friction.h.
inline constexpr double kSignDegree = 128;
inline constexpr int kQuadruplings = 3;

/// The smooth sign and its derivative.
template <class Scalar>
struct SmoothSign {
  Scalar value, slope;
};

template <class Scalar>
SmoothSign<Scalar> smooth_sign(const Scalar& x) {
  const Scalar one(1.0);
  Scalar t = x * Scalar(1 / kSignDegree);
  Scalar square = t * t;
  Scalar divisor = one + square;
  SmoothSign<Scalar> sign{(Scalar(2.0) * t) / divisor,
                          Scalar(2 / kSignDegree) * (one - square) / (divisor * divisor)};
  for (int i = 0; i < kQuadruplings; ++i) {
    t = sign.value;
    square = t * t;
    divisor = one + square * (Scalar(6.0) + square);
    const Scalar rest = one - square;
    sign = {(Scalar(4.0) * t * (one + square)) / divisor,
            sign.slope * (Scalar(4.0) * rest * rest * rest / (divisor * divisor))};
  }
  return sign;
}

template <class Scalar>
bool has_friction(const TreeDrive<Scalar>& drive) {
  const Scalar zero(0.0);
  return !(drive.damping == zero && drive.friction == zero);
}
template <class Scalar>
bool has_coulomb_friction(const TreeDrive<Scalar>& drive) {
  return !(drive.friction == Scalar(0.0));
}

/// The joint force that overcomes friction: damping qd + friction s(sharpness qd).
template <class Scalar>
Scalar friction_force(const TreeDrive<Scalar>& drive, const Scalar& qd) {
  const Scalar viscous = drive.damping * qd;
  if (!has_coulomb_friction(drive)) return viscous;
  return viscous + drive.friction * smooth_sign<Scalar>(drive.sharpness * qd).value;
}

/// Derivative of `friction_force` with respect to qd.
template <class Scalar>
Scalar friction_slope(const TreeDrive<Scalar>& drive, const Scalar& qd) {
  if (!has_coulomb_friction(drive)) return drive.damping;
  return drive.damping +
         drive.friction * drive.sharpness * smooth_sign<Scalar>(drive.sharpness * qd).slope;
}

/// Adds what rotors need for qdd and friction for qd.
template <class Scalar>
void add_rotor_and_friction_forces(const Tree<Scalar>& tree, const JointRates<Scalar>& rates,
                                   std::vector<Scalar>& tau) {
  for (const TreeLink<Scalar>& link : tree.links) {
    const auto at = static_cast<std::size_t>(link.v_index);
    if (!rates.qdd.empty() && !(link.drive.inertia == Scalar(0.0))) {
      tau[at] = tau[at] + link.drive.inertia * rates.qdd[at];
    }
    if (!rates.qd.empty() && has_friction(link.drive)) {
      tau[at] = tau[at] + friction_force<Scalar>(link.drive, rates.qd[at]);
    }
  }
}

/// Adds the joint forces that hold springs.
template <class Scalar>
void add_spring_forces(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                       std::vector<Scalar>& tau) {
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeDrive<Scalar>& drive = tree.links[i].drive;
    if (drive.stiffness == Scalar(0.0)) continue;
    const auto at = static_cast<std::size_t>(tree.links[i].v_index);
    tau[at] = tau[at] + drive.stiffness * (X[i].q - drive.rest);
  }
}

/// Adds to the joint forces of the links those of rotors, friction and springs.
template <class Scalar>
void add_drive_forces(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                      const JointRates<Scalar>& rates, std::vector<Scalar>& tau) {
  add_rotor_and_friction_forces(tree, rates, tau);
  add_spring_forces(tree, X, tau);
}

/// Takes friction and springs at the end of a step: to first order they are friction(qd) + step D
/// qdd and K (q + step qd + step^2 qdd - rest) there, with D = d friction / d qd, so that M + step
/// D
/// + step^2 K stands in for M, as if rotors were heavier, and rest - step qd for rest.
template <class Scalar>
void make_drives_implicit(std::span<const Scalar> qd, const Scalar& step, Tree<Scalar>& tree) {
  for (TreeLink<Scalar>& link : tree.links) {
    TreeDrive<Scalar>& drive = link.drive;
    const Scalar& own = qd[static_cast<std::size_t>(link.v_index)];
    if (has_friction(drive)) {
      drive.inertia = drive.inertia + step * friction_slope<Scalar>(drive, own);
    }
    if (drive.stiffness == Scalar(0.0)) continue;
    drive.inertia = drive.inertia + step * step * drive.stiffness;
    drive.rest = drive.rest - step * own;
  }
}

}  // namespace treeline
