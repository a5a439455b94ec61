#pragma once

#include <cstddef>
#include <optional>
#include <span>
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

/// Removes everything that a later call needs from the core's own caches. It reads data of four
/// times the size of the second-level cache and runs 512 KiB of code, which also replaces branch
/// predictions and decoded instructions. Code and data of a call are then in the shared cache, if
/// there is one. A loop that sleeps while other programs work finds its code in this state.
void evict_from_core();

/// Removes `data`, and the code and constants of what is loaded, from all caches, so that the next
/// call reads everything from memory. Of what is loaded those whose file names have one of
/// `objects` in them, and the program itself where one is empty. Includes `evict_from_core`.
/// Returns false if the processor has no instruction for it.
bool evict_from_caches(std::span<const std::span<const std::byte>> data,
                       std::span<const std::string> objects);

}  // namespace treeline
