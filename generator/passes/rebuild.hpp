#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Says something of every node. Bytes, because bits take three times as long.
using Marks = std::vector<std::uint8_t>;

/// Returns for every node whether a result needs it.
Marks find_live(const Program& program);

/// Counts for every node how often it is a result or an operand of a live node.
std::vector<int> count_uses(const Program& program);

/// Copies everything of the program except its graph, which is left empty.
Program without_graph(const Program& program);

/// Returns the program with its nodes in `order`, which lists every live node once, operands first.
/// Other nodes are removed. Names stay with their nodes. A section begins wherever two neighbours
/// were built in different sections. Node 0 stays the constant 0.
Program rebuild(const Program& program, std::span<const std::uint32_t> order);

}  // namespace treeline
