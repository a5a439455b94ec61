#include "outcome.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "joint_panel.hpp"

namespace treeline::experiments {
namespace {

constexpr std::size_t kLeft = 1;
constexpr std::size_t kRight = 9;
constexpr std::size_t kActual = 3;
constexpr std::size_t kDistance = 6;
constexpr std::size_t kAngle = 7;
constexpr std::size_t kJoints = kFixedColumns;

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) {
    value *= factor;
  }
  return values;
}

report::PlotPanel hand_panel(const report::Table& table, const std::string& title,
                             std::size_t first) {
  report::PlotPanel panel{title, "position (m)", {}, 0.1};
  constexpr std::array kNames = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    panel.lines.push_back({kNames[i], table.column(first + kActual + i), false});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    panel.lines.push_back({i == 0 ? "wanted" : "", table.column(first + i), true});
  }
  return panel;
}

const char* verdict(double value, double bound) {
  return value < bound ? "kept" : "BROKEN";
}

}  // namespace

std::vector<std::string> table_names(const std::vector<std::string>& joints) {
  std::vector<std::string> names = {"time"};
  for (const char* hand : {"left", "right"}) {
    for (const char* column :
         {"x_wanted", "y_wanted", "z_wanted", "x", "y", "z", "position_error", "rotation_error"}) {
      names.push_back(fmt::format("{}_{}", hand, column));
    }
  }
  names.emplace_back("control_us");
  for (const char* quantity : {"q", "tau"}) {
    for (const std::string& joint : joints) {
      names.push_back(fmt::format("{}_{}", quantity, joint));
    }
  }
  return names;
}

Errors largest_errors(const report::Table& table) {
  return {largest(table.column(kLeft + kDistance)), largest(table.column(kLeft + kAngle)),
          largest(table.column(kRight + kDistance)), largest(table.column(kRight + kAngle))};
}

bool within_bounds(const Outcome& outcome) {
  const Errors errors = largest_errors(outcome.table);
  return errors.left_position < kLeftBound && errors.right_position < kRightBound;
}

std::string summary(const Outcome& outcome, const Plan& plan, bool realtime) {
  const Errors errors = largest_errors(outcome.table);
  const servo::DurationStatistics& control = outcome.control;
  const double median = 1e-3 * control.median();
  std::string text = fmt::format(
      "left hand    largest tracking error {:.2e} m (bound {:.0e}, {}), {:.2e} rad\n"
      "right hand   largest drift          {:.2e} m (bound {:.0e}, {}), {:.2e} rad\n",
      errors.left_position, kLeftBound, verdict(errors.left_position, kLeftBound),
      errors.left_rotation, errors.right_position, kRightBound,
      verdict(errors.right_position, kRightBound), errors.right_rotation);
  text += fmt::format(
      "control      median {:.2f} us, 99 % {:.2f} us, max {:.2f} us over {} cycles\n"
      "             thesis: {:.0f} us on a 266 MHz Pentium II, {:.0f} times the median here\n",
      median, 1e-3 * control.quantile(0.99), 1e-3 * control.maximum(), control.count(),
      kThesisMicroseconds, median > 0.0 ? kThesisMicroseconds / median : 0.0);
  if (realtime) {
    text += fmt::format(
        "period       {:.1f} us wanted; median {:.1f}, min {:.1f}, max {:.1f} us\n"
        "jitter       median {:.1f} us, 99 % {:.1f} us, max {:.1f} us; {} ticks skipped\n",
        1e6 / plan.rate, 1e-3 * outcome.periods.median(), 1e-3 * outcome.periods.minimum(),
        1e-3 * outcome.periods.maximum(), 1e-3 * outcome.jitters.median(),
        1e-3 * outcome.jitters.quantile(0.99), 1e-3 * outcome.jitters.maximum(), outcome.skips);
  } else {
    text += fmt::format(
        "period       {:.1f} us of simulated time, no jitter (--realtime measures "
        "the machine's)\n",
        1e6 / plan.rate);
  }
  return text;
}

report::Plot figure(const Outcome& outcome, const Plan& plan) {
  const report::Table& table = outcome.table;
  const std::size_t tau = kJoints + plan.joints.size();
  report::Plot plot;
  plot.title = "Left hand to the floor, right hand held, posture advised (Chang fig. 6.4)";
  plot.x_label = "time (s)";
  plot.x = table.column(0);
  plot.panels.push_back(hand_panel(table, "Left hand", kLeft));
  plot.panels.push_back(hand_panel(table, "Right hand", kRight));
  plot.panels.push_back({"Distance between wanted and actual position",
                         "distance (\u00b5m)",
                         {{"left hand", scaled(table.column(kLeft + kDistance), 1e6), false},
                          {"right hand", scaled(table.column(kRight + kDistance), 1e6), false}},
                         0.0});
  plot.panels.push_back(
      joint_panel(table, plan, "Posture: away from the advised one", "angle (rad)", kJoints, true));
  plot.panels.push_back(
      joint_panel(table, plan, "Joint torques that change most", "torque (N m)", tau, false));
  return plot;
}

}  // namespace treeline::experiments
