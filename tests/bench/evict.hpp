#pragma once

#include <span>

namespace treeline::bench {

/// Removes everything that a later call needs from the core's own caches. It reads data of four
/// times the size of the second-level cache and runs 512 KiB of code, which also replaces branch
/// predictions and decoded instructions. Code and data of a call are then in the shared cache, if
/// there is one. A loop that sleeps while other programs work finds its code in this state.
void evict_from_core();

/// Removes the code and constants of the program and of the loaded libraries, and `data`, from all
/// caches, so that the next call reads everything from memory. Includes `evict_from_core`. Returns
/// false if the processor has no instruction for it.
bool evict_from_caches(std::span<const std::span<const double>> data);

}  // namespace treeline::bench
