#pragma once

#include <vector>

#include "recursion/methods/composite_momentum.hpp"
#include "recursion/methods/steady_forces.hpp"
#include "recursion/tree/joint_axes.hpp"

namespace treeline {

/// Derivatives of joint forces with respect to displacements, velocities and accelerations, nv x
/// nv. A displacement of a floating or ball joint is a twist of the child in its own axes, linear
/// over angular.
template <class Scalar>
struct ForceDerivatives {
  DenseMatrix<Scalar> dq, dqd, dqdd;
};

/// Change of the acceleration of a point r beyond a joint due to one degree of freedom of that
/// joint, for an observer who moves with what is beyond it: da(r) = a + wd x r + 2 alpha x v(r),
/// where v is relative to the origin.
template <class Scalar>
struct MotionChange {
  Vector3<Scalar> a, wd, alpha;
};

/// One degree of freedom of a joint, and the changes of motion due to a change of its displacement
/// or velocity.
template <class Scalar>
struct JointFreedom : JointAxis<Scalar> {
  MotionChange<Scalar> by_q, by_qd;
};

/// Motion of a link's parent at the link's origin, in the link's axes.
template <class Scalar>
struct CarriedMotion {
  Vector3<Scalar> w, wd, a;
  Matrix3<Scalar> U;
};

template <class Scalar, class Motion>
CarriedMotion<Scalar> carried_motion(const JointTransform<Scalar>& X, const Motion& parent,
                                     const Matrix3<Scalar>& U) {
  CarriedMotion<Scalar> carried;
  carried.w = X.to_child(parent.w);
  carried.wd = X.to_child(parent.wd);
  carried.a = X.to_child(parent.a + U * X.p);
  carried.U = angular_matrix(carried.w, carried.wd).matrix();
  return carried;
}

/// Sets the change of motion due to a rotation of the joint. `v_rel` and `w_rel` are the joint's
/// own velocity in the link's axes, with all components for a floating joint.
template <class Scalar>
void change_by_turn(const CarriedMotion<Scalar>& parent, const Vector3<Scalar>& w,
                    const Vector3<Scalar>& v_rel, JointFreedom<Scalar>& freedom) {
  const Vector3<Scalar>& e = freedom.turn;
  const Vector3<Scalar> alpha = cross(parent.w, e);
  const Vector3<Scalar> two_alpha = alpha * Scalar(2.0);
  freedom.by_q = {cross(parent.a, e) + cross(two_alpha, v_rel),
                  cross(parent.wd, e) + cross(parent.w, alpha), alpha};
  freedom.by_qd = {cross(e, v_rel), cross(parent.w, e) + cross(w, e), e};
}

template <class Scalar>
void change_by_slide(const CarriedMotion<Scalar>& parent, const Vector3<Scalar>& w,
                     JointFreedom<Scalar>& freedom) {
  const Vector3<Scalar>& e = freedom.slide;
  freedom.by_q = {parent.U * e, {}, {}};
  freedom.by_qd = {cross(parent.w, e) + cross(w, e), {}, {}};
}

/// Degrees of freedom of a link's joint (Carpentier & Mansard 2018; Singh, Russell & Wensing 2022),
/// with conventional accelerations, so that no velocity of an origin occurs. `carried` is the
/// motion of the link that carries the joint.
template <class Scalar>
std::vector<JointFreedom<Scalar>> joint_freedoms(const TreeLink<Scalar>& link,
                                                 const CarriedMotion<Scalar>& carried,
                                                 const LinkMotion<Scalar>& own,
                                                 const JointRates<Scalar>& rates) {
  const auto at = static_cast<std::size_t>(link.v_index);
  const Vector3<Scalar> v_rel = link.is_floating() ? velocity_triple(rates, at) : Vector3<Scalar>{};
  std::vector<JointFreedom<Scalar>> freedoms;
  for (const JointAxis<Scalar>& axis : joint_axes(link)) {
    JointFreedom<Scalar> freedom{axis, {}, {}};
    if (axis.turns) {
      change_by_turn(carried, own.w, v_rel, freedom);
    } else {
      change_by_slide(carried, own.w, freedom);
    }
    freedoms.push_back(freedom);
  }
  return freedoms;
}

/// Everything beyond a joint as one body, with the properties that derivatives need.
template <class Scalar>
struct Composite {
  CompositeInertia<Scalar> inertia;
  CompositeMomentum<Scalar> momentum;
  SteadyForces<Scalar> steady;
  Wrench<Scalar> force;  ///< force that the joint passes on
};

/// Change of the wrench on a composite body due to a change of the motion of what carries it.
template <class Scalar>
Wrench<Scalar> change_of_wrench(const Composite<Scalar>& body, const MotionChange<Scalar>& change) {
  const auto& [mass, h, J] = body.inertia;
  return {change.a * mass + cross(change.wd, h) + cross(change.alpha, body.momentum.P),
          cross(h, change.a) + J * change.wd + turned_moment(body.momentum.C, change.alpha)};
}

/// Relation of one degree of freedom to those of earlier joints. It is carried inward, link by
/// link.
template <class Scalar>
struct CarriedColumn {
  std::size_t column = 0;
  Scalar multiplier{};
  int way = 0;  ///< number of joints from its own to the base
  /// Wrench for a unit acceleration. The generalized force of this freedom due to a change of
  /// motion beyond an earlier joint that is displaced about e is t.f a + t.n wd + t_alpha alpha +
  /// t_turn e.
  Wrench<Scalar> t;
  Vector3<Scalar> t_alpha, t_turn;
  Wrench<Scalar> by_q, by_qd;  ///< changes of the wrench on earlier joints
};

/// Transpose of `turned_moment`: (tr C) e - C^T e.
template <class Scalar>
Vector3<Scalar> turned_moment_back(const Matrix3<Scalar>& C, const Vector3<Scalar>& e) {
  return turned_moment(transposed(C), e);
}

template <class Scalar>
CarriedColumn<Scalar> begin_column(const Composite<Scalar>& body,
                                   const JointFreedom<Scalar>& freedom) {
  const Vector3<Scalar>& e = freedom.turn;
  const Vector3<Scalar>& l = freedom.slide;
  const auto& [mass, h, J] = body.inertia;
  CarriedColumn<Scalar> column;
  column.column = freedom.column;
  column.multiplier = freedom.multiplier;
  column.t = {cross(e, h) + l * mass, J * e + cross(h, l)};
  column.t_alpha = turned_moment_back(body.momentum.C, e) + cross(body.momentum.P, l);
  column.t_turn =
      turned_moment_back(body.steady.K, e) + cross(body.steady.n, e) + cross(body.steady.f, l);
  column.by_q = change_of_wrench(body, freedom.by_q);
  column.by_q =
      column.by_q + Wrench<Scalar>{cross(e, body.steady.f),
                                   cross(e, body.steady.n) + turned_moment(body.steady.K, e)};
  column.by_qd = change_of_wrench(body, freedom.by_qd);
  return column;
}

/// Adds the change of a wrench that moves with the displaced joint.
template <class Scalar>
void move_wrench(const Wrench<Scalar>& force, const JointFreedom<Scalar>& freedom,
                 Wrench<Scalar>& by_q) {
  by_q = by_q + Wrench<Scalar>{cross(freedom.turn, force.f),
                               cross(freedom.turn, force.n) + cross(freedom.slide, force.f)};
}

/// Aligns three values that may share lanes in a trace. A common sign is taken out.
template <class Scalar>
void align_triple(Scalar& a, Scalar& b, Scalar& c) {
  if constexpr (std::is_same_v<Scalar, Expression>) {
    const auto minus = [](const Scalar& x) { return x.is_constant() || x.negative(); };
    const bool negative = minus(a) && minus(b) && minus(c);
    std::vector<Scalar> lanes{a, b, c};
    for (Scalar& lane : lanes) {
      lane = negative ? -lane : lane;
    }
    align_lanes(lanes);
    a = negative ? -lanes[0] : lanes[0];
    b = negative ? -lanes[1] : lanes[1];
    c = negative ? -lanes[2] : lanes[2];
  }
}

/// Aligns the wrenches of a column, on which the same operations are done: one lane each.
template <class Scalar>
void align_lanes(CarriedColumn<Scalar>& column) {
  using V = Vector3<Scalar>;
  for (const auto half : {&Wrench<Scalar>::f, &Wrench<Scalar>::n}) {
    for (const auto part : {&V::x, &V::y, &V::z}) {
      align_triple(column.t.*half.*part, column.by_q.*half.*part, column.by_qd.*half.*part);
    }
  }
}

template <class Scalar>
CarriedColumn<Scalar> to_parent(const JointTransform<Scalar>& X,
                                const Vector3<Scalar>& twice_velocity,
                                const CarriedColumn<Scalar>& column) {
  CarriedColumn<Scalar> carried = column;
  carried.t = to_parent(X, column.t);
  carried.t_alpha = X.to_parent(column.t_alpha) + cross(twice_velocity, carried.t.f);
  carried.t_turn = X.to_parent(column.t_turn);
  carried.by_q = to_parent(X, column.by_q);
  carried.by_qd = to_parent(X, column.by_qd);
  return carried;
}

template <class Scalar>
Scalar work(const Wrench<Scalar>& wrench, const JointFreedom<Scalar>& freedom) {
  return dot(wrench.f, freedom.slide) + dot(wrench.n, freedom.turn);
}
template <class Scalar>
Scalar work(const CarriedColumn<Scalar>& column, const MotionChange<Scalar>& change) {
  return dot(column.t.f, change.a) + dot(column.t.n, change.wd) + dot(column.t_alpha, change.alpha);
}

template <class Scalar>
class DerivativeEntries {
 public:
  explicit DerivativeEntries(std::size_t nv)
      : results_{DenseMatrix<Scalar>(nv, nv), DenseMatrix<Scalar>(nv, nv),
                 DenseMatrix<Scalar>(nv, nv)} {}

