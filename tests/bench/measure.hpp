#pragma once

#include <string>
#include <vector>

#include "case.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// Ways to call a function. All times are per state: the time of a call divided by the number of
/// its states.
enum class Mode {
  warm,       ///< back to back over 64 states, independent of each other: throughput
  dependent,  ///< back to back, each q depends on the last outputs: latency
  cold,       ///< one call whose code and data have left the core's own caches
  flushed     ///< one call whose code and data are in memory only
};

inline constexpr Mode kModes[] = {Mode::warm, Mode::dependent, Mode::cold, Mode::flushed};

std::string name_of(Mode mode);

/// Registers a benchmark for every function of every subject in every mode, named
/// robot/function/implementation/mode. `robot` and `subjects` must outlive the run.
void register_benchmarks(const Case& robot, const std::vector<Subject>& subjects);

}  // namespace treeline::bench
