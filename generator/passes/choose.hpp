#pragma once

#include <optional>
#include <vector>

#include "passes/count_operations.hpp"
#include "program/program.hpp"
#include "target/target.hpp"

namespace treeline {

/// Cost of a route: its operations, and their sum weighted by time (see `cost`).
struct Cost {
  RouteId route;
  OperationCount count;
  double weighted = 0;
};

/// Outcome of a choice: the cheapest program, its cost, and the costs of the other candidates,
/// cheapest first.
struct Choice {
  Program program;
  Cost chosen;
  std::vector<Cost> rejected;
};

/// Estimated time of a program, in units of one sum's time. `count` holds its operations. Packs of
/// lanes save two thirds of the operations that they share, see the source. The longest chain
/// counts where it takes about as long as the operations or longer: (operations^4 + chain^4)^(1/4).
double cost(const Program& program, const OperationCount& count, const OperationCosts& costs = {});

/// Counts the operations of `program` and weights them by time (see `cost`).
Cost cost_of(const Program& program, const OperationCosts& costs = {});

/// Picks the candidate of least cost, the earlier one if two are equal. Returns nothing if there
/// are no candidates.
std::optional<Choice> choose(std::vector<Program> candidates, const OperationCosts& costs = {});

}  // namespace treeline
