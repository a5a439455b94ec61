#pragma once

#include <cstdint>

#include "program/expression.hpp"

namespace treeline::bounds {

/// Whether the node is what `rotation_from_quaternion` multiplies by: 2 over the squared length of
/// a quaternion in q, whose length is 1 in every domain.
bool is_quaternion_scale(const Graph& graph, std::uint32_t node);

/// Of its computed value, in units of rounding: four squares of sum 1 and as many additions are at
/// most 5, twice that and the division's own 2.
inline constexpr double kQuaternionScaleError = 12;

}  // namespace treeline::bounds
