#include "emission/limit_cost.hpp"

#include <algorithm>

#include "core/emitted_limits.hpp"

namespace treeline {
namespace {

/// Numbers of TlLimitProgram of runtime/emitted, and the matrices that it takes.
int count_values(const LimitFacts& facts, int velocities, int n, int m) {
  const int V = velocities;
  const int P = core::one_or(static_cast<int>(facts.passive.size()));
  const int H = core::one_or(static_cast<int>(facts.force_weights.size()));
  const int T = core::one_or(static_cast<int>(facts.task_weights.size()));
  const bool shares = facts.has_shares();
  const int cols = core::in_eights(P + H + T + V) + (shares ? core::in_eights(H) : 0);
  const int coordinates = (V + (shares ? H : 0)) * cols + cols + T + H * n;
  const int basis = P * P + H * P + H * H + (shares ? 2 * (H + T) + P + H : H);
  const int rows = 2 * n + m * n + 2 * m;
  const int method = 2 * n * n + 5 * n + m;
  return coordinates + basis + rows + method + V * V + (H + T) * V + V + H;
}

}  // namespace

LimitCost cost_of_limits(const LimitFacts& facts, int velocities) {
  LimitCost cost;
  cost.unknowns = core::in_eights(std::max(facts.freedoms, 1) + 1);
  cost.rows =
      velocities - static_cast<int>(facts.passive.size()) + static_cast<int>(facts.cones.size());
  cost.iterations = 2 * core::most_iterations(cost.unknowns, cost.rows) + cost.unknowns;
  cost.flops_of_iteration = core::flops_of_iteration(cost.unknowns, cost.rows);
  cost.values = count_values(facts, velocities, cost.unknowns, cost.rows);
  return cost;
}

}  // namespace treeline
