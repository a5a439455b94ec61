#pragma once

#include <array>

#include "functions/quantity.hpp"

namespace treeline::bounds {

/// The bodies that an argument may be of: of mass up to `mass` (kg), matter within `reach` (m) of
/// the origin.
struct BodyRange {
  double mass = 0, reach = 0;
  /// Whether each has a tenth of the mass or more, and of the reach as its least radius of
  /// gyration, so that it alone can be a link.
  bool whole = false;
};

/// Share of the mass and of the reach that a whole body has at least.
inline constexpr double kLeastShare = 0.1;

/// The ten inertial parameters of a body of this range: every choice of ten numbers from -1 to 1
/// gives one.
std::array<double, kInertialParameters> body_of(
    const BodyRange& range, const std::array<double, kInertialParameters>& choice);

}  // namespace treeline::bounds
