#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "description/rotation.hpp"

namespace treeline {

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
