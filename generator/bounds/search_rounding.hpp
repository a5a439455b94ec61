#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bounds/domain.hpp"
#include "program/program.hpp"

namespace treeline::bounds {

/// How long to look.
struct SearchEffort {
  int batches = 16;       ///< of `kStatesAtOnce` states, drawn from the domain
  int climbs = 2;         ///< for each result, from the worst states drawn
  int generations = 100;  ///< of a climb, each of `kStatesAtOnce` states
  std::uint64_t seed = 1;
};

/// Some 30 ms for a graph of 10000 operations; small ones get more states, large ones shorter
/// climbs.
SearchEffort default_effort(const Graph& graph);

/// A first-order bound of one result, see `ErrorPropagation`, in rounding units: that of its worst
/// entry there, and how large the result is.
struct FoundError {
  double error = 0, size = 0;
  std::size_t entry = 0;
};

/// For each result the worst that was found.
std::vector<FoundError> search_worst(const Program& program, const Domain& domain, double unit,
                                     const SearchEffort& effort);

/// For each result those of 50, 90 and 99 of 100 states drawn.
using TypicalErrors = std::array<FoundError, 3>;
std::vector<TypicalErrors> find_typical(const Program& program, const Domain& domain, double unit,
                                        const SearchEffort& effort);

}  // namespace treeline::bounds
