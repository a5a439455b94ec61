#pragma once

#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "program/expression.hpp"
#include "recursion/algebra/align_lanes.hpp"
#include "recursion/algebra/planar_rotation.hpp"
#include "recursion/tree/mark_limbs.hpp"

namespace treeline {

/// Inertia of a link, rounded once from the mechanism to `Scalar`, in the form in which recursions
/// use it.
template <class Scalar>
struct TreeInertia {
  Scalar mass{};
  Vector3<Scalar> h;         ///< first moment m c
  Symmetric3<Scalar> Sigma;  ///< second moment about the frame's origin
  Symmetric3<Scalar> J;      ///< rotational inertia about the frame's origin
};

/// Rotor, friction and spring of a joint, see `JointDrive`.
template <class Scalar>
struct TreeDrive {
  Scalar inertia{}, damping{}, friction{}, sharpness{}, stiffness{}, rest{};
};

template <class Scalar>
struct TreeLink : JointStep {
  std::string name;
  int parent = -1;
  int q_index = 0, v_index = 0;
  Scalar multiplier{}, offset{};
  Rotation<Scalar> R;  ///< rotation of the placement
  Vector3<Scalar> p;   ///< origin of the placement, in the parent's axes
  TreeInertia<Scalar> inertia;
  bool defers_rotation = false, carries_column = false, spins = false;  ///< see `MovingLink`
  TreeDrive<Scalar> drive;
};

template <class Scalar>
struct TreePoint {
  std::string name;
  int link = -1;
  Matrix3<Scalar> R;  ///< from point's axes to link's axes
  Vector3<Scalar> p;  ///< in the link's axes
  Axes axes = Axes::world;
  std::array<bool, 6> rows{};
  int priority = 1;
  bool center_of_mass = false;  ///< see `MechanismPoint`
  Scalar share = Scalar(1.0);   ///< to which its task is done, see `TaskShares`
};

/// Mass and first moment of matter as in the file, about the origin of the link's frame.
template <class Scalar>
struct TreeMatter {
  int link = -1;
  Scalar mass{};
  Vector3<Scalar> h;
};

/// A contact that rolls, see `MechanismRolling`.
template <class Scalar>
struct TreeRolling {
  Scalar radius{};
  std::optional<Vector3<Scalar>> axis;
  std::optional<Scalar> on_radius;
};

/// Two frames of which rows are held relative to each other, see `MechanismLoop`.
template <class Scalar>
struct TreeLoop {
  TreePoint<Scalar> first, second;
  std::optional<TreeRolling<Scalar>> rolling = {};
};

template <class Scalar>
struct Tree {
  std::vector<TreeLink<Scalar>> links;
  std::vector<TreePoint<Scalar>> operational_points, external_forces, contacts, link_frames;
  std::vector<TreePoint<Scalar>> payload_frames;  ///< see `Mechanism`
  std::vector<TreeLoop<Scalar>> loops;
  std::vector<MechanismCoupling> couplings;
  std::vector<TreeMatter<Scalar>> link_matter;  ///< of each of `link_frames`
  Vector3<Scalar> gravity;
  Vector3<Scalar> world_moment;  ///< first moment of matter fixed to the world
  Scalar total_mass{};           ///< of all links
  Scalar inverse_total_mass{};   ///< 0 if the robot has no mass
  int nq = 0, nv = 0;
  bool has_mimics = false;
  bool has_world_matter = false;  ///< matter fixed to the world counts for the centre of mass
};

/// The nearest double, as in emitted code. Expressions are told also what rounding left, so that
/// what follows from constants alone is rounded once. For Digits50 the value itself, so that tests
/// can show that reductions change nothing.
template <class Scalar>
Scalar rounded(const Digits50& value) {
  if constexpr (std::is_same_v<Scalar, Digits50>) {
    return value;
  } else if constexpr (std::is_constructible_v<Scalar, DoubleDouble>) {
    return Scalar(DoubleDouble::from(value));
  } else {
    return Scalar(static_cast<double>(value));
  }
}
template <class Scalar>
Vector3<Scalar> rounded(const Digits50Vector3& v) {
  return {rounded<Scalar>(v(0)), rounded<Scalar>(v(1)), rounded<Scalar>(v(2))};
}
template <class Scalar>
Symmetric3<Scalar> rounded_symmetric(const Digits50Matrix3& A) {
  return {rounded<Scalar>(A(0, 0)), rounded<Scalar>(A(0, 1)), rounded<Scalar>(A(0, 2)),
          rounded<Scalar>(A(1, 1)), rounded<Scalar>(A(1, 2)), rounded<Scalar>(A(2, 2))};
}
template <class Scalar>
Matrix3<Scalar> rounded(const Digits50Matrix3& A) {
  return {{rounded<Scalar>(A(0, 0)), rounded<Scalar>(A(0, 1)), rounded<Scalar>(A(0, 2))},
          {rounded<Scalar>(A(1, 0)), rounded<Scalar>(A(1, 1)), rounded<Scalar>(A(1, 2))},
          {rounded<Scalar>(A(2, 0)), rounded<Scalar>(A(2, 1)), rounded<Scalar>(A(2, 2))}};
}

/// Rotation from cosine and sine, exact for quarter turns.
template <class Scalar>
PlanarRotation<Scalar> planar_rotation(const Digits50& c, const Digits50& s) {
  return {rounded<Scalar>(snapped(c, Digits50(1))), rounded<Scalar>(snapped(s, Digits50(1)))};
}

/// Factors R = Rz(a) Rx(alpha) Rz(b). The third column of R is (sin a sin alpha, -cos a sin alpha,
/// cos alpha), its third row (sin alpha sin b, sin alpha cos b, cos alpha).
template <class Scalar>
Rotation<Scalar> planar_factors(const Digits50Matrix3& R) {
  const Digits50 sine = sqrt(Digits50(R(0, 2) * R(0, 2) + R(1, 2) * R(1, 2)));
  if (snapped(sine, Digits50(1)) == 0) {  // alpha is 0 or pi: b may join the joint's angle
    return {{},
            planar_rotation<Scalar>(R(2, 2), Digits50(0)),
            planar_rotation<Scalar>(R(0, 0), Digits50(-R(0, 1)))};
  }
  return {planar_rotation<Scalar>(Digits50(-R(1, 2) / sine), Digits50(R(0, 2) / sine)),
          planar_rotation<Scalar>(R(2, 2), sine),
          planar_rotation<Scalar>(Digits50(R(2, 1) / sine), Digits50(R(2, 0) / sine))};
}

template <class Scalar>
TreeDrive<Scalar> tree_drive(const JointDrive& drive) {
  return {rounded<Scalar>(drive.inertia),   rounded<Scalar>(drive.damping),
          rounded<Scalar>(drive.friction),  rounded<Scalar>(drive.sharpness),
          rounded<Scalar>(drive.stiffness), rounded<Scalar>(drive.rest)};
}

template <class Scalar>
TreePoint<Scalar> tree_point(const MechanismPoint& point) {
  return {point.name,
          point.link,
          rounded<Scalar>(point.pose.R),
          rounded<Scalar>(point.pose.p),
          point.axes,
          point.rows,
          point.priority,
          point.center_of_mass};
}

template <class Scalar>
std::optional<TreeRolling<Scalar>> tree_rolling(const std::optional<MechanismRolling>& from) {
  if (!from) return std::nullopt;
  TreeRolling<Scalar> rolling{Scalar(from->radius), {}, {}};
  if (from->axis) rolling.axis = rounded<Scalar>(*from->axis);
  if (from->on_radius) rolling.on_radius = Scalar(*from->on_radius);
  return rolling;
}

template <class Scalar>
TreeLink<Scalar> tree_link(const MovingLink& link) {
  const Digits50Matrix3 J = rotational_inertia(link.inertia);
  return {link,
          link.name,
          link.parent,
          link.q_index,
          link.v_index,
          Scalar(link.multiplier),
          rounded<Scalar>(link.offset),
          planar_factors<Scalar>(link.placement.R),
          rounded<Scalar>(link.placement.p),
          {rounded<Scalar>(link.inertia.mass), rounded<Scalar>(link.inertia.h),
           rounded_symmetric<Scalar>(link.inertia.Sigma), rounded_symmetric<Scalar>(J)},
          link.defers_rotation,
          link.carries_column,
          link.spins,
          tree_drive<Scalar>(link.drive)};
}

template <class Scalar>
std::vector<TreePoint<Scalar>> tree_points(const std::vector<MechanismPoint>& points) {
  std::vector<TreePoint<Scalar>> result;
  for (const MechanismPoint& point : points) result.push_back(tree_point<Scalar>(point));
  return result;
}

/// The masses of the links of the file, of the world and of all together.
template <class Scalar>
void set_masses(const Mechanism& mechanism, Tree<Scalar>& tree) {
  for (std::size_t i = 0; i < mechanism.link_matter.size(); ++i) {
    const MechanismPoint& frame = mechanism.link_frames[i];
    const Inertia matter = transformed(mechanism.link_matter[i], frame.pose);
    tree.link_matter.push_back(
        {frame.link, rounded<Scalar>(matter.mass), rounded<Scalar>(matter.h)});
  }
  Digits50 mass = mechanism.world.mass;
  for (const MovingLink& link : mechanism.links) mass += link.inertia.mass;
  tree.world_moment = rounded<Scalar>(mechanism.world.h);
  tree.total_mass = rounded<Scalar>(mass);
  tree.inverse_total_mass = rounded<Scalar>(mass > 0 ? Digits50(1 / mass) : Digits50(0));
  tree.has_world_matter = mechanism.world.mass != 0 || !mechanism.world.h.isZero(0);
}

/// Returns the constant part of the tree: without inertias that are arguments, with the gravity and
/// the points of the scene. See `tree_of`.
template <class Scalar>
Tree<Scalar> constant_tree(const Mechanism& mechanism) {
  Tree<Scalar> tree;
  for (const MovingLink& link : mechanism.links) tree.links.push_back(tree_link<Scalar>(link));
  tree.operational_points = tree_points<Scalar>(mechanism.operational_points);
  tree.external_forces = tree_points<Scalar>(mechanism.external_forces);
  tree.contacts = tree_points<Scalar>(mechanism.contacts);
  for (const MechanismLoop& loop : mechanism.loops) {
    tree.loops.push_back({tree_point<Scalar>(loop.first), tree_point<Scalar>(loop.second),
                          tree_rolling<Scalar>(loop.rolling)});
  }
  tree.couplings = mechanism.couplings;
  tree.link_frames = tree_points<Scalar>(mechanism.link_frames);
  tree.payload_frames = tree_points<Scalar>(mechanism.payload_frames);
  set_masses(mechanism, tree);
  const auto& g = mechanism.gravity;
  tree.gravity = {Scalar(g[0]), Scalar(g[1]), Scalar(g[2])};
  tree.nq = mechanism.nq();
  tree.nv = mechanism.nv();
  tree.has_mimics = mechanism.has_mimics();
  if constexpr (std::is_same_v<Scalar, Expression>) {
    mark_limbs(mechanism, tree);
  }
  return tree;
}

/// Suggests the name `symbol + link number [+ _suffix]` for a traced value. Numbers count links
/// from 1, as in the emitted contract. Does nothing for other scalars.
template <class Scalar>
void label(const Scalar& value, const char* symbol, std::size_t link, const char* suffix = "") {
  if constexpr (std::is_same_v<Scalar, Expression>) {
    if (Graph::current().keeps_names()) {
      Graph::current().name(value, symbol + std::to_string(link + 1) + suffix);
    }
  }
}
template <class Scalar>
void label(const Vector3<Scalar>& v, const char* symbol, std::size_t link) {
  label(v.x, symbol, link, "_x");
  label(v.y, symbol, link, "_y");
  label(v.z, symbol, link, "_z");
}
/// Declares that the following part of the trace is this step of the algorithm at this link. It
/// becomes a comment in emitted code.
template <class Scalar>
void section(const TreeLink<Scalar>& link, std::size_t index, const char* step) {
  if constexpr (std::is_same_v<Scalar, Expression>) {
    if (Graph::current().keeps_names()) {
      Graph::current().begin_section({static_cast<int>(index) + 1, link.name, step});
    }
  }
}

}  // namespace treeline
