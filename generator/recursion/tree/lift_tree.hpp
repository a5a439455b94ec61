#pragma once

#include "recursion/tree/tree.hpp"

namespace treeline {

/// Makes `constant_tree<Expression>(mechanism)` in the open graph from its constants, because
/// rounding these from 50 digits is most of the work. Choices within the mechanism's links
/// (`MovingLink::defers_rotation`, `carries_column`) may be newer than `constants`.
Tree<Expression> lift_tree(const Tree<DoubleDouble>& constants, const Mechanism& mechanism);

}  // namespace treeline
