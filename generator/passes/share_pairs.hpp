#pragma once

#include "program/program.hpp"

namespace treeline {

/// Computes once what several sums, or several products, have in common: the pair a + b in (a + b)
/// + c and (a + d) + b. Sums and products are considered as a whole, across all nodes that make
/// them up, as long as these have no other use. The most frequent pair is taken first, until none
/// occurs twice (Breuer 1969).
Program share_pairs(const Program& program);

}  // namespace treeline
