#pragma once

#include <set>
#include <string>

#include "program/program.hpp"

namespace treeline {

/// Algorithms that take so many more operations than another that no choice of coordinates, which
/// saves a few of a hundred, makes up for it. Of long programs alone: there the factors of a mass
/// matrix without zeros would take most of the time of tracing, once for each of the coordinates.
class HopelessAlgorithms {
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
