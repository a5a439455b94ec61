#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// `order` with operations moved forward so that they do not wait for each other: of the next few
/// that are ready the one with the longest way to a result goes first, as a list scheduler would
/// with the latencies of current cores. What shares a pack stays together, and the first `head`
/// nodes where they are.
std::vector<std::uint32_t> interleave(const Program& program, std::span<const std::uint32_t> order,
                                      std::size_t head);

}  // namespace treeline