  /// Adds the terms between a joint's own freedoms. For by_q the move of the wrench is left out,
  /// because the joint's own axes move with it.
  void add_own(const std::vector<JointFreedom<Scalar>>& freedoms,
               const std::vector<CarriedColumn<Scalar>>& columns) {
    for (const JointFreedom<Scalar>& row : freedoms) {
      for (const CarriedColumn<Scalar>& column : columns) {
        const Scalar factor = row.multiplier * column.multiplier;
        add(results_.dq, row.column, column.column, factor * work(column.by_q, row));
        add(results_.dqd, row.column, column.column, factor * work(column.by_qd, row));
        add(results_.dqdd, row.column, column.column, factor * work(column.t, row));
      }
    }
  }

  /// Adds the terms between a freedom and one of an earlier joint, in both directions.
  void add_pair(const CarriedColumn<Scalar>& later, const JointFreedom<Scalar>& earlier) {
    const Scalar factor = later.multiplier * earlier.multiplier;
    const std::size_t i = later.column;
    const std::size_t j = earlier.column;
    add(results_.dq, i, j, factor * (work(later, earlier.by_q) + dot(later.t_turn, earlier.turn)));
    add(results_.dqd, i, j, factor * work(later, earlier.by_qd));
    add(results_.dq, j, i, factor * work(later.by_q, earlier));
    add(results_.dqd, j, i, factor * work(later.by_qd, earlier));
    const Scalar inertia = factor * work(later.t, earlier);
    add(results_.dqdd, i, j, inertia);
    add(results_.dqdd, j, i, inertia);
  }

