#pragma once

#include <array>
#include <string>
#include <vector>

#include "interpreter/spatial.hpp"

namespace treeline::interpreter {

enum class JointKind { fixed, revolute, prismatic, planar, floating, spherical };

/// Number of entries of q for a joint of this kind.
constexpr int position_count(JointKind kind) {
  constexpr std::array kCounts{0, 1, 1, 3, 7, 4};
  return kCounts[static_cast<std::size_t>(kind)];
}

/// Number of entries of qd for a joint of this kind: d, the number of columns of S (Chang 3.2).
constexpr int velocity_count(JointKind kind) {
  constexpr std::array kCounts{0, 1, 1, 3, 6, 3};
  return kCounts[static_cast<std::size_t>(kind)];
}

/// A link and the joint that carries it. The link's frame is the joint's frame moved by the joint.
/// The joint's coordinates are
///  revolute   angle about `axis`
///  prismatic  displacement along `axis`
///  planar     x, y in the plane normal to `axis`, then the angle about it; qd = dq/dt
///  floating   position and quaternion x y z w of the link's frame in the joint's frame;
///             qd = body twist: velocity of the link's origin, angular velocity, in the link's axes
///  spherical  quaternion x y z w; qd = angular velocity in the link's axes
/// Quaternions may have any length: only their direction counts.
template <class Scalar>
struct Body {
  std::string name;
  int parent = kWorld;  ///< smaller than the body's own index
  JointKind kind = JointKind::fixed;
  Vector3<Scalar> axis = Vector3<Scalar>::UnitZ();  ///< unit vector in the joint's frame
  Matrix3<Scalar> R_parent_joint = Matrix3<Scalar>::Identity();
  Vector3<Scalar> p_parent_joint = Vector3<Scalar>::Zero();
  Scalar mass = Scalar(0);
  Vector3<Scalar> com = Vector3<Scalar>::Zero();      ///< centre of mass in the link's frame
  Matrix3<Scalar> inertia = Matrix3<Scalar>::Zero();  ///< about the link frame's origin
  int q = 0;            ///< first entry in q: the joint's own, or that of the joint it mimics
  int v = 0;            ///< first entry in qd: the joint's own, or that of the joint it mimics
  bool mimics = false;  ///< has no coordinates of its own: position = multiplier * leader's +
                        ///< offset
  Scalar multiplier = Scalar(1);
  Scalar offset = Scalar(0);
  /// Inertia of the motor's rotor, felt at each of the joint's own velocities; kg m^2 or kg.
  Scalar armature = Scalar(0);
  /// Drive of a joint of one degree of freedom, see `joint_forces`: N m s/rad, N m, rad/s; N m/rad,
  /// rad, or the same of translation.
  Scalar damping = Scalar(0);
  Scalar friction = Scalar(0);
  Scalar slip_speed = Scalar(1);
  Scalar stiffness = Scalar(0);
  Scalar rest = Scalar(0);
};

/// Any tree of bodies, parents before children.
template <class Scalar>
struct Model {
  std::vector<Body<Scalar>> bodies;
  int nq = 0;
  int nv = 0;
  Vector3<Scalar> gravity = Vector3<Scalar>(Scalar(0), Scalar(0), Scalar(-9.81));  ///< world axes

  [[nodiscard]] int size() const { return static_cast<int>(bodies.size()); }
  [[nodiscard]] const Body<Scalar>& body(int i) const {
    return bodies[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] bool has_mimics() const {
    for (const auto& b : bodies) {
      if (b.mimics) return true;
    }
    return false;
  }
};

/// Adds a body whose joint has coordinates of its own, after those of the bodies before it. Returns
/// its index.
template <class Scalar>
int add_body(Model<Scalar>& model, Body<Scalar> body) {
  body.q = model.nq;
  body.v = model.nv;
  model.nq += position_count(body.kind);
  model.nv += velocity_count(body.kind);
  model.bodies.push_back(std::move(body));
  return model.size() - 1;
}

enum class PointAxes { world, local };

/// A frame fixed to a body: an operational point, or the place where an external force acts. Its
/// rows are [linear; angular] motion or force at its origin, in world axes or its own. Or the
/// centre of mass of all bodies, of which nothing but linear rows in world axes has a meaning.
template <class Scalar>
struct OperationalPoint {
  std::string name;
  int body = 0;
  Matrix3<Scalar> R = Matrix3<Scalar>::Identity();  ///< rotation to the body's frame
  Vector3<Scalar> p = Vector3<Scalar>::Zero();
  PointAxes axes = PointAxes::world;
  std::array<bool, 6> rows{true, true, true, true, true, true};  ///< x y z rx ry rz
  int priority = 1;          ///< of the task at the point: 1 comes first, see `control_torque`
  Scalar share = Scalar(1);  ///< 0 to 1, to which the task is done, see `with_shares`
  bool center_of_mass = false;
};

/// The place of an external force, which always has all six rows. The force is positive if it acts
/// on the robot.
template <class Scalar>
using ExternalForcePoint = OperationalPoint<Scalar>;

template <class Scalar>
using Points = std::vector<OperationalPoint<Scalar>>;
/// A function argument from which `Scalar` is not deduced, so that `{}` fits.
template <class Scalar>
using PointsArg = const std::type_identity_t<Points<Scalar>>&;

/// Converts a model to another precision, rounding each number.
template <class To, class From>
Model<To> cast(const Model<From>& model) {
  const auto to = [](const From& x) { return static_cast<To>(x); };
  Model<To> result;
  result.nq = model.nq;
  result.nv = model.nv;
  result.gravity = model.gravity.unaryExpr(to);
  for (const auto& b : model.bodies) {
    result.bodies.push_back({b.name,
                             b.parent,
                             b.kind,
                             b.axis.unaryExpr(to),
                             b.R_parent_joint.unaryExpr(to),
                             b.p_parent_joint.unaryExpr(to),
                             to(b.mass),
                             b.com.unaryExpr(to),
                             b.inertia.unaryExpr(to),
                             b.q,
                             b.v,
                             b.mimics,
                             to(b.multiplier),
                             to(b.offset),
                             to(b.armature),
                             to(b.damping),
                             to(b.friction),
                             to(b.slip_speed),
                             to(b.stiffness),
                             to(b.rest)});
  }
  return result;
}

/// Converts points to another precision, rounding each number.
template <class To, class From>
Points<To> cast(const Points<From>& points) {
  const auto to = [](const From& x) { return static_cast<To>(x); };
  Points<To> result;
  for (const auto& e : points) {
    result.push_back({e.name, e.body, e.R.unaryExpr(to), e.p.unaryExpr(to), e.axes, e.rows,
                      e.priority, to(e.share), e.center_of_mass});
  }
  return result;
}

}  // namespace treeline::interpreter
