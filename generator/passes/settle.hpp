#pragma once

#include "program/program.hpp"

namespace treeline {

/// A traced program in an order of nodes that depends on the program alone: depth-first from the
/// results, left operands first. C++ leaves the order in which a trace builds nodes to the
/// compiler. Nodes that no result needs are gone; x y and y x become one node, and what simplifies
/// thereby does.
Program settle(const Program& program);

}  // namespace treeline
