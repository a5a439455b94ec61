#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "bounds/expand_linear.hpp"
#include "program/program.hpp"

namespace treeline::bounds {

/// What a value, or the norm of several, and its error are at most. The error is in units of the
/// rounding unit u (2^-53, 2^-24): |computed - exact| <= u error, all orders in u included.
struct Bounded {
  double size = 0;
  double error = 0;
};

/// A value times a weight; of several the norm is meant.
struct Member {
  std::uint32_t node = 0;
  double weight = 0;
  auto operator<=>(const Member&) const = default;
};
using Set = std::vector<Member>;

/// The nodes of a graph, with the bounds of those that have been bounded so far.
struct NodeBounds {
  const Graph& graph;
  const std::vector<std::optional<TrigPolynomial>>& polynomials;
  double unit = 0;
  std::vector<std::optional<Bounded>> bounds;

  /// No computed value is larger.
  [[nodiscard]] double computed(std::uint32_t node) const {
    return bounds[node]->size + unit * bounds[node]->error;
  }
  /// What the rounding of an operation that was expanded adds, in units of the rounding unit.
  [[nodiscard]] double local_error(const ExpandedOperation& expanded) const;
};

}  // namespace treeline::bounds
