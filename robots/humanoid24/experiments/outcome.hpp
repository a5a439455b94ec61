#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"
#include "servo/statistics.hpp"

namespace treeline::experiments {

/// Number of columns before those of the joints: time; per hand three desired and three actual
/// coordinates, distance and angle between desired and actual pose; control time in us.
inline constexpr int kFixedColumns = 18;

/// Names of all columns: the fixed ones, then q and tau of every joint.
std::vector<std::string> table_names(const std::vector<std::string>& joints);

/// Result of a run.
struct Outcome {
  Outcome(std::vector<std::string> names, std::size_t rows) : table(std::move(names), rows) {}

  report::Table table;  ///< one row per cycle in the running mode
  servo::Fault fault;
  servo::DurationStatistics control;  ///< compute time of the controller
  servo::DurationStatistics periods;
  servo::DurationStatistics jitters;
  std::uint64_t skips = 0;
};

/// Largest errors over the run.
struct Errors {
  double left_position = 0.0;   ///< desired to actual, m
  double left_rotation = 0.0;   ///< rad
  double right_position = 0.0;  ///< m
  double right_rotation = 0.0;  ///< rad
};

Errors largest_errors(const report::Table& table);

/// Bounds that the run must keep: tracking of the left hand and drift of the right hand.
inline constexpr double kLeftBound = 1e-4;   ///< m
inline constexpr double kRightBound = 2e-6;  ///< m
bool within_bounds(const Outcome& outcome);

/// Time for one control step in the thesis: 1.2 ms on a 266 MHz Pentium II.
inline constexpr double kThesisMicroseconds = 1200.0;

/// Prints the figures in words, one per line.
std::string summary(const Outcome& outcome, const Plan& plan, bool realtime);

/// Draws Chang fig. 6.4 and related curves: both hands, errors, torques, posture.
report::Plot figure(const Outcome& outcome, const Plan& plan);

}  // namespace treeline::experiments
