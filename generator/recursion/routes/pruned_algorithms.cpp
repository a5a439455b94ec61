#include "recursion/routes/pruned_algorithms.hpp"

#include <algorithm>

namespace treeline {
void PrunedAlgorithms::look_at(const Program& program) {
  constexpr std::size_t kLong = 30'000;
  constexpr std::size_t kFar = 2;
  const std::size_t nodes = program.graph.nodes().size();
  least_ = least_ == 0 ? nodes : std::min(least_, nodes);
  if (nodes > kLong && nodes > kFar * least_) keys_.insert(program.route.algorithm);
}

}  // namespace treeline
