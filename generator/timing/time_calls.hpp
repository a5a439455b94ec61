#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "check/generated_library.hpp"
#include "timing/call_arguments.hpp"

namespace treeline {

/// A compiled function and what it is called with. Both must outlive the timing.
struct TimedCall {
  CompiledEntry entry = nullptr;  ///< `GeneratedLibrary::raw_entry`
  const CallArguments* arguments = nullptr;
};

/// Whatever else there is to time: makes so many calls, of different states, one after the other.
struct TimedPass {
  std::function<void()> pass;
  std::size_t calls = 1;
};

struct TimingOptions {
  int rounds = 41;             ///< repetitions of each, all in turn in every round
  double repetition_us = 150;  ///< at least: short, so that little disturbs most of them
};

/// Of one call, warm and back to back over all states, each independent of the last: throughput.
/// With what calling through a pointer takes, some 2 ns.
struct Timing {
  double nanoseconds = 0;  ///< median of all rounds
  double ratio = 1;        ///< to the first call: median of the ratios within each round
  double noise = 0;        ///< half the distance between the quartiles of those ratios
};

/// Times the calls interleaved: what changes with time, like the clock's frequency, changes all of
/// them. In each round another one begins.
std::vector<Timing> time_calls(const std::vector<TimedCall>& calls,
                               const TimingOptions& options = {});
/// The same for anything that can be called.
std::vector<Timing> time_passes(const std::vector<TimedPass>& passes,
                                const TimingOptions& options = {});

}  // namespace treeline
