#pragma once

#include <cmath>

#include "interpreter/model.hpp"

namespace treeline::interpreter {

/// Pose of a joint's link relative to the parent, and the directions in which it can move.
template <class Scalar>
struct JointState {
  Matrix3<Scalar> R;        ///< link's frame in the parent's frame
  Vector3<Scalar> p;        ///< link's origin in the parent's frame
  JointMatrix<Scalar> S;    ///< relative velocity = S qd, at the link's origin, in its axes
  Vector6<Scalar> Sdot_qd;  ///< due to an S whose components change with q
};

/// The joint's own coordinates, from q. For a mimic joint they follow from its leader's.
template <class Scalar>
JointVector<Scalar> joint_position(const Body<Scalar>& body, VectorArg<Scalar> q) {
  JointVector<Scalar> own = q.segment(body.q, position_count(body.kind));
  if (body.mimics) own = (body.multiplier * own).array() + body.offset;
  return own;
}

/// The joint's own velocities from qd, or accelerations from qdd.
template <class Scalar>
JointVector<Scalar> joint_velocity(const Body<Scalar>& body, VectorArg<Scalar> qd) {
  JointVector<Scalar> own = qd.segment(body.v, velocity_count(body.kind));
  if (body.mimics) own *= body.multiplier;
  return own;
}

/// R = 1 + 2 (w [u]x + [u]x [u]x) / |(u, w)|^2 for the quaternion (u, w) of any length. The
/// quaternion 0 does not rotate.
template <class Scalar>
Matrix3<Scalar> rotation_from_quaternion(const Vector3<Scalar>& u, const Scalar& w) {
  const Matrix3<Scalar> U = cross_matrix(u);
  const Scalar square = u.dot(u) + w * w;
  if (square == Scalar(0)) return Matrix3<Scalar>::Identity();
  const Scalar twice = Scalar(2) / square;
  return Matrix3<Scalar>::Identity() + twice * Matrix3<Scalar>(w * U + U * U);
}

/// R = 1 + sin [n]x + (1 - cos) [n]x [n]x, the rotation by `angle` about the unit vector n.
template <class Scalar>
Matrix3<Scalar> rotation_about(const Vector3<Scalar>& n, const Scalar& angle) {
  using std::cos;
  using std::sin;
  const Matrix3<Scalar> N = cross_matrix(n);
  return Matrix3<Scalar>::Identity() + Scalar(sin(angle)) * N +
         Scalar(Scalar(1) - cos(angle)) * (N * N);
}

/// Shortest rotation of z onto the unit vector n (for -z half a turn about x). Its first two
/// columns are the directions in which a planar joint with this normal moves.
template <class Scalar>
Matrix3<Scalar> planar_directions(const Vector3<Scalar>& n) {
  const Scalar nx2_ny2 = n(0) * n(0) + n(1) * n(1);
  Matrix3<Scalar> R = Matrix3<Scalar>::Identity();
  if (nx2_ny2 == Scalar(0)) {
    if (n(2) < Scalar(0)) R.diagonal() << Scalar(1), Scalar(-1), Scalar(-1);
    return R;
  }
  // R = 1 + [k]x + [k]x [k]x / (1 + n_z) with k = z x n. 1 + n_z is computed without cancellation
  // near -z.
  const Scalar one_plus_z =
      n(2) < Scalar(0) ? Scalar(nx2_ny2 / (Scalar(1) - n(2))) : Scalar(Scalar(1) + n(2));
  const Matrix3<Scalar> K = cross_matrix(Vector3<Scalar>(-n(1), n(0), Scalar(0)));
  return R + K + K * K / one_plus_z;
}

namespace detail {

template <class Scalar>
JointState<Scalar> planar_joint(const Vector3<Scalar>& axis, const JointVector<Scalar>& q,
                                const JointVector<Scalar>& qd) {
  const Matrix3<Scalar> plane = planar_directions(axis);
  JointState<Scalar> joint;
  joint.R = rotation_about(axis, q(2));
  joint.p = plane.col(0) * q(0) + plane.col(1) * q(1);
  joint.S = JointMatrix<Scalar>::Zero(6, 3);
  // Columns 1 and 2 are fixed in the parent's axes and so rotate backward in the link's axes.
  joint.S.template block<3, 2>(0, 0) = joint.R.transpose() * plane.template leftCols<2>();
  joint.S.template block<3, 1>(3, 2) = axis;
  const Vector3<Scalar> sliding = joint.S.template block<3, 2>(0, 0) * qd.template head<2>();
  joint.Sdot_qd = stack<Scalar>(-qd(2) * cross(axis, sliding), Vector3<Scalar>::Zero());
  return joint;
}

/// The joint's motion in its own frame, before the placement on the parent.
template <class Scalar>
JointState<Scalar> moved_joint(const Body<Scalar>& body, const JointVector<Scalar>& q,
                               const JointVector<Scalar>& qd) {
  if (body.kind == JointKind::planar) return planar_joint(body.axis, q, qd);
  JointState<Scalar> joint{Matrix3<Scalar>::Identity(), Vector3<Scalar>::Zero(),
                           JointMatrix<Scalar>::Zero(6, velocity_count(body.kind)),
                           Vector6<Scalar>::Zero()};
  switch (body.kind) {
    case JointKind::revolute:
      joint.R = rotation_about(body.axis, q(0));
      joint.S.template bottomRows<3>() = body.axis;
      break;
    case JointKind::prismatic:
      joint.p = body.axis * q(0);
      joint.S.template topRows<3>() = body.axis;
      break;
    case JointKind::floating:
      joint.R = rotation_from_quaternion<Scalar>(q.template segment<3>(3), q(6));
      joint.p = q.template head<3>();
      joint.S.setIdentity();
      break;
    case JointKind::spherical:
      joint.R = rotation_from_quaternion<Scalar>(q.template head<3>(), q(3));
      joint.S.template bottomRows<3>().setIdentity();
      break;
    case JointKind::fixed:
    case JointKind::planar:
      break;
  }
  return joint;
}

}  // namespace detail

/// The joint model of Chang 3.2 for a joint's own coordinates and velocities.
template <class Scalar>
JointState<Scalar> joint_model(const Body<Scalar>& body, const JointVector<Scalar>& q,
                               const JointVector<Scalar>& qd) {
  JointState<Scalar> joint = detail::moved_joint(body, q, qd);
  joint.p = body.p_parent_joint + body.R_parent_joint * joint.p;
  joint.R = body.R_parent_joint * joint.R;
  return joint;
}

/// dq/dt of a motion with velocity qd. It differs from qd for joints with a quaternion.
template <class Scalar>
Vector<Scalar> position_derivative(const Model<Scalar>& model, VectorArg<Scalar> q,
                                   VectorArg<Scalar> qd) {
  Vector<Scalar> derivative(model.nq);
  for (const auto& body : model.bodies) {
    if (body.mimics) continue;
    const int n = velocity_count(body.kind);
    if (body.kind != JointKind::floating && body.kind != JointKind::spherical) {
      derivative.segment(body.q, n) = qd.segment(body.v, n);
      continue;
    }
    int at = body.q;
    if (body.kind == JointKind::floating) {
      derivative.template segment<3>(at) =
          rotation_from_quaternion<Scalar>(q.template segment<3>(at + 3), q(at + 6)) *
          qd.template segment<3>(body.v);
      at += 3;
    }
    const Vector3<Scalar> u = q.template segment<3>(at);
    const Vector3<Scalar> w = qd.template segment<3>(body.v + n - 3);
    const Scalar half = Scalar(1) / Scalar(2);
    derivative.template segment<3>(at) = half * (q(at + 3) * w + cross(u, w));
    derivative(at + 3) = -half * u.dot(w);
  }
  return derivative;
}

}  // namespace treeline::interpreter