  /// Adds what the joint's own rotor, friction and spring contribute to the diagonals.
  void add_drive(const TreeLink<Scalar>& link, const JointRates<Scalar>& rates) {
    const auto at = static_cast<std::size_t>(link.v_index);
    add(results_.dq, at, at, link.drive.stiffness);
    add(results_.dqdd, at, at, link.drive.inertia);
    if (has_friction(link.drive)) {
      add(results_.dqd, at, at, friction_slope<Scalar>(link.drive, rates.velocity(at)));
    }
  }

  [[nodiscard]] const ForceDerivatives<Scalar>& results() const { return results_; }

 private:
  static void add(DenseMatrix<Scalar>& matrix, std::size_t i, std::size_t j, const Scalar& value) {
    matrix(i, j) = matrix(i, j) + value;
  }
  ForceDerivatives<Scalar> results_;
};

/// Parts of the derivatives that do not depend on pairs of joints, by link.
template <class Scalar>
struct DerivativeParts {
  std::vector<std::vector<JointFreedom<Scalar>>> freedoms;
  std::vector<Composite<Scalar>> composites;
  std::vector<Vector3<Scalar>> velocities;  ///< see `twice_relative_velocity`
};

template <class Scalar>
DerivativeParts<Scalar> derivative_parts(const Tree<Scalar>& tree,
                                         const std::vector<JointTransform<Scalar>>& X,
                                         const JointRates<Scalar>& rates,
                                         std::span<const Scalar> f_ext) {
  LinkMotion<Scalar> base;
  base.a = -tree.gravity;
  const auto motions = outward_motion(tree, X, rates, base.a);
  auto wrenches = inertial_wrenches(tree, motions);
  if (!f_ext.empty()) {
    const auto applied = applied_wrenches<Scalar>(tree, X, f_ext);
    for (std::size_t i = 0; i < applied.size(); ++i) {
      wrenches[i] = wrenches[i] - applied[i];
    }
  }
  DerivativeParts<Scalar> parts;
  std::vector<CarriedMotion<Scalar>> carried;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "changes of motion");
    const auto h = static_cast<std::size_t>(link.parent);
    const auto& parent = link.parent < 0 ? base : motions[h];
    carried.push_back(link.continues_joint()
                          ? carried_motion<Scalar>(X[i], carried[h], carried[h].U)
                          : carried_motion<Scalar>(X[i], parent, parent.U.matrix()));
    parts.freedoms.push_back(joint_freedoms(link, carried[i], motions[i], rates));
    parts.velocities.push_back(twice_relative_velocity(link, X[i], parent.w, rates));
  }
  const auto inertias = composite_inertias(tree, X);
  const auto momenta = composite_momenta(tree, X, inertias, motions, parts.velocities);
  const auto steady = steady_forces(tree, X, f_ext);
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    if (tree.links[i].parent >= 0) {
      auto& parent = wrenches[static_cast<std::size_t>(tree.links[i].parent)];
      parent = parent + to_parent(X[i], wrenches[i]);
    }
  }
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    parts.composites.push_back({inertias[i], momenta[i], steady[i], wrenches[i]});
  }
  return parts;
}

