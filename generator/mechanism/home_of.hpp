#pragma once

#include <algorithm>

#include "mechanism/coordinate.hpp"

namespace treeline {

/// A value to begin with, rad or m: within the limits, and as near as they permit to the one that
/// does not displace the joint.
inline double home_of(const Coordinate& coordinate) {
  return std::min(std::max(coordinate.neutral(), coordinate.lower), coordinate.upper);
}

}  // namespace treeline
