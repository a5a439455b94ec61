#pragma once

#include <set>
#include <string>

#include "program/program.hpp"

namespace treeline {

/// Algorithms that are pruned: they need so many more operations than another one that no choice of
/// coordinates, which saves a few per cent, could make up for it. This applies to long programs
/// only, for which factoring a mass matrix without zeros, once for each choice of coordinates,
/// would take most of the tracing time.
class HopelessAlgorithms {
 public:
  /// Whether the algorithm with this `Program::source` is pruned.
  [[nodiscard]] bool has(const std::string& source) const;
  /// Considers a program. Call this for each route that is traced.
  void look_at(const Program& program);

 private:
  std::set<std::string> names_;
  std::size_t least_ = 0;  ///< number of nodes of the shortest program
};

}  // namespace treeline
