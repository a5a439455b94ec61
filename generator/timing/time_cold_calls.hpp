#pragma once

#include <optional>
#include <string>
#include <vector>

#include "timing/time_calls.hpp"

namespace treeline {

/// A compiled function whose code is to be removed from the caches.
struct ColdCall {
  TimedCall call;
  std::string library;  ///< file that it was loaded from
};

/// Time of one call alone, without that of reading the clock.
struct ColdTiming {
  Timing from_cache;                  ///< after `evict_from_core`
  std::optional<Timing> from_memory;  ///< after `evict_from_caches`, where that is possible
};

/// Times calls that find their code and data in no cache of their core, and in no cache at all, in
/// interleaved order, each round at another state. Returns one result per call; ratios are to the
/// first.
std::vector<ColdTiming> time_cold_calls(const std::vector<ColdCall>& calls, int rounds = 31);

}  // namespace treeline
