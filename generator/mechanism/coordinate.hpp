#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "joint/coordinate_kind.hpp"

namespace treeline {

/// One entry of q, as the contract of the emitted code lists it.
struct Coordinate {
  std::string joint;
  std::string meaning;  ///< with unit: "angle, rad", "displacement, m", "quaternion x"
  CoordinateKind kind = CoordinateKind::angle;
  double lower = -std::numeric_limits<double>::infinity();  ///< rad, m
  double upper = std::numeric_limits<double>::infinity();   ///< rad, m

  [[nodiscard]] bool is_angle() const { return kind == CoordinateKind::angle; }
  [[nodiscard]] bool is_of_quaternion() const {
    return kind == CoordinateKind::quaternion_xyz || kind == CoordinateKind::quaternion_w;
  }
  /// Value at which the joint does not displace its link.
  [[nodiscard]] double neutral() const { return kind == CoordinateKind::quaternion_w ? 1 : 0; }
  /// Half the range from which test states are drawn if there are no limits: half a turn, or 1 m.
  [[nodiscard]] double ordinary_reach() const { return is_angle() ? std::numbers::pi : 1; }
  /// Range from which test states are drawn: the limits, where they are within the ordinary reach.
  [[nodiscard]] std::pair<double, double> ordinary_range() const {
    return {std::max(lower, -ordinary_reach()), std::min(upper, ordinary_reach())};
  }
};

/// Whether a coordinate is of the quaternion of a floating base or joint, and not of a ball joint.
inline bool turns_what_floats(const std::vector<Coordinate>& all, const Coordinate& coordinate) {
  return coordinate.is_of_quaternion() && std::ranges::any_of(all, [&](const Coordinate& other) {
           return other.joint == coordinate.joint && !other.is_of_quaternion();
         });
}

}  // namespace treeline
