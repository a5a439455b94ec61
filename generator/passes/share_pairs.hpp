#pragma once

#include "program/program.hpp"

namespace treeline {

/// Computes once what several sums, or several products, have in common: of (a + b) + c and
/// (a + d) + b the pair a + b. Sums and products are looked at whole, across the nodes that make
/// them up as far as these have no other use; the pair that occurs most often goes first, until
/// none occurs twice (Breuer 1969).
Program share_pairs(const Program& program);

}  // namespace treeline
