#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace treeline {

template <class Scalar>
struct SinCos {
  Scalar sin, cos;
};

/// Sine and cosine, in the precision of `Scalar`, of an angle in radians that a file gave as a
/// double. An angle within 1e-14 of a multiple of pi/2, relative to itself, is taken as exactly
/// that many quarter turns: nobody who writes 1.5707963267948966 means a frame that is 6e-17 rad
/// off, and the exact 0 and +-1 are the structure that the generator lives on.
template <class Scalar>
SinCos<Scalar> sin_cos_of_file_angle(double angle) {
  using std::cos;
  using std::sin;
  constexpr double kHalfPi = 1.57079632679489661923;
  const double turns = std::nearbyint(angle / kHalfPi);
  if (std::abs(angle - turns * kHalfPi) <= 1e-14 * std::abs(angle)) {
    constexpr std::array<int, 4> kSine{0, 1, 0, -1};
    const auto quarter = static_cast<std::size_t>(std::fmod(std::fmod(turns, 4.0) + 4.0, 4.0));
    return {Scalar(kSine[quarter]), Scalar(kSine[(quarter + 1) % 4])};
  }
  return {Scalar(sin(Scalar(angle))), Scalar(cos(Scalar(angle)))};
}

/// R = Rz(yaw) Ry(pitch) Rx(roll) of URDF's fixed-axis roll, pitch, yaw: turns components in the
/// child's axes into the parent's. Quarter turns are exact, see `sin_cos_of_file_angle`.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 3> rotation_from_rpy(const std::array<double, 3>& rpy) {
  const auto [sr, cr] = sin_cos_of_file_angle<Scalar>(rpy[0]);
  const auto [sp, cp] = sin_cos_of_file_angle<Scalar>(rpy[1]);
  const auto [sy, cy] = sin_cos_of_file_angle<Scalar>(rpy[2]);
  Eigen::Matrix<Scalar, 3, 3> R;
  R(0, 0) = cy * cp;
  R(0, 1) = cy * sp * sr - sy * cr;
  R(0, 2) = cy * sp * cr + sy * sr;
  R(1, 0) = sy * cp;
  R(1, 1) = sy * sp * sr + cy * cr;
  R(1, 2) = sy * sp * cr - cy * sr;
  R(2, 0) = -sp;
  R(2, 1) = cp * sr;
  R(2, 2) = cp * cr;
  return R;
}

/// The unit vector along a nonzero axis from a file, normalised in the precision of `Scalar`.
/// Components below 1e-14 of the largest are rounding and become exactly 0.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> unit_axis(const std::array<double, 3>& axis) {
  using std::sqrt;
  double largest = 0;
  for (const double component : axis) largest = std::max(largest, std::abs(component));
  Eigen::Matrix<Scalar, 3, 1> unit;
  int components = 0;
  for (int i = 0; i < 3; ++i) {
    const double component = axis[static_cast<std::size_t>(i)];
    const bool counts = std::abs(component) > 1e-14 * largest;
    components += counts ? 1 : 0;
    unit(i) = counts ? Scalar(component) : Scalar(0);
  }
  if (components == 1) return unit / Scalar(largest);
  return unit / Scalar(sqrt(unit.squaredNorm()));
}

}  // namespace treeline
