#pragma once

#include "recursion/tree.hpp"

namespace treeline {

/// What `tree_of<Expression>(mechanism)` is, in the graph that is open, out of its constants in
/// double: reducing these from 50 digits is most of that. `constants` may be older than choices
/// within the mechanism's links (`MovingLink::turns_late`, `carries_column`).
Tree<Expression> lift_tree(const Tree<double>& constants, const Mechanism& mechanism);

}  // namespace treeline
