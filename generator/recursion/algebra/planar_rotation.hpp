#pragma once

#include "recursion/algebra/vector3.hpp"

namespace treeline {

/// Cosine and sine of a rotation about one coordinate axis. Every rotation here is a sequence of
/// these. Quarter turns cost nothing; other angles cost 6 operations per vector and 16 per
/// symmetric matrix (a general 3x3 rotation costs 15 and 45).
template <class Scalar>
struct PlanarRotation {
  Scalar c{1.0}, s{0.0};
  [[nodiscard]] PlanarRotation inverse() const { return {c, -s}; }
};

/// Rz v.
template <class Scalar>
Vector3<Scalar> rotate_z(const PlanarRotation<Scalar>& r, const Vector3<Scalar>& v) {
  return {r.c * v.x - r.s * v.y, r.s * v.x + r.c * v.y, v.z};
}
/// Rx v.
template <class Scalar>
Vector3<Scalar> rotate_x(const PlanarRotation<Scalar>& r, const Vector3<Scalar>& v) {
  return {v.x, r.c * v.y - r.s * v.z, r.s * v.y + r.c * v.z};
}

/// The block [a, b; b2, d] of R B R^T in the plane of rotation, in 11 operations: with t = s (a -
/// d) + c (b + b2) it is [a - s t, c t - b2; c t - b, d + s t].
template <class Scalar>
void rotate_block(const PlanarRotation<Scalar>& r, Scalar& a, Scalar& b, Scalar& b2, Scalar& d) {
  const Scalar t = r.s * (a - d) + r.c * (b + b2);
  const Scalar st = r.s * t;
  const Scalar ct = r.c * t;
  a = a - st;
  d = d + st;
  const Scalar old_b = b;
  b = ct - b2;
  b2 = ct - old_b;
}
template <class Scalar>
void rotate_pair(const PlanarRotation<Scalar>& r, Scalar& first, Scalar& second) {
  const Scalar old_first = first;
  first = r.c * old_first - r.s * second;
  second = r.s * old_first + r.c * second;
}

/// Rz A Rz^T.
template <class Scalar>
Symmetric3<Scalar> rotate_z(const PlanarRotation<Scalar>& r, Symmetric3<Scalar> A) {
  Scalar yx = A.xy;
  rotate_block(r, A.xx, A.xy, yx, A.yy);
  rotate_pair(r, A.xz, A.yz);
  return A;
}
/// Rx A Rx^T.
template <class Scalar>
Symmetric3<Scalar> rotate_x(const PlanarRotation<Scalar>& r, Symmetric3<Scalar> A) {
  Scalar zy = A.yz;
  rotate_block(r, A.yy, A.yz, zy, A.zz);
  rotate_pair(r, A.xy, A.xz);
  return A;
}
/// Rz B Rz^T.
template <class Scalar>
Matrix3<Scalar> rotate_z(const PlanarRotation<Scalar>& r, Matrix3<Scalar> B) {
  rotate_block(r, B.row_x.x, B.row_x.y, B.row_y.x, B.row_y.y);
  rotate_pair(r, B.row_x.z, B.row_y.z);
  rotate_pair(r, B.row_z.x, B.row_z.y);
  return B;
}
/// Rx B Rx^T.
template <class Scalar>
Matrix3<Scalar> rotate_x(const PlanarRotation<Scalar>& r, Matrix3<Scalar> B) {
  rotate_block(r, B.row_y.y, B.row_y.z, B.row_z.y, B.row_z.z);
  rotate_pair(r, B.row_y.x, B.row_z.x);
  rotate_pair(r, B.row_x.y, B.row_x.z);
  return B;
}

/// Any rotation, as R = Rz(a) Rx(alpha) Rz(b).
template <class Scalar>
struct Rotation {
  PlanarRotation<Scalar> a, alpha, b;
};

template <class Scalar, class Turned>
Turned rotate(const Rotation<Scalar>& R, const Turned& v) {
  return rotate_z(R.a, rotate_x(R.alpha, rotate_z(R.b, v)));
}
/// R^T v for a vector, R^T A R for a matrix.
template <class Scalar, class Turned>
Turned rotate_back(const Rotation<Scalar>& R, const Turned& v) {
  return rotate_z(R.b.inverse(), rotate_x(R.alpha.inverse(), rotate_z(R.a.inverse(), v)));
}

}  // namespace treeline
