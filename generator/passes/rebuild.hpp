#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// For every node whether a result needs it.
std::vector<bool> find_live(const Program& program);

/// How often each node is an operand of a live node or a result.
std::vector<int> count_uses(const Program& program);

/// All of the program but its graph, in place of which is an empty one.
Program without_graph(const Program& program);

/// The program with its nodes in `order`, which lists every live node once, operands first; nodes
/// left out are gone. Names stay with their nodes; a section begins wherever the section that a
/// node was built in differs from its predecessor's. Node 0 stays the constant 0.
Program rebuild(const Program& program, std::span<const std::uint32_t> order);

}  // namespace treeline
