#pragma once

#include <optional>
#include <vector>

#include "passes/count_operations.hpp"
#include "program/program.hpp"

namespace treeline {

/// What a way to compute a function costs: its operations, and these weighted by their time, see
/// `cost`.
struct Cost {
  RouteId route;
  OperationCount count;
  double weighted = 0;
};

/// The outcome: the cheapest program, its cost, and what the others would have cost, cheapest
/// first.
struct Choice {
  Program program;
  Cost chosen;
  std::vector<Cost> rejected;
};

/// Operations as multiples of one addition's time. A division occupies the divider for about four
/// cycles on current cores, an angle about as much as four lanes' share of the polynomial. Packs
/// of lanes save two thirds of the operations they share, see the source. A cycle of the critical
/// path counts as one addition: recursions along a chain wait for their operands most of the time.
/// Fitted to 234 timed candidates (samm, anymal, humanoid24; g++ 12 and clang 14, Zen 5): what this
/// picks takes 1.2 % longer than the fastest of them in the mean; without the critical path, and
/// with half in place of two thirds, it took 10 %, and up to 57 %.
double cost(const Program& program, const OperationCount& count);

/// The same with what it is a cost of.
Cost cost_of(const Program& program);

/// Picks the candidate of least cost; the earlier of two that are equal. Nothing when there is
/// none.
std::optional<Choice> choose(std::vector<Program> candidates);

}  // namespace treeline
