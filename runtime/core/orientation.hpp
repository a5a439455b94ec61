#pragma once
// Orientations: rotation matrices (row-major, frame to world), unit quaternions (x, y, z, w) and
// rotation vectors (axis times angle, rad), by runtime/emitted. C++17, freestanding.

#include <stdbool.h>
#include <stdint.h>

#include "core/sin_cos.hpp"
#include "core/square_root.hpp"

namespace treeline::core {

#define TL_INLINE static inline
#define TL_REAL(x) real(x)
#define TL_AS_REAL(x) static_cast<real>(x)

/// Everything of runtime/emitted/turn_motion.h.
template <class Number>
struct EmittedOrientation {
  using real = Number;
  static constexpr real TL_ZERO = real(0), TL_ONE = real(1);
  static constexpr int32_t TL_ARCTANGENT_TERMS = sizeof(real) < sizeof(double) ? 4 : 11,
                           TL_SERIES_TERMS = sizeof(real) < sizeof(double) ? 9 : 15;

  static real tl_square_root(real x) { return square_root(x); }
  static void tl_sin_cos_of(real x, real* sine, real* cosine) { sin_cos(x, *sine, *cosine); }

#include "emitted/turn_motion.h"
};

#undef TL_INLINE
#undef TL_REAL
#undef TL_AS_REAL

namespace steps {

template <class Real>
inline void cross(const Real (&a)[3], const Real (&b)[3], Real (&c)[3]) noexcept {
  EmittedOrientation<Real>::tl_cross(a, b, c);
}

template <class Real>
inline Real squared_norm(const Real (&v)[3]) noexcept {
  return EmittedOrientation<Real>::tl_squared_norm(v);
}

}  // namespace steps

/// R = 1 + 2 (w [v]x + [v]x [v]x), no normalisation.
template <class Real>
inline void rotation_from_quaternion(const Real (&q)[4], Real (&R)[9]) noexcept {
  EmittedOrientation<Real>::tl_rotation_from_quaternion(q, R);
}

/// The unit quaternion of a rotation matrix, w >= 0.
template <class Real>
inline void quaternion_from_rotation(const Real (&R)[9], Real (&q)[4]) noexcept {
  EmittedOrientation<Real>::tl_quaternion_from_rotation(R, q);
}

/// Axis times angle, angle in [0, pi], of a unit quaternion.
template <class Real>
inline void rotation_vector_from_quaternion(const Real (&q)[4], Real (&vector)[3]) noexcept {
  EmittedOrientation<Real>::tl_rotation_vector_from_quaternion(q, vector);
}

/// The rotation about `vector` by its length.
template <class Real>
inline void rotation_from_vector(const Real (&vector)[3], Real (&R)[9]) noexcept {
  EmittedOrientation<Real>::tl_rotation_from_vector(vector, R);
}

/// Orientation error in world axes: the rotation vector that turns `R` into `R_wanted`.
template <class Real>
inline void orientation_error(const Real (&R)[9], const Real (&R_wanted)[9],
                              Real (&error)[3]) noexcept {
  EmittedOrientation<Real>::tl_orientation_error(R, R_wanted, error);
}

/// Wanted pose less actual pose, linear over angular, world axes: m and rad.
template <class Real>
inline void pose_error(const Real (&position)[3], const Real (&R)[9],
                       const Real (&position_wanted)[3], const Real (&R_wanted)[9],
                       Real (&error)[6]) noexcept {
  EmittedOrientation<Real>::tl_pose_error(position, R, position_wanted, R_wanted, error);
}

}  // namespace treeline::core
