#pragma once

#include <cstddef>
#include <functional>

namespace treeline {

/// Calls `work` for each index from 0 to `count` - 1, in `threads` threads, or in as many as there
/// are cores if `threads` is 0. Returns when all calls are done. Rethrows what `work` throws.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work,
                    int threads = 0);

}  // namespace treeline
