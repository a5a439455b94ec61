#include "recursion/hopeless_algorithms.hpp"

#include <algorithm>

namespace treeline {
namespace {

/// `unit forces propagated inward (PV-OSIM), in the axes asked for at the points` without the axes.
std::string algorithm_of(const std::string& source) {
  return source.substr(0, source.rfind(", in "));
}

}  // namespace

bool HopelessAlgorithms::has(const std::string& source) const {
  return names_.contains(algorithm_of(source));
}

void HopelessAlgorithms::look_at(const Program& program) {
  constexpr std::size_t kLong = 30'000;
  constexpr std::size_t kFar = 2;
  const std::size_t nodes = program.graph.nodes().size();
  least_ = least_ == 0 ? nodes : std::min(least_, nodes);
  if (nodes > kLong && nodes > kFar * least_) names_.insert(algorithm_of(program.source));
}

}  // namespace treeline
