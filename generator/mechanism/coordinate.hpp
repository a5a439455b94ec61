#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace treeline {

/// What an entry of q measures. Quaternions are x, y, z, w, of unit length.
enum class CoordinateKind { angle, displacement, quaternion_xyz, quaternion_w };

/// One entry of q, as the contract of the emitted code lists it.
struct Coordinate {
  std::string joint;
  std::string meaning;  ///< in words, with unit: "angle, rad", "displacement, m", "quaternion x"
  CoordinateKind kind = CoordinateKind::angle;
  double lower = -std::numeric_limits<double>::infinity();  ///< rad, m
  double upper = std::numeric_limits<double>::infinity();   ///< rad, m

  [[nodiscard]] bool is_angle() const { return kind == CoordinateKind::angle; }
  [[nodiscard]] bool is_of_quaternion() const {
    return kind == CoordinateKind::quaternion_xyz || kind == CoordinateKind::quaternion_w;
  }
  /// Where the joint does not displace its link.
  [[nodiscard]] double neutral() const { return kind == CoordinateKind::quaternion_w ? 1 : 0; }
  /// Half of the range that tried states are from where there are no limits: half a turn, a metre.
  [[nodiscard]] double ordinary_reach() const { return is_angle() ? std::numbers::pi : 1; }
  /// The limits, those beyond the ordinary reach drawn in to it.
  [[nodiscard]] std::pair<double, double> ordinary_range() const {
    return {std::max(lower, -ordinary_reach()), std::min(upper, ordinary_reach())};
  }
};

}  // namespace treeline
