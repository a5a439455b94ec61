#pragma once

#include <cstddef>
#include <string>

#include "plan.hpp"
#include "servo/plot.hpp"
#include "servo/table.hpp"

namespace treeline::experiments {

/// A panel of the seven joints whose columns, from `first` on, span most; less the start's values
/// when `from_start`.
servo::PlotPanel joint_panel(const servo::Table& table, const Plan& plan, const std::string& title,
                             const std::string& y_label, std::size_t first, bool from_start);

}  // namespace treeline::experiments
