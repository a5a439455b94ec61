#pragma once

#include <functional>

#include "program/ending.hpp"

namespace treeline {

/// Adds the tables above_ends, above, below_ends and below of `tl_solve_columns`: which rows L^-T
/// and L^-1 subtract from which, M = L^T D L. `place` tells where the factor of row k and column
/// i < k stands, -1 where it is 0.
void list_row_sums(const std::function<int(int k, int i)>& place, Ending& ending);

}  // namespace treeline
