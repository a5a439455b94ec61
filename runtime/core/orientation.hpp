#pragma once
// Orientations: rotation matrices (row-major, frame to world), unit quaternions (x, y, z, w) and
// rotation vectors (axis times angle, rad). C++17, freestanding: the arctangent is here because no
// library is.

#include "core/sin_cos.hpp"
#include "core/square_root.hpp"

namespace treeline::core {

namespace steps {

/// atan(t) / t as a function of t^2 for |t| <= tan(pi/16): Taylor's series, remainder below 1e-17,
/// in float below 1e-8.
template <class Real>
constexpr Real arctangent_ratio(Real square) noexcept {
  constexpr int kLast = (sizeof(Real) < sizeof(double)) ? 4 : 11;
  Real sum = Real(0);
  for (int k = kLast; k >= 0; --k) {
    sum = (Real(1) / static_cast<Real>((2 * k) + 1)) - (square * sum);
  }
  return sum;
}

template <class Real>
constexpr void cross(const Real (&a)[3], const Real (&b)[3], Real (&c)[3]) noexcept {
  c[0] = (a[1] * b[2]) - (a[2] * b[1]);
  c[1] = (a[2] * b[0]) - (a[0] * b[2]);
  c[2] = (a[0] * b[1]) - (a[1] * b[0]);
}

template <class Real>
constexpr Real squared_norm(const Real (&v)[3]) noexcept {
  return (v[0] * v[0]) + (v[1] * v[1]) + (v[2] * v[2]);
}

}  // namespace steps

/// R = 1 + 2 (w [v]x + [v]x [v]x), no normalisation.
template <class Real>
constexpr void rotation_from_quaternion(const Real (&q)[4], Real (&R)[9]) noexcept {
  const Real x = q[0];
  const Real y = q[1];
  const Real z = q[2];
  const Real w = q[3];
  R[0] = Real(1) - (Real(2) * ((y * y) + (z * z)));
  R[1] = Real(2) * ((x * y) - (w * z));
  R[2] = Real(2) * ((x * z) + (w * y));
  R[3] = Real(2) * ((x * y) + (w * z));
  R[4] = Real(1) - (Real(2) * ((x * x) + (z * z)));
  R[5] = Real(2) * ((y * z) - (w * x));
  R[6] = Real(2) * ((x * z) - (w * y));
  R[7] = Real(2) * ((y * z) + (w * x));
  R[8] = Real(1) - (Real(2) * ((x * x) + (y * y)));
}

/// The unit quaternion of a rotation matrix, w >= 0. Divides by the largest of the four components
/// (Shepperd), so that no accuracy is lost at any angle.
template <class Real>
inline void quaternion_from_rotation(const Real (&R)[9], Real (&q)[4]) noexcept {
  const Real squares[4] = {Real(1) + R[0] - R[4] - R[8], Real(1) - R[0] + R[4] - R[8],
                           Real(1) - R[0] - R[4] + R[8], Real(1) + R[0] + R[4] + R[8]};
  int largest = 0;
  for (int i = 1; i < 4; ++i) {
    largest = (squares[i] > squares[largest]) ? i : largest;
  }
  const Real twice = square_root(squares[largest]);  // the largest component
  const Real scale = Real(0.5) / twice;
  // 4 q_i q_j
  const Real products[4][4] = {{squares[0], R[1] + R[3], R[2] + R[6], R[7] - R[5]},
                               {R[1] + R[3], squares[1], R[5] + R[7], R[2] - R[6]},
                               {R[2] + R[6], R[5] + R[7], squares[2], R[3] - R[1]},
                               {R[7] - R[5], R[2] - R[6], R[3] - R[1], squares[3]}};
  for (int i = 0; i < 4; ++i) {
    q[i] = (i == largest) ? (Real(0.5) * twice) : (products[largest][i] * scale);
  }
  const Real sign = (q[3] < Real(0)) ? Real(-1) : Real(1);
  for (Real& component : q) {
    component *= sign;
  }
}

/// Axis times angle, angle in [0, pi], of a unit quaternion. tan(angle/4) = |v| / (1 + w) is halved
/// twice more by tan(a/2) = tan(a) / (1 + sqrt(1 + tan(a)^2)).
template <class Real>
inline void rotation_vector_from_quaternion(const Real (&q)[4], Real (&vector)[3]) noexcept {
  const Real sign = (q[3] < Real(0)) ? Real(-1) : Real(1);
  const Real w = sign * q[3];
  Real ratio = sign / (Real(1) + w);
  const Real axis[3] = {q[0], q[1], q[2]};
  const Real square = steps::squared_norm(axis);
  for (int i = 0; i < 2; ++i) {
    ratio /= Real(1) + square_root(Real(1) + (square * ratio * ratio));
  }
  const Real factor = Real(16) * ratio * steps::arctangent_ratio<Real>(square * ratio * ratio);
  for (int i = 0; i < 3; ++i) {
    vector[i] = factor * q[i];
  }
}

/// The rotation about `vector` by its length, through the quaternion. Near zero sin(angle/2)/angle
/// is its series.
template <class Real>
inline void rotation_from_vector(const Real (&vector)[3], Real (&R)[9]) noexcept {
  const Real square = steps::squared_norm(vector);
  const Real angle = square_root(square);
  Real s;
  Real c;
  sin_cos(Real(0.5) * angle, s, c);
  const bool small = angle < Real(1e-4);
  const Real half_ratio = small ? (Real(0.5) - (square / Real(48))) : (s / angle);
  const Real q[4] = {half_ratio * vector[0], half_ratio * vector[1], half_ratio * vector[2], c};
  rotation_from_quaternion(q, R);
}

/// Orientation error in world axes: the rotation vector that turns `R` into `R_wanted`,
/// R_wanted = exp([error]x) R. Exact at any angle up to pi, linear for small ones.
template <class Real>
inline void orientation_error(const Real (&R)[9], const Real (&R_wanted)[9],
                              Real (&error)[3]) noexcept {
  Real difference[9];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      difference[(3 * i) + j] = (R_wanted[3 * i] * R[3 * j]) +
                                (R_wanted[(3 * i) + 1] * R[(3 * j) + 1]) +
                                (R_wanted[(3 * i) + 2] * R[(3 * j) + 2]);
    }
  }
  Real q[4];
  quaternion_from_rotation(difference, q);
  rotation_vector_from_quaternion(q, error);
}

/// Wanted pose less actual pose, linear over angular, world axes: m and rad.
template <class Real>
inline void pose_error(const Real (&position)[3], const Real (&R)[9],
                       const Real (&position_wanted)[3], const Real (&R_wanted)[9],
                       Real (&error)[6]) noexcept {
  Real angular[3];
  orientation_error(R, R_wanted, angular);
  for (int i = 0; i < 3; ++i) {
    error[i] = position_wanted[i] - position[i];
    error[3 + i] = angular[i];
  }
}

}  // namespace treeline::core
