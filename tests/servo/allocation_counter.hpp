#pragma once

namespace treeline::test {

/// How often this program has asked for memory with `new` so far.
long allocation_count() noexcept;

}  // namespace treeline::test
