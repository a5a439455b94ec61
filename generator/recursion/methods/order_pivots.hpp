#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/methods/task_law.hpp"

namespace treeline {

/// Order in which the equations of a spherical wrist are solved one by one, and which of the pivots
/// are constants.
struct PivotOrder {
  int axes_link = -1;  ///< link in whose axes the equations are written
  std::vector<Pivot> order;
  std::vector<bool> constant;
};

/// Finds such an order: first an entry that is alone in its row or column, then the largest
/// constant. So no pivot is a difference that could vanish at a pose where the wrist is not
/// singular. Nothing if there is no such order.
std::optional<PivotOrder> order_wrist_pivots(const Mechanism& mechanism);

/// Finds the row of the wrist's velocity in the axes of `axes_link` that only the first joint
/// moves. Nothing if there is none, or if more joints than the second and third move the other
/// rows.
std::optional<std::size_t> find_lone_row(const Mechanism& mechanism, int axes_link);

}  // namespace treeline
