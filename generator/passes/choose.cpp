#include "passes/choose.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "passes/critical_path.hpp"

namespace treeline {

double cost(const Program& program, const OperationCount& count) {
  constexpr double kDivision = 8;  // two additions start per cycle, a division every four cycles
  constexpr double kAngle = 12;
  constexpr double kWaiting = 1;  // one cycle; the next call's operations fill part of it
  constexpr int kRegister = 4;    // doubles per AVX2 register, the widest that can be relied on
  int shared = 0;
  for (const LanePack& pack : program.packs) {
    const std::uint32_t some = *std::max_element(pack.begin(), pack.end());
    if (program.graph.nodes()[some].op == Op::neg) {  // costs no operation, see OperationCount
      continue;
    }
    const auto used =
        static_cast<int>(pack.size()) - static_cast<int>(std::count(pack.begin(), pack.end(), 0U));
    shared += used - (used + kRegister - 1) / kRegister;
  }
  // Measured: lanes save two thirds of what this count promises, because scalar code fuses more
  // multiply-adds.
  const double saved = std::max(0, shared - program.lane_moves) * 2 / 3.0;
  return count.add + count.mul - saved + kDivision * count.div + kAngle * count.sin_cos +
         kWaiting * critical_path(program);
}

Cost cost_of(const Program& program) {
  const OperationCount count = count_operations(program);
  return {program.route, count, cost(program, count)};
}

std::optional<Choice> choose(std::vector<Program> candidates) {
  if (candidates.empty()) {
    return std::nullopt;
  }
  std::vector<std::pair<Cost, std::size_t>> costs;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    costs.emplace_back(cost_of(candidates[i]), i);
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
