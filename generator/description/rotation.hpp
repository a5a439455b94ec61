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

/// The number of quarter turns nearest to an angle.
struct QuarterTurns {
  double turns = 0;      ///< whole
  double as_double = 0;  ///< the double nearest to turns * pi/2
  double off = 0;        ///< angle - turns * pi/2, rad
};

inline QuarterTurns nearest_quarter_turns(double angle) {
  constexpr long double kHalfPi = 1.570796326794896619231321691639751442L;
  const double turns = std::nearbyint(angle / static_cast<double>(kHalfPi));
  const long double exact = static_cast<long double>(turns) * kHalfPi;
  return {turns, static_cast<double>(exact), static_cast<double>(angle - exact)};
}

/// Sine and cosine, in the precision of `Scalar`, of an angle in radians that a file gave as a
/// double. The double that is nearest to a multiple of pi/2 is exactly that many quarter turns:
/// nobody who writes 1.5707963267948966 means a frame that is 6e-17 rad off.
template <class Scalar>
SinCos<Scalar> sin_cos_of_file_angle(double angle) {
  using std::cos;
  using std::sin;
  const QuarterTurns nearest = nearest_quarter_turns(angle);
  if (angle == nearest.as_double) {
    constexpr std::array<int, 4> kSine{0, 1, 0, -1};
    const auto quarter =
        static_cast<std::size_t>(std::fmod(std::fmod(nearest.turns, 4.0) + 4.0, 4.0));
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

/// The unit vector along a nonzero axis from a file, normalised in the precision of `Scalar`; one
/// along a coordinate axis is exact.
template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> unit_axis(const std::array<double, 3>& axis) {
  using std::abs;
  using std::sqrt;
  const Eigen::Matrix<Scalar, 3, 1> given{Scalar(axis[0]), Scalar(axis[1]), Scalar(axis[2])};
  const auto components = std::count_if(axis.begin(), axis.end(), [](double x) { return x != 0; });
  if (components == 1) return given / Scalar(given.cwiseAbs().maxCoeff());
  return given / Scalar(sqrt(given.squaredNorm()));
}

/// Roll, pitch and yaw in radians for which `rotation_from_rpy` is R. Near a pitch of a quarter
/// turn the yaw is any; the roll that follows from it makes up for it. Quarter turns stay exact.
inline std::array<double, 3> rpy_from_rotation(const Eigen::Matrix3d& R) {
  const double yaw = std::atan2(R(1, 0), R(0, 0));
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  const auto [s, c] = sin_cos_of_file_angle<double>(yaw);
  const double roll = std::atan2(s * R(0, 2) - c * R(1, 2), c * R(1, 1) - s * R(0, 1));
  return {roll, pitch, yaw};
}

}  // namespace treeline
