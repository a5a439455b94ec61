#pragma once

namespace treeline {

// Small linear algebra with an explicit order of operations. What is traced is what is emitted, so
// a product that a library would form and discard would be an operation of the emitted code.

template <class Scalar>
struct Vector3 {
  Scalar x{}, y{}, z{};
};

template <class Scalar>
Vector3<Scalar> operator+(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Scalar>
Vector3<Scalar> operator-(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Scalar>
Vector3<Scalar> operator-(const Vector3<Scalar>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class Scalar>
Vector3<Scalar> operator*(const Vector3<Scalar>& a, const Scalar& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class Scalar>
Scalar dot(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Scalar>
Vector3<Scalar> cross(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Scalar>
struct Matrix3 {
  Vector3<Scalar> row_x, row_y, row_z;
};

template <class Scalar>
Vector3<Scalar> operator*(const Matrix3<Scalar>& A, const Vector3<Scalar>& v) {
  return {dot(A.row_x, v), dot(A.row_y, v), dot(A.row_z, v)};
}
template <class Scalar>
Vector3<Scalar> transposed_times(const Matrix3<Scalar>& A, const Vector3<Scalar>& v) {
  return {A.row_x.x * v.x + A.row_y.x * v.y + A.row_z.x * v.z,
          A.row_x.y * v.x + A.row_y.y * v.y + A.row_z.y * v.z,
          A.row_x.z * v.x + A.row_y.z * v.y + A.row_z.z * v.z};
}
template <class Scalar>
Matrix3<Scalar> transposed(const Matrix3<Scalar>& A) {
  return {{A.row_x.x, A.row_y.x, A.row_z.x},
          {A.row_x.y, A.row_y.y, A.row_z.y},
          {A.row_x.z, A.row_y.z, A.row_z.z}};
}
template <class Scalar>
Matrix3<Scalar> identity3() {
  return {{Scalar(1), Scalar(0), Scalar(0)},
          {Scalar(0), Scalar(1), Scalar(0)},
          {Scalar(0), Scalar(0), Scalar(1)}};
}

/// Symmetric 3x3 matrix, six numbers.
template <class Scalar>
struct Symmetric3 {
  Scalar xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
};

template <class Scalar>
Symmetric3<Scalar> operator+(const Symmetric3<Scalar>& A, const Symmetric3<Scalar>& B) {
  return {A.xx + B.xx, A.xy + B.xy, A.xz + B.xz, A.yy + B.yy, A.yz + B.yz, A.zz + B.zz};
}
template <class Scalar>
Vector3<Scalar> operator*(const Symmetric3<Scalar>& A, const Vector3<Scalar>& v) {
  return {A.xx * v.x + A.xy * v.y + A.xz * v.z, A.xy * v.x + A.yy * v.y + A.yz * v.z,
          A.xz * v.x + A.yz * v.y + A.zz * v.z};
}

/// Q A Q^T.
template <class Scalar>
Symmetric3<Scalar> congruent(const Matrix3<Scalar>& Q, const Symmetric3<Scalar>& A) {
  const Vector3<Scalar> x = A * Q.row_x;
  const Vector3<Scalar> y = A * Q.row_y;
  const Vector3<Scalar> z = A * Q.row_z;
  return {dot(Q.row_x, x), dot(Q.row_x, y), dot(Q.row_x, z),
          dot(Q.row_y, y), dot(Q.row_y, z), dot(Q.row_z, z)};
}
/// Q A Q^T of a rotation Q, in 59 operations instead of the 75 of `congruent`: the trace
/// does not change, and A_zz times the unit matrix does not turn.
template <class Scalar>
Symmetric3<Scalar> turned(const Matrix3<Scalar>& Q, const Symmetric3<Scalar>& A) {
  const Scalar dx = A.xx - A.zz;
  const Scalar dy = A.yy - A.zz;
  const auto times = [&](const Vector3<Scalar>& q) {
    return Vector3<Scalar>{dx * q.x + A.xy * q.y + A.xz * q.z, A.xy * q.x + dy * q.y + A.yz * q.z,
                           A.xz * q.x + A.yz * q.y};
  };
  const Vector3<Scalar> x = times(Q.row_x);
  const Vector3<Scalar> y = times(Q.row_y);
  const Scalar xx = dot(Q.row_x, x);
  const Scalar yy = dot(Q.row_y, y);
  return {xx + A.zz, dot(Q.row_x, y), dot(Q.row_z, x),
          yy + A.zz, dot(Q.row_z, y), dx + dy - xx - yy + A.zz};
}
/// Q A Q^T of a rotation Q and a matrix without symmetry, by the halves A + A^T and A - A^T, of
/// which the second is a vector.
template <class Scalar>
Matrix3<Scalar> turned(const Matrix3<Scalar>& Q, const Matrix3<Scalar>& A) {
  const Scalar half(0.5);
  const Symmetric3<Scalar> even =
      turned(Q, Symmetric3<Scalar>{A.row_x.x, half * (A.row_x.y + A.row_y.x),
                                   half * (A.row_x.z + A.row_z.x), A.row_y.y,
                                   half * (A.row_y.z + A.row_z.y), A.row_z.z});
  const Vector3<Scalar> odd =
      Q * Vector3<Scalar>{half * (A.row_z.y - A.row_y.z), half * (A.row_x.z - A.row_z.x),
                          half * (A.row_y.x - A.row_x.y)};
  return {{even.xx, even.xy - odd.z, even.xz + odd.y},
          {even.xy + odd.z, even.yy, even.yz - odd.x},
          {even.xz - odd.y, even.yz + odd.x, even.zz}};
}

}  // namespace treeline
