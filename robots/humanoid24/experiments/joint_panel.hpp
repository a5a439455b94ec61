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

/// What a page says of a run's joints, in words.
struct JointWords {
  std::string nearest_limit;  ///< of position
  std::string fastest;
  std::string torques;  ///< the four greatest
};

/// `first`: the first column of q, behind which those of tau follow.
JointWords describe_joints(const report::Table& table, const Plan& plan, const JointLimits& limits,
                           std::size_t first);

}  // namespace treeline::experiments
