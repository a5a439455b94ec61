#include "emission/limit_cost.hpp"

#include <algorithm>

#include "core/limited_torque.hpp"

namespace treeline {

LimitCost cost_of_limits(const LimitFacts& facts, int velocities) {
  LimitCost cost;
  cost.unknowns = core::in_eights(std::max(facts.freedoms, 1) + 1);
  cost.rows =
      velocities - static_cast<int>(facts.passive.size()) + static_cast<int>(facts.cones.size());
  cost.iterations = 2 * core::most_iterations(cost.unknowns, cost.rows) + cost.unknowns;
  cost.flops_of_iteration = core::flops_of_iteration(cost.unknowns, cost.rows);
  return cost;
}

}  // namespace treeline
