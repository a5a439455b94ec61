#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/task_law.hpp"

namespace treeline {

/// The order in which the equations of a spherical wrist are solved one by one, and which of the
/// pivots are constants.
struct PivotOrder {
  int axes_link = -1;  ///< in whose axes the equations are
  std::vector<Pivot> order;
  std::vector<bool> constant;
};

/// First what stands alone in its row or column, then a constant, the largest: so no pivot is a
/// difference that may vanish where the wrist is not singular. Nothing where there is no such
/// order.
std::optional<PivotOrder> order_wrist_pivots(const Mechanism& mechanism);

/// Which row of the wrist's velocity in the axes of `axes_link` only the first joint moves; nothing
/// where there is none, or where more than the second and third joint move the others.
std::optional<std::size_t> find_lone_row(const Mechanism& mechanism, int axes_link);

}  // namespace treeline
