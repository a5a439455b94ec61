#pragma once

#include <cstddef>
#include <string>

#include "plan.hpp"
#include "servo/plot.hpp"
#include "servo/table.hpp"

namespace treeline::experiments {

/// Makes a panel of the seven joints whose columns have the largest span. Their columns begin at
/// `first`. With `from_start` the initial values are subtracted.
servo::PlotPanel joint_panel(const servo::Table& table, const Plan& plan, const std::string& title,
                             const std::string& y_label, std::size_t first, bool from_start);

}  // namespace treeline::experiments
