#pragma once

#include "mechanism/mechanism.hpp"
#include "program/expression.hpp"

namespace treeline {

template <class Scalar>
struct Tree;

/// Makes the constants in which limbs of a family differ limb constants, and tells the open graph
/// which inputs correspond, so that what is traced from `tree` is the same in every limb.
void mark_limbs(const Mechanism& mechanism, Tree<Expression>& tree);

}  // namespace treeline
