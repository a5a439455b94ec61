#pragma once

#include <algorithm>
#include <limits>

#include "passes/count_operations.hpp"
#include "random_mechanism.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline::tests {

/// Operations of the cheapest route to a function, as traced.
inline int least_flops(const Robot& robot, const Scene& scene, Function function) {
  int least = std::numeric_limits<int>::max();
  for (const Program& program : trace_function(reduced_mechanism(robot, scene), function)) {
    least = std::min(least, count_operations(program).flops());
  }
  return least;
}
inline int least_flops(const RandomMechanism& made, Function function) {
  return least_flops(made.robot, made.scene, function);
}

}  // namespace treeline::tests
