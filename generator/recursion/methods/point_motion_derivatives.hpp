#pragma once

#include <span>
#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/methods/forward_kinematics.hpp"
#include "recursion/methods/outward_motion.hpp"
#include "recursion/tree/joint_axes.hpp"

namespace treeline {

/// Derivatives of what `point_velocities` and `point_accelerations` give: six rows a point, world
/// axes, by displacements and by velocities. J is that of velocities by velocities, and of
/// accelerations by accelerations.
template <class Scalar>
struct PointDerivatives {
  DenseMatrix<Scalar> dv_dq, J, da_dq, da_dqd;
};

/// One degree of freedom of a joint in world axes, and the velocity and acceleration of all of them
/// together as the carrier sees it.
template <class Scalar>
struct WorldJoint {
  std::vector<JointAxis<Scalar>> axes;
  Vector3<Scalar> v, w;      ///< of the link's origin, and angular
  Vector3<Scalar> a, wd;     ///< their rates
  bool is_compound = false;  ///< axes of the joint turn each other: it floats or is a ball
};

template <class Scalar>
WorldJoint<Scalar> world_joint(const TreeLink<Scalar>& link, const Matrix3<Scalar>& R,
                               const JointRates<Scalar>& rates) {
  WorldJoint<Scalar> joint;
  joint.axes = joint_axes(link);
  joint.is_compound = link.is_floating() || link.is_of_ball();
  for (JointAxis<Scalar>& axis : joint.axes) {
    const Scalar qd = axis.multiplier * rates.velocity(axis.column);
    const Scalar qdd = axis.multiplier * rates.acceleration(axis.column);
    if (axis.turns) {
      axis.turn = R * axis.turn;
      joint.w = joint.w + axis.turn * qd;
      joint.wd = joint.wd + axis.turn * qdd;
    } else {
      axis.slide = R * axis.slide;
      joint.v = joint.v + axis.slide * qd;
      joint.a = joint.a + axis.slide * qdd;
    }
  }
  if (link.is_floating()) joint.a = joint.a + cross(joint.w, joint.v);
  return joint;
}

/// Angular velocity and acceleration of a link, world axes.
template <class Scalar>
struct WorldTurning {
  Vector3<Scalar> w, wd;
};

/// A point as a link sees it that carries a joint before it, world axes: its place from the origin
/// behind this joint, and the velocity and acceleration of its frame.
template <class Scalar>
struct SeenPoint {
  Vector3<Scalar> r, v, w, a, wd;
};

/// Point as the joint's carrier sees it, if the link behind the joint sees it as `beyond`.
template <class Scalar>
SeenPoint<Scalar> seen_by_carrier(const WorldJoint<Scalar>& joint, SeenPoint<Scalar> beyond) {
  const Vector3<Scalar> swung = cross(joint.w, beyond.r);
  SeenPoint<Scalar> seen = beyond;
  seen.v = beyond.v + swung + joint.v;
  seen.w = beyond.w + joint.w;
  seen.a = beyond.a + cross(joint.w, beyond.v * Scalar(2.0) + swung) + cross(joint.wd, beyond.r) +
           joint.a;
  seen.wd = beyond.wd + cross(joint.w, beyond.w) + joint.wd;
  return seen;
}

/// Motion by one degree of freedom: linear over angular.
template <class Scalar>
struct PointChange {
  Vector3<Scalar> linear, angular;
};

/// Columns of the derivatives for one degree of freedom. A displacement turns what the carrier
/// sees, and moves the point to where the motion of the carrier is another. A velocity adds to what
/// the carrier sees, and turns with the joint.
template <class Scalar>
struct PointColumns {
  PointChange<Scalar> dv_dq, J, da_dq, da_dqd;
};

template <class Scalar>
PointColumns<Scalar> columns_of_slide(const JointAxis<Scalar>& axis,
                                      const WorldJoint<Scalar>& joint,
                                      const WorldTurning<Scalar>& carrier,
                                      const Matrix3<Scalar>& U) {
  const Vector3<Scalar>& l = axis.slide;
  const Vector3<Scalar> swept = cross(carrier.w, l);
  Vector3<Scalar> by_qd = swept * Scalar(2.0);
  if (joint.is_compound) by_qd = by_qd + cross(joint.w, l);
  return {{swept, {}}, {l, {}}, {U * l, {}}, {by_qd, {}}};
}

template <class Scalar>
PointColumns<Scalar> columns_of_turn(const JointAxis<Scalar>& axis, const WorldJoint<Scalar>& joint,
                                     const WorldTurning<Scalar>& carrier, const Matrix3<Scalar>& U,
                                     const SeenPoint<Scalar>& seen) {
  const Scalar two(2.0);
  const Vector3<Scalar>& e = axis.turn;
  const Vector3<Scalar> J = cross(e, seen.r);
  const Vector3<Scalar> turned_v = cross(e, seen.v);
  const Vector3<Scalar> turned_w = cross(e, seen.w);
  const Vector3<Scalar> swept = cross(carrier.w, J);
  PointColumns<Scalar> columns;
  columns.J = {J, e};
  columns.dv_dq = {turned_v + swept, turned_w};
  columns.da_dq = {cross(e, seen.a) + U * J + cross(carrier.w, turned_v * two),
                   cross(e, seen.wd) + cross(carrier.w, turned_w)};
  columns.da_dqd = {(swept + turned_v) * two, cross(carrier.w, e) + turned_w};
  if (joint.is_compound) {
    const Vector3<Scalar> across = cross(joint.w, e);
    columns.da_dqd = {columns.da_dqd.linear + cross(across, seen.r) - cross(e, joint.v),
                      columns.da_dqd.angular + across};
  }
  return columns;
}

template <class Scalar>
void add_column(const PointChange<Scalar>& change, std::size_t first_row,
                const JointAxis<Scalar>& axis, DenseMatrix<Scalar>& matrix) {
  std::size_t row = first_row;
  for (const Vector3<Scalar>& part : {change.linear, change.angular}) {
    for (const Scalar& entry : {part.x, part.y, part.z}) {
      Scalar& sum = matrix(row++, axis.column);
      sum = sum + axis.multiplier * entry;
    }
  }
}

template <class Scalar>
std::vector<WorldTurning<Scalar>> world_turning(const Tree<Scalar>& tree,
                                                const std::vector<WorldJoint<Scalar>>& joints) {
  std::vector<WorldTurning<Scalar>> links;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "turning");
    const WorldTurning<Scalar> carrier =
        link.parent < 0 ? WorldTurning<Scalar>{} : links[static_cast<std::size_t>(link.parent)];
    links.push_back(
        {carrier.w + joints[i].w, carrier.wd + cross(carrier.w, joints[i].w) + joints[i].wd});
  }
  return links;
}

