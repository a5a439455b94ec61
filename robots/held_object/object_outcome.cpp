#include "object_outcome.hpp"

#include <fmt/core.h>

namespace treeline::experiments {

ObjectOutcome make_outcome(const std::vector<std::string>& own, double seconds, double rate) {
  std::vector<std::string> names{"time", "x_wanted", "y_wanted",       "z_wanted",       "x",
                                 "y",    "z",        "position_error", "rotation_error", "drift"};
  names.insert(names.end(), own.begin(), own.end());
  return {{names, static_cast<std::size_t>(seconds * rate) + 2}, {}, {}};
}

double largest(const report::Table& table, std::size_t column) {
  double result = 0.0;
  for (const double value : table.column(column)) result = std::max(result, std::abs(value));
  return result;
}

ObjectErrors largest_object_errors(const report::Table& table) {
  ObjectErrors errors{largest(table, kErrors), largest(table, kErrors + 1), largest(table, kDrift)};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    errors.lift = std::max(errors.lift, table.at(row, kActual + 2) - table.at(0, kActual + 2));
  }
  return errors;
}

std::string describe_drift(const ObjectErrors& errors) {
  return fmt::format("below 1e{:.0f}", std::floor(std::log10(errors.drift)) + 1);
}

std::string describe_stop(const servo::Fault& fault, const char* const* joints) {
  if (!fault) return {};
  const std::string joint = fault.index >= 0 ? joints[fault.index] : "";
  return "stopped      " + servo::describe(fault, joint) + "\n";
}

report::PlotPanel distance_panel(const report::Table& table, const std::string& object) {
  std::vector<double> error = table.column(kErrors);
  for (double& value : error) value *= 1e6;
  return {"Distance between wanted and actual position",
          "distance (\u00b5m)",
          {{object, error, false}},
          0.0};
}

}  // namespace treeline::experiments
