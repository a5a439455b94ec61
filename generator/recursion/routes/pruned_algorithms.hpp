#pragma once

#include <set>
#include <string>

#include "program/program.hpp"

namespace treeline {

/// Algorithms that are pruned: they need so many more operations than another one that no choice of
/// coordinates, which saves a few per cent, could make up for it. This applies to long programs
/// only, for which factoring a mass matrix without zeros, once for each choice of coordinates,
/// would take most of the tracing time.
class PrunedAlgorithms {
 public:
  /// Whether the algorithm of this route is one of them.
  [[nodiscard]] bool has(const RouteId& route) const { return keys_.contains(route.algorithm); }
  /// To be called for each route that is traced.
  void look_at(const Program& program);

 private:
  std::set<std::string> keys_;
  std::size_t least_ = 0;  ///< nodes of the shortest program
};

}  // namespace treeline
