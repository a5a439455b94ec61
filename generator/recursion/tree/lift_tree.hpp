#pragma once

#include "program/program.hpp"
#include "recursion/tree/tree.hpp"

namespace treeline {

/// Makes `constant_tree<Expression>(mechanism)` in the open graph from its constants, because
/// rounding these from 50 digits is most of the work. Choices within the mechanism's links
/// (`MovingLink::defers_rotation`, `carries_column`) may be newer than `constants`.
Tree<Expression> lift_tree(const Tree<DoubleDouble>& constants, const Mechanism& mechanism);

/// Names the numbers of a tree, with links counted from 1: `mass_3`, the first moment `h_3_x`, the
/// inertia `J_3_xx` about the origin of the link's frame, the place `link2_to_3_z` of that origin
/// in the frame before, `rotor_3`; `minus_gravity_z` where the number is negative. A link's numbers
/// are those of all that is fixed to it, less what its joint does not feel, which is counted with
/// the link before.
ConstantNames name_constants(const Tree<DoubleDouble>& tree);

}  // namespace treeline
