#pragma once

#include <cmath>

#include "program/expression.hpp"

namespace treeline::bounds {

inline bool is_float(double value) {
  return static_cast<double>(static_cast<float>(value)) == value;
}

/// Whether the node is a power of two, so that multiplying by it does not round.
inline bool is_power_of_two(const Node& node) {
  int exponent = 0;
  return node.op == Op::constant && std::abs(std::frexp(node.value, &exponent)) == 0.5;
}

/// Bounds are multiplied by this after some operations, to cover the rounding of their own
/// computation.
inline constexpr double kSlack = 1 + 0x1p-40;

}  // namespace treeline::bounds
