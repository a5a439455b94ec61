#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Returns `order` with operations moved forward so that they do not wait for each other, as a list
/// scheduler would do with the latencies of current cores: among the next operations that are
/// ready, the one with the longest way to a result goes first. Nodes of a pack stay together, and
/// the first `head` nodes keep their places.
std::vector<std::uint32_t> interleave(const Program& program, std::span<const std::uint32_t> order,
                                      std::size_t head);

}  // namespace treeline
