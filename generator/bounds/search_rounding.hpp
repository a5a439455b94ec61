#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bounds/domain.hpp"
#include "program/program.hpp"

namespace treeline::bounds {

/// Effort of a search.
struct SearchEffort {
  int batches = 16;       ///< of `kStatesAtOnce` states, drawn from the domain
  int starts = 2;         ///< of hill climbing, per result, at the worst states drawn
  int generations = 100;  ///< steps from a start, each with `kStatesAtOnce` states
  std::uint64_t seed = 1;
};

/// Effort that takes some 30 ms for a graph of 10000 operations. Small graphs get more states,
/// large ones fewer steps.
SearchEffort default_effort(const Graph& graph);

/// First-order bound of one result, in rounding units (see `ErrorPropagation`): that of its worst
/// entry, with the index of the entry and the magnitude of the result.
struct FoundError {
  double error = 0, size = 0;
  std::size_t entry = 0;
};

/// Searches the domain for the state with the largest first-order bound. Returns one bound for each
/// result.
std::vector<FoundError> search_worst(const Program& program, const Domain& domain, double unit,
                                     const SearchEffort& effort);

/// First-order bounds of one result that hold in 50, 90 and 99 of 100 states.
using TypicalErrors = std::array<FoundError, 3>;
std::vector<TypicalErrors> find_typical(const Program& program, const Domain& domain, double unit,
                                        const SearchEffort& effort);

}  // namespace treeline::bounds
