#pragma once
// Orientations: rotation matrices (row-major, frame to world), unit quaternions
// (x, y, z, w) and rotation vectors (axis times angle, rad). The arctangent is here
// because no library is.

#include <stdbool.h>
#include <stdint.h>

/// atan(t) / t as a function of t^2 for |t| <= tan(pi/16): Taylor's series, remainder
/// below 1e-17, in numbers of 4 bytes below 1e-8.
TL_INLINE real tl_arctangent_ratio(real square) {
  real sum = TL_ZERO;
  for (int32_t k = TL_ARCTANGENT_TERMS; k >= 0; --k) {
    const int32_t odd = (2 * k) + 1;
    sum = (TL_ONE / TL_AS_REAL(odd)) - (square * sum);
  }
  return sum;
}

TL_INLINE void tl_cross(const real* a, const real* b, real* c) {
  c[0] = (a[1] * b[2]) - (a[2] * b[1]);
  c[1] = (a[2] * b[0]) - (a[0] * b[2]);
  c[2] = (a[0] * b[1]) - (a[1] * b[0]);
}

TL_INLINE real tl_squared_norm(const real* v) {
  return (v[0] * v[0]) + (v[1] * v[1]) + (v[2] * v[2]);
}

/// R = 1 + 2 (w [v]x + [v]x [v]x), no normalisation.
TL_INLINE void tl_rotation_from_quaternion(const real* q, real* R) {
  const real two = TL_REAL(2.0);
  const real x = q[0];
  const real y = q[1];
  const real z = q[2];
  const real w = q[3];
  R[0] = TL_ONE - (two * ((y * y) + (z * z)));
  R[1] = two * ((x * y) - (w * z));
  R[2] = two * ((x * z) + (w * y));
  R[3] = two * ((x * y) + (w * z));
  R[4] = TL_ONE - (two * ((x * x) + (z * z)));
  R[5] = two * ((y * z) - (w * x));
  R[6] = two * ((x * z) - (w * y));
  R[7] = two * ((y * z) + (w * x));
  R[8] = TL_ONE - (two * ((x * x) + (y * y)));
}

/// The unit quaternion of a rotation matrix, w >= 0. Divides by the largest of the
/// four components (Shepperd), so that no accuracy is lost at any angle.
TL_INLINE void tl_quaternion_from_rotation(const real* R, real* q) {
  const real squares[4] = {TL_ONE + R[0] - R[4] - R[8], TL_ONE - R[0] + R[4] - R[8],
      TL_ONE - R[0] - R[4] + R[8], TL_ONE + R[0] + R[4] + R[8]};
  int32_t largest = 0;
  for (int32_t i = 1; i < 4; ++i) {
    largest = (squares[i] > squares[largest]) ? i : largest;
  }
  const real twice = tl_square_root(squares[largest]);  // the largest component
  const real component = TL_REAL(0.5) * twice;
  const real scale = TL_REAL(0.5) / twice;
  // 4 q_i q_j
  const real products[4][4] = {{squares[0], R[1] + R[3], R[2] + R[6], R[7] - R[5]},
      {R[1] + R[3], squares[1], R[5] + R[7], R[2] - R[6]},
      {R[2] + R[6], R[5] + R[7], squares[2], R[3] - R[1]},
      {R[7] - R[5], R[2] - R[6], R[3] - R[1], squares[3]}};
  for (int32_t i = 0; i < 4; ++i) {
    const real other = products[largest][i] * scale;
    q[i] = (i == largest) ? component : other;
  }
  const real sign = (q[3] < TL_ZERO) ? -TL_ONE : TL_ONE;
  for (int32_t i = 0; i < 4; ++i) {
    q[i] *= sign;
  }
}

/// Axis times angle, angle in [0, pi], of a unit quaternion. tan(angle/4) = |v| / (1
/// + w) is halved twice more by tan(a/2) = tan(a) / (1 + sqrt(1 + tan(a)^2)).
TL_INLINE void tl_rotation_vector_from_quaternion(const real* q, real* vector) {
  const real sign = (q[3] < TL_ZERO) ? -TL_ONE : TL_ONE;
  const real w = sign * q[3];
  real ratio = sign / (TL_ONE + w);
  const real square = tl_squared_norm(q);
  for (int32_t i = 0; i < 2; ++i) {
    ratio /= TL_ONE + tl_square_root(TL_ONE + (square * ratio * ratio));
  }
  const real factor =
      TL_REAL(16.0) * ratio * tl_arctangent_ratio(square * ratio * ratio);
  for (int32_t i = 0; i < 3; ++i) {
    vector[i] = factor * q[i];
  }
}

/// The rotation about `vector` by its length, through the quaternion. Near zero
/// sin(angle/2)/angle is its series.
TL_INLINE void tl_rotation_from_vector(const real* vector, real* R) {
  const real square = tl_squared_norm(vector);
  const real angle = tl_square_root(square);
  real s;
  real c;
  tl_sin_cos_of(TL_REAL(0.5) * angle, &s, &c);
  const bool small = angle < TL_REAL(1e-4);
  const real ratio = small ? (TL_REAL(0.5) - (square / TL_REAL(48.0))) : (s / angle);
  const real q[4] = {ratio * vector[0], ratio * vector[1], ratio * vector[2], c};
  tl_rotation_from_quaternion(&q[0], R);
}

/// Orientation error in world axes: the rotation vector that turns R into R_wanted,
/// R_wanted = exp([error]x) R. Exact at any angle up to pi, linear for small ones.
TL_INLINE void tl_orientation_error(
    const real* R, const real* R_wanted, real* error) {
  real difference[9];
  for (int32_t i = 0; i < 3; ++i) {
    for (int32_t j = 0; j < 3; ++j) {
      difference[(3 * i) + j] = (R_wanted[3 * i] * R[3 * j]) +
          (R_wanted[(3 * i) + 1] * R[(3 * j) + 1]) +
          (R_wanted[(3 * i) + 2] * R[(3 * j) + 2]);
    }
  }
  real q[4];
  tl_quaternion_from_rotation(&difference[0], &q[0]);
  tl_rotation_vector_from_quaternion(&q[0], error);
}

/// Wanted pose less actual pose, linear over angular, world axes: m and rad.
TL_INLINE void tl_pose_error(const real* position, const real* R,
    const real* position_wanted, const real* R_wanted, real* error) {
  tl_orientation_error(R, R_wanted, &error[3]);
  for (int32_t i = 0; i < 3; ++i) {
    error[i] = position_wanted[i] - position[i];
  }
}
