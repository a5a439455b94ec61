#pragma once

#include "mechanism/mechanism.hpp"

namespace treeline {

/// The mechanism with its constraints in place of operational points.
Mechanism with_constraints_only(Mechanism mechanism);

/// The mechanism with its constraints in front of its operational points. These are in the order of
/// priority, equal ones as they were; all have one priority then, for order alone decides which row
/// yields.
Mechanism with_supports(Mechanism mechanism);

/// Former place of each task row of `with_supports`.
std::vector<std::size_t> task_row_order(const Mechanism& mechanism);

}  // namespace treeline
