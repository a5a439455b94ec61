#pragma once

#include <limits>

#include "recursion/algebra/vector3.hpp"

namespace treeline {

/// Added to the squared length of a quaternion. It changes no length near 1, not even in float, and
/// with it the quaternion 0 does not rotate. Numbers of 50 digits have a smaller value, because
/// they would be changed by this one.
template <class Scalar>
inline constexpr double kLeastQuaternion =
    std::numeric_limits<Scalar>::digits > 64 ? 0x1p-1000 : 0x1p-100;

/// Q = 1 + 2 (w [v]x + [v]x [v]x) / |(v, w)|^2 for the quaternion (v, w) of any length: the
/// rotation of the normalized quaternion.
template <class Scalar>
Matrix3<Scalar> rotation_from_quaternion(const Scalar& x, const Scalar& y, const Scalar& z,
                                         const Scalar& w) {
  const Scalar one(1.0);
  const Scalar twice =
      Scalar(2.0) / (x * x + y * y + z * z + w * w + Scalar(kLeastQuaternion<Scalar>));
  const Scalar x2 = twice * x;
  const Scalar y2 = twice * y;
  const Scalar z2 = twice * z;
  const Scalar xx = x2 * x;
  const Scalar yy = y2 * y;
  const Scalar zz = z2 * z;
  const Scalar xy = x2 * y;
  const Scalar xz = x2 * z;
  const Scalar yz = y2 * z;
  const Scalar wx = x2 * w;
  const Scalar wy = y2 * w;
  const Scalar wz = z2 * w;
  return {{one - (yy + zz), xy - wz, xz + wy},
          {xy + wz, one - (xx + zz), yz - wx},
          {xz - wy, yz + wx, one - (xx + yy)}};
}

}  // namespace treeline
