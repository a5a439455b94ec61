#pragma once

#include <span>

namespace treeline::bench {

/// Empties the core's own caches of everything that a later call needs: walks through four times
/// the second-level cache of data and runs 512 KiB of code that is nothing else's, which also takes
/// the branch predictors and decoded instructions. What was there is then in the shared cache, if
/// there is one: the state in which a loop finds its code that sleeps while others work.
void evict_from_core();

/// Drops from all caches the code and constants of the program and of the loaded libraries, and
/// `data`: the next call reads everything from memory. Does `evict_from_core` too. False where
/// there is no instruction for it.
bool evict_from_caches(std::span<const std::span<const double>> data);

}  // namespace treeline::bench
