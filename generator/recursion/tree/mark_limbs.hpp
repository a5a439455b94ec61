#pragma once

#include "mechanism/mechanism.hpp"
#include "program/expression.hpp"

namespace treeline {

template <class Scalar>
struct Tree;

/// Turns the constants in which the limbs of a family differ into limb constants, and tells the
/// open graph which inputs correspond. So a trace of `tree` has the same operations for every limb.
void mark_limbs(const Mechanism& mechanism, Tree<Expression>& tree);

}  // namespace treeline
