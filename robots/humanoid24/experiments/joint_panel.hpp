#pragma once

#include <cstddef>
#include <string>

#include "plan.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

namespace treeline::experiments {

/// Makes a panel of the seven joints whose columns have the largest span. Their columns begin at
/// `first`. With `from_start` the initial values are subtracted.
report::PlotPanel joint_panel(const report::Table& table, const Plan& plan,
                              const std::string& title, const std::string& y_label,
                              std::size_t first, bool from_start);

}  // namespace treeline::experiments
