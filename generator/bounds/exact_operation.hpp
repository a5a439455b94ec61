#pragma once

#include <cmath>

#include "program/expression.hpp"

namespace treeline::bounds {

inline bool is_float(double value) {
  return static_cast<double>(static_cast<float>(value)) == value;
}

/// Whether a node is a factor that rounds nothing.
inline bool is_power_of_two(const Node& node) {
  int exponent = 0;
  return node.op == Op::constant && std::abs(std::frexp(node.value, &exponent)) == 0.5;
}

/// A bound is multiplied by this after some operations, for rounding of its own.
inline constexpr double kSlack = 1 + 0x1p-40;

}  // namespace treeline::bounds
