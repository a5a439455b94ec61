#pragma once

#include <cstdint>

#include "program/expression.hpp"

namespace treeline::bounds {

/// Whether the node is the factor in `rotation_from_quaternion`: 2 over the squared length of a
/// quaternion in q or of a tool. This length is 1 in every domain.
bool is_quaternion_scale(const Graph& graph, std::uint32_t node);

/// Error of the computed factor, in rounding units. Four squares of sum 1 and the additions have at
/// most 5 units, the factor twice that plus 2 of the division.
inline constexpr double kQuaternionScaleError = 12;

}  // namespace treeline::bounds
