#pragma once

#include "interpreter/types.hpp"

namespace treeline::interpreter {

/// a x b.
template <class Scalar>
Vector3<Scalar> cross(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {a(1) * b(2) - a(2) * b(1), a(2) * b(0) - a(0) * b(2), a(0) * b(1) - a(1) * b(0)};
}

/// [a]x, the matrix with [a]x b = a x b.
template <class Scalar>
Matrix3<Scalar> cross_matrix(const Vector3<Scalar>& a) {
  Matrix3<Scalar> m;
  m << Scalar(0), -a(2), a(1), a(2), Scalar(0), -a(0), -a(1), a(0), Scalar(0);
  return m;
}

/// X = [R 0; [p]x R  R] (Chang eq. 3.5): maps a force at a frame's origin, in its axes, to the
/// frame in which it has rotation `R` and origin `p`. X^T maps motions in the opposite direction.
template <class Scalar>
Matrix6<Scalar> force_transform(const Matrix3<Scalar>& R, const Vector3<Scalar>& p) {
  Matrix6<Scalar> X = Matrix6<Scalar>::Zero();
  X.template topLeftCorner<3, 3>() = R;
  X.template bottomLeftCorner<3, 3>() = cross_matrix(p) * R;
  X.template bottomRightCorner<3, 3>() = R;
  return X;
}

/// I = [m 1  -m[c]x; m[c]x  J] (Chang eq. 3.6) at a frame's origin, from mass, centre of mass in
/// the frame, and rotational inertia about the frame's origin.
template <class Scalar>
Matrix6<Scalar> spatial_inertia(const Scalar& mass, const Vector3<Scalar>& c,
                                const Matrix3<Scalar>& J) {
  const Matrix3<Scalar> mc = cross_matrix(Vector3<Scalar>(mass * c));
  Matrix6<Scalar> I;
  I.template topLeftCorner<3, 3>() = mass * Matrix3<Scalar>::Identity();
  I.template topRightCorner<3, 3>() = -mc;
  I.template bottomLeftCorner<3, 3>() = mc;
  I.template bottomRightCorner<3, 3>() = J;
  return I;
}

/// The linear, upper half of a spatial vector.
template <class Scalar>
Vector3<Scalar> linear(const Vector6<Scalar>& x) {
  return x.template head<3>();
}

/// The angular, lower half of a spatial vector.
template <class Scalar>
Vector3<Scalar> angular(const Vector6<Scalar>& x) {
  return x.template tail<3>();
}

/// [linear; angular].
template <class Scalar>
Vector6<Scalar> stack(const Vector3<Scalar>& linear_part, const Vector3<Scalar>& angular_part) {
  Vector6<Scalar> x;
  x.template head<3>() = linear_part;
  x.template tail<3>() = angular_part;
  return x;
}

}  // namespace treeline::interpreter
