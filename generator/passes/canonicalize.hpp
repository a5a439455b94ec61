#pragma once

#include "program/program.hpp"

namespace treeline {

/// Puts the nodes of a traced program into an order that depends only on the program: depth-first
/// from the results, left operands first. This is needed because C++ leaves the order in which a
/// trace builds nodes to the compiler. Nodes that no result needs are removed. x y and y x become
/// one node, and expressions that simplify as a consequence are simplified.
Program canonicalize(const Program& program);

}  // namespace treeline
