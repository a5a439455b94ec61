#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "compilation/generated_library.hpp"
#include "timing/call_arguments.hpp"

namespace treeline {

/// A compiled function and its arguments. Both must outlive the timing.
struct TimedCall {
  CompiledEntry entry = nullptr;  ///< `GeneratedLibrary::raw_entry`
  const CallArguments* arguments = nullptr;
};

/// Anything that can be timed. Makes the given number of calls at different states, one after
/// another.
struct TimedPass {
  std::function<void()> pass;
  std::size_t calls = 1;
};

struct TimingOptions {
  int rounds = 41;             ///< repetitions of each; in every round all take their turn
  double repetition_us = 150;  ///< at least; short, so that most are not disturbed
};

/// Time of one call. If nothing else is said: in warm caches, back to back over all states, each
/// call independent of the last: throughput. It includes the call through a pointer, some 2 ns.
struct Timing {
  double nanoseconds = 0;  ///< median of all rounds
  double ratio = 1;        ///< to the first function's time: median of the ratios within each round
  double noise = 0;        ///< half the distance between the quartiles of those ratios
};

/// Summarises the times of one function, a round each, beside those of the first.
Timing summarise_times(const std::vector<double>& times, const std::vector<double>& first);

/// Times functions in interleaved order, so that changes over time, like the clock's frequency,
/// affect all of them. Each round begins with another function. Returns one result per function.
std::vector<Timing> time_calls(const std::vector<TimedCall>& calls,
                               const TimingOptions& options = {});
/// Times passes in interleaved order: each round begins with another one, so that changes over time
/// affect all of them. Returns one result per pass.
std::vector<Timing> time_passes(const std::vector<TimedPass>& passes,
                                const TimingOptions& options = {});

}  // namespace treeline
