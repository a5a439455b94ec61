#pragma once

#include <optional>
#include <vector>

#include "bounds/trig_polynomial.hpp"

namespace treeline::bounds {

/// `factor` times the value of a node.
struct LinearTerm {
  std::uint32_t node = 0;
  TrigPolynomial factor;
};

/// An operation that was expanded, `weight` being the most that its value counts in the sum.
struct ExpandedOperation {
  std::uint32_t node = 0;
  double weight = 0;
};

/// A node's value as a sum of others'. Terms whose factors turn with `angle` come first in a turn:
/// `turned`; what else is added is in `rest`.
struct LinearForm {
  std::vector<LinearTerm> turned, rest;
  std::vector<ExpandedOperation> operations;
};

/// The angle nearest below a sum by which its terms are turned; zero where there is none.
Angle find_turn(const Graph& graph, const std::vector<std::optional<TrigPolynomial>>& polynomials,
                std::uint32_t node);

/// The node's value by the sines and cosines of `angle`: sums are followed as long as one of their
/// terms has such a factor. Nothing when none has.
std::optional<LinearForm> expand_linear(
    const Graph& graph, const std::vector<std::optional<TrigPolynomial>>& polynomials,
    std::uint32_t node, Angle angle);

/// In the sums of a set: a difference of two values that are turned by themselves, in any of the
/// sums, is turned with them.
void split_sums(const Graph& graph, std::vector<LinearForm>& forms);

/// A value that is turned in one sum is so in all, also where it is added once more as it is.
void gather_turned(std::vector<LinearForm>& forms);

}  // namespace treeline::bounds
