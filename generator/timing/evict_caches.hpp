#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace treeline {

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