/// Derivatives of all operational points: inward from each, in world axes. The effect of a joint on
/// a point follows from the point as its carrier sees it and from the turning of the carrier. No
/// position or velocity in the world is subtracted from another.
template <class Scalar>
PointDerivatives<Scalar> point_motion_derivatives(const Tree<Scalar>& tree,
                                                  const std::vector<JointTransform<Scalar>>& X,
                                                  const JointRates<Scalar>& rates) {
  const auto poses = world_poses(tree, X);
  std::vector<WorldJoint<Scalar>> joints;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    joints.push_back(world_joint(tree.links[i], poses[i].R, rates));
  }
  const auto turning = world_turning(tree, joints);
  const DenseMatrix<Scalar> none(6 * tree.operational_points.size(),
                                 static_cast<std::size_t>(tree.nv));
  PointDerivatives<Scalar> result{none, none, none, none};
  std::size_t row = 0;
  for (const TreePoint<Scalar>& point : tree.operational_points) {
    SeenPoint<Scalar> seen;
    seen.r = point_pose(poses, point).step;
    for (int at = point.link; at >= 0;) {
      const auto i = static_cast<std::size_t>(at);
      const TreeLink<Scalar>& link = tree.links[i];
      section(link, i, "derivatives");
      const WorldTurning<Scalar> carrier =
          link.parent < 0 ? WorldTurning<Scalar>{} : turning[static_cast<std::size_t>(link.parent)];
      const Matrix3<Scalar> U = angular_matrix(carrier.w, carrier.wd).matrix();
      seen = seen_by_carrier(joints[i], seen);
      for (const JointAxis<Scalar>& axis : joints[i].axes) {
        const PointColumns<Scalar> columns =
            axis.turns ? columns_of_turn(axis, joints[i], carrier, U, seen)
                       : columns_of_slide(axis, joints[i], carrier, U);
        add_column(columns.dv_dq, row, axis, result.dv_dq);
        add_column(columns.J, row, axis, result.J);
        add_column(columns.da_dq, row, axis, result.da_dq);
        add_column(columns.da_dqd, row, axis, result.da_dqd);
      }
      seen.r = seen.r + poses[i].step;
      at = link.parent;
    }
    row += 6;
  }
  return result;
}

}  // namespace treeline
