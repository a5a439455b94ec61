#pragma once

#include <string>

#include "carry_plan.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"
#include "servo/statistics.hpp"

namespace treeline::experiments {

struct CarryOutcome {
  explicit CarryOutcome(std::size_t rows);
  report::Table table;  ///< one row per cycle
  servo::DurationStatistics control;
  servo::Fault fault;  ///< of the servo loop, which ends the run
};

/// Largest errors over the run. Internal forces are those at the end of a cycle with constant
/// torque.
struct CarryErrors {
  double position = 0.0;  ///< m
  double rotation = 0.0;  ///< rad
  double tension = 0.0;   ///< N
  double moments = 0.0;   ///< N m
  double drift = 0.0;     ///< m
  double drift_rotation = 0.0;
  double travel = 0.0;  ///< largest displacement of the first base, m
};

CarryOutcome carry_object(const CarryPlan& plan);
CarryErrors largest_errors(const CarryOutcome& outcome);
/// Whether the run ends without a fault and keeps its bounds.
bool within_bounds(const CarryOutcome& outcome);
std::string summary(const CarryOutcome& outcome);
report::Plot figure(const CarryOutcome& outcome);

}  // namespace treeline::experiments
