#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include "report/plot.hpp"
#include "report/table.hpp"
#include "servo/safety.hpp"
#include "servo/statistics.hpp"

namespace treeline::experiments {

/// A run of robots that carry one object.
struct ObjectOutcome {
  report::Table table;  ///< one row per cycle: the columns below, then the experiment's own
  servo::DurationStatistics control;
  servo::Fault fault;
};

enum ObjectColumn : std::size_t {
  kTime,
  kWanted,  ///< position, m
  kActual = kWanted + 3,
  kErrors = kActual + 3,  ///< distance, m, and angle, rad
  kDrift = kErrors + 2,   ///< the largest between the grasps, m and rad
  kOwnColumns
};

/// An outcome without rows, and room for those of a run of so many s at so many Hz. `own`: names of
/// the experiment's own columns.
ObjectOutcome make_outcome(const std::vector<std::string>& own, double seconds, double rate);

/// Fills in the columns above, from the tracking of an `ObjectTaskController`.
template <class Tracking>
void fill_object_columns(double time, const Tracking& tracking, double* row) {
  const auto norm = [](const double* v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  };
  row[kTime] = time;
  std::copy(std::begin(tracking.wanted.position), std::end(tracking.wanted.position),
            row + kWanted);
  std::copy(std::begin(tracking.position), std::end(tracking.position), row + kActual);
  row[kErrors] = norm(tracking.error);
  row[kErrors + 1] = norm(tracking.error + 3);
  row[kDrift] = 0.0;
  for (const double x : tracking.drift) row[kDrift] = std::max(row[kDrift], std::abs(x));
}

/// Largest size in a column.
double largest(const report::Table& table, std::size_t column);

/// Largest errors over a run.
struct ObjectErrors {
  double position = 0;  ///< m
  double rotation = 0;  ///< rad
  double drift = 0;     ///< between the grasps, m and rad
  double lift = 0;      ///< how far the object goes up, m
};
ObjectErrors largest_object_errors(const report::Table& table);

/// The power of ten above the largest drift, for a page: drift is rounding, whose digits say
/// nothing.
std::string describe_drift(const ObjectErrors& errors);

/// The line of a summary that says why the run stopped; empty if it did not. `joints`: names by
/// coordinate.
std::string describe_stop(const servo::Fault& fault, const char* const* joints);

/// The panel of the distance between wanted and actual position.
report::PlotPanel distance_panel(const report::Table& table, const std::string& object);

}  // namespace treeline::experiments
