#include "passes/choose.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "passes/passes.hpp"
#include "program/ending.hpp"

namespace treeline {

namespace {

/// A processor computes other operations while a chain waits, so the longer of both decides; where
/// they are about as long, some of the shorter one shows: the fourth root of the sum of their
/// fourth powers. By square roots, whose last digits are the same on every machine.
double beside(double operations, double waiting) {
  const double a = operations * operations;
  const double b = waiting * waiting;
  return std::sqrt(std::sqrt(a * a + b * b));
}

/// Time of an operation of a routine in a lane.
constexpr double kTimeInEnding = 0.5;

/// Time of a routine's beginning: it reads in vectors what lines have just written one by one, and
/// where joints stand side by side, few joints fill no vectors. Measured: of FER, UR5 and iiwa14
/// lines are faster than a solve by 190 ns on average; those for derivatives of inverse dynamics
/// take 0.5 of the time of one frame for FER, 0.89 for a floating G1. There lines keep more digits,
/// too: in one frame the last joints of long limbs are far from the origin.
double time_to_begin(Routine routine) {
  if (routine == Routine::force_derivatives) return 12000;
  return routine == Routine::acceleration_derivatives ? 4000 : 1000;
}

}  // namespace

double cost(const Program& program, const OperationCount& count, const OperationCosts& costs) {
  int shared = 0;
  for (const LanePack& pack : program.packs) {
    const std::uint32_t some = *std::max_element(pack.begin(), pack.end());
    if (program.graph.nodes()[some].op == Op::neg) {  // costs no operation, see OperationCount
      continue;
    }
    const auto used =
        static_cast<int>(pack.size()) - static_cast<int>(std::count(pack.begin(), pack.end(), 0U));
    shared += used - (used + costs.lanes - 1) / costs.lanes;
  }
  // Measured: lanes save two thirds of what this count promises, because scalar code fuses more
  // multiply-adds.
  const double saved = std::max(0, shared - program.lane_moves) * 2 / 3.0;
  const double operations = count.add + costs.product * count.mul - saved +
                            costs.quotient * count.div + costs.angle * count.sin_cos;
  return costs.waiting > 0 ? beside(operations, costs.waiting * critical_path(program))
                           : operations;
}

Cost cost_of(const Program& program, const OperationCosts& costs) {
  const OperationCount count = count_operations(program);
  if (!program.ending) return {program.route, count, cost(program, count, costs)};
  const Ending& ending = *program.ending;
  const double lines = cost(ending.lines, count_operations(ending.lines), costs);
  return {program.route, count,
          lines + time_to_begin(ending.routine) +
              kTimeInEnding * (ending.executed.add + ending.executed.mul) / costs.lanes};
}

std::optional<Choice> choose(std::vector<Program> candidates, const OperationCosts& of) {
  if (candidates.empty()) {
    return std::nullopt;
  }
  std::vector<std::pair<Cost, std::size_t>> costs;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    costs.emplace_back(cost_of(candidates[i], of), i);
  }
  std::stable_sort(costs.begin(), costs.end(), [](const auto& a, const auto& b) {
    return a.first.weighted < b.first.weighted;
  });
  Choice choice{std::move(candidates[costs.front().second]), costs.front().first, {}};
  for (auto loser = costs.begin() + 1; loser != costs.end(); ++loser) {
    choice.rejected.push_back(loser->first);
  }
  return choice;
}

}  // namespace treeline
