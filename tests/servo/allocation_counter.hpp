#pragma once

namespace treeline::test {

/// Number of times that this program has allocated memory with `new` so far.
long allocation_count() noexcept;

}  // namespace treeline::test
