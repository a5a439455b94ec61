#pragma once

#include "program/program.hpp"

namespace treeline {

/// Takes common factors out of sums: a c + b c -> (a + b) c, which saves one product for each term
/// but the first. A sum is considered as a whole, across all nodes that it consists of, as long as
/// these and their products have no other use; so nothing is computed twice. The factor that most
/// terms share is taken out first.
Program factor_sums(const Program& program);

}  // namespace treeline
