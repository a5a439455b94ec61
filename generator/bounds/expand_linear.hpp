#pragma once

#include <optional>
#include <vector>

#include "bounds/trig_polynomial.hpp"

namespace treeline::bounds {

/// Value of a node times `factor`.
struct LinearTerm {
  std::uint32_t node = 0;
  TrigPolynomial factor;
};

/// An operation that was expanded. The sum depends on its value with a factor of at most `weight`.
struct ExpandedOperation {
  std::uint32_t node = 0;
  double weight = 0;
};

/// Value of a node as a sum of other values. `turned` has the terms whose factors turn with
/// `angle`, `rest` the other terms.
struct LinearForm {
  std::vector<LinearTerm> turned, rest;
  std::vector<ExpandedOperation> operations;
};

/// Finds the angle that turns terms of a sum, the one nearest below the node. Returns 0 if there is
/// none.
Angle find_turn(const Graph& graph, const std::vector<std::optional<TrigPolynomial>>& polynomials,
                std::uint32_t node);

/// Expresses the node's value by sines and cosines of `angle`. Sums are followed as long as one of
/// their terms has such a factor. Returns nothing if none has.
std::optional<LinearForm> expand_linear(
    const Graph& graph, const std::vector<std::optional<TrigPolynomial>>& polynomials,
    std::uint32_t node, Angle angle);

/// Splits a turned difference, in the sums of a set, into its two values if one of them also occurs
/// as a term of its own in some sum. It then is turned with them.
void split_sums(const Graph& graph, std::vector<LinearForm>& forms);

/// Moves a value to the turned terms of every sum if it is turned in one of them, even where it is
/// added without a factor.
void gather_turned(std::vector<LinearForm>& forms);

}  // namespace treeline::bounds
