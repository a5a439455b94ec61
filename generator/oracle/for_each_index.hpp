#pragma once

#include <cstddef>
#include <functional>

namespace treeline {

/// Calls `work` for 0 to `count` - 1, from as many threads as there are cores or `threads`, if
/// that is not 0. Returns when all is done; what `work` throws, this throws.
void for_each_index(std::size_t count, const std::function<void(std::size_t)>& work,
                    int threads = 0);

}  // namespace treeline
