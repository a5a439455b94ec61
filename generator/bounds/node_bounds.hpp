#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "bounds/trig_polynomial.hpp"
#include "program/program.hpp"

namespace treeline::bounds {

/// Bounds of a value, or of the norm of several values, and of its error. The error is in units of
/// the rounding unit u (2^-53 or 2^-24): |computed - exact| <= u error, including all orders in u.
struct Bounded {
  double size = 0;
  double error = 0;
};

/// A member of a set: a node's value times a weight.
struct Member {
  std::uint32_t node = 0;
  double weight = 0;
  auto operator<=>(const Member&) const = default;
};
using Set = std::vector<Member>;

/// The nodes of a graph, with the bounds that are known so far.
struct NodeBounds {
  const Graph& graph;
  const std::vector<std::optional<TrigPolynomial>>& polynomials;
  double unit = 0;
  std::vector<std::optional<Bounded>> bounds;

  /// Bound of the magnitude of the computed value.
  [[nodiscard]] double computed(std::uint32_t node) const {
    return bounds[node]->size + unit * bounds[node]->error;
  }
  /// Error that the rounding of an expanded operation adds to its sum, in rounding units.
  [[nodiscard]] double local_error(const ExpandedOperation& expanded) const;
};

}  // namespace treeline::bounds