/// On paths shorter than this, lanes cost more to fill than they save (measured).
inline constexpr int kLongWay = 6;

template <class Scalar>
int joints_before(const Tree<Scalar>& tree, std::size_t link) {
  int count = 0;
  for (int h = tree.links[link].parent; h >= 0;
       h = tree.links[static_cast<std::size_t>(h)].parent) {
    ++count;
  }
  return count;
}

/// Derivatives of inverse dynamics in O(n d), where d is the depth of the tree, in link frames.
/// Each freedom is carried inward once and combined with those of all earlier joints. Entries of
/// joints on different branches stay structural zeros.
template <class Scalar>
ForceDerivatives<Scalar> inverse_dynamics_derivatives(const Tree<Scalar>& tree,
                                                      const std::vector<JointTransform<Scalar>>& X,
                                                      const JointRates<Scalar>& rates,
                                                      std::span<const Scalar> f_ext) {
  const DerivativeParts<Scalar> parts = derivative_parts(tree, X, rates, f_ext);
  DerivativeEntries<Scalar> entries(static_cast<std::size_t>(tree.nv));
  std::vector<std::vector<CarriedColumn<Scalar>>> carried(tree.links.size());
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "derivatives");
    const Composite<Scalar>& body = parts.composites[i];
    const auto& freedoms = parts.freedoms[i];
    for (const CarriedColumn<Scalar>& column : carried[i]) {
      for (const JointFreedom<Scalar>& freedom : freedoms) {
        entries.add_pair(column, freedom);
      }
    }
    std::vector<CarriedColumn<Scalar>> own;
    for (const JointFreedom<Scalar>& freedom : freedoms) {
      own.push_back(begin_column(body, freedom));
      own.back().way = joints_before(tree, i);
    }
    entries.add_own(freedoms, own);
    entries.add_drive(link, rates);
    if (link.parent < 0) {
      continue;
    }
    for (std::size_t k = 0; k < own.size(); ++k) {
      move_wrench(body.force, freedoms[k], own[k].by_q);
      carried[i].push_back(own[k]);
    }
    for (const CarriedColumn<Scalar>& column : carried[i]) {
      auto& at_parent = carried[static_cast<std::size_t>(link.parent)];
      at_parent.push_back(to_parent(X[i], parts.velocities[i], column));
      if (column.way >= kLongWay) {
        align_lanes(at_parent.back());
      }
    }
  }
  return entries.results();
}

}  // namespace treeline
