#pragma once

#include <optional>
#include <vector>

#include "passes/count_operations.hpp"
#include "program/program.hpp"

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

/// Estimated time of a program, in units of one addition's time. `count` holds its operations. A
/// division occupies the divider for about four cycles on current cores; an angle costs about as
/// much as its share of a polynomial that four lanes evaluate together. Packs of lanes save two
/// thirds of the operations that they share, see the source. A cycle of the critical path counts as
/// one addition, because recursions along a chain wait for their operands most of the time. The
/// weights are fitted to 234 timed candidates (samm, anymal, humanoid24; g++ 12 and clang 14, Zen
/// 5): the candidate that they pick takes 1.2 % longer than the fastest one on average. Without the
/// critical path, and with one half in place of two thirds, it took 10 % longer, and up to 57 %.
double cost(const Program& program, const OperationCount& count);

/// Counts the operations of `program` and weights them by time (see `cost`).
Cost cost_of(const Program& program);

/// Picks the candidate of least cost, the earlier one if two are equal. Returns nothing if there
/// are no candidates.
std::optional<Choice> choose(std::vector<Program> candidates);

}  // namespace treeline
