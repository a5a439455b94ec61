#include "box_outcome.hpp"

#include <fmt/core.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "joint_panel.hpp"

namespace treeline::experiments {
namespace {

constexpr std::size_t kActual = 4;
constexpr std::size_t kErrors = 7;
constexpr std::size_t kDrift = 9;
constexpr std::size_t kInternal = 11;
constexpr std::size_t kJoints = kBoxColumns;

double largest(const std::vector<double>& values, double from = 0.0) {
  double result = 0.0;
  for (const double value : values) {
    result = std::max(result, std::abs(value - from));
  }
  return result;
}

std::vector<double> scaled(std::vector<double> values, double factor, double from = 0.0) {
  for (double& value : values) {
    value = factor * (value - from);
  }
  return values;
}

const char* verdict(double value, double bound) {
  return value < bound ? "kept" : "BROKEN";
}

}  // namespace

bool read_box_plan(const std::string& path, BoxPlan& plan, std::string& error) {
  if (!read_plan(path, plan.run, error, "box")) {
    return false;
  }
  try {
    const YAML::Node root = YAML::LoadFile(path);
    plan.posture_damping = root["posture_damping"].as<double>();
    plan.internal = root["internal"].as<std::array<double, 6>>();
  } catch (const YAML::Exception& exception) {
    error = fmt::format("{}: {}", path, exception.what());
    return false;
  }
  return true;
}

std::vector<std::string> box_table_names(const std::vector<std::string>& joints) {
  std::vector<std::string> names = {"time",
                                    "x_wanted",
                                    "y_wanted",
                                    "z_wanted",
                                    "x",
                                    "y",
                                    "z",
                                    "position_error",
                                    "rotation_error",
                                    "drift",
                                    "drift_rotation",
                                    "tension",
                                    "torsion",
                                    "left_moment_y",
                                    "left_moment_z",
                                    "right_moment_y",
                                    "right_moment_z",
                                    "control_us"};
  for (const char* quantity : {"q", "tau"}) {
    for (const std::string& joint : joints) {
      names.push_back(fmt::format("{}_{}", quantity, joint));
    }
  }
  return names;
}

BoxErrors largest_box_errors(const BoxOutcome& outcome, const BoxPlan& plan) {
  const report::Table& table = outcome.table;
  BoxErrors errors;
  errors.position = largest(table.column(kErrors));
  errors.rotation = largest(table.column(kErrors + 1));
  errors.drift = largest(table.column(kDrift));
  errors.drift_rotation = largest(table.column(kDrift + 1));
  const std::size_t last = table.rows() - 1;
  for (std::size_t i = kJoints; i < kJoints + plan.run.joints.size(); ++i) {
    const double turned = std::abs(table.at(last, i) - table.at(last - 1, i));
    errors.final_speed = std::max(errors.final_speed, turned * plan.run.rate);
  }
  errors.internal_force = largest(table.column(kInternal), plan.internal[0]);
  for (std::size_t i = 1; i < 6; ++i) {
    errors.internal_moment =
        std::max(errors.internal_moment, largest(table.column(kInternal + i), plan.internal[i]));
  }
  return errors;
}

bool box_within_bounds(const BoxErrors& errors) {
  return errors.position < kBoxPositionBound && errors.internal_force < kBoxForceBound &&
         errors.internal_moment < kBoxForceBound && errors.drift < kBoxDriftBound &&
         errors.drift_rotation < kBoxDriftBound;
}

bool box_rests(const BoxErrors& errors) {
  return errors.final_speed < kBoxRestBound;
}

std::string box_summary(const BoxOutcome& outcome, const BoxPlan& plan) {
  const BoxErrors errors = largest_box_errors(outcome, plan);
  const servo::DurationStatistics& control = outcome.control;
  const double median = 1e-3 * control.median();
  std::string text =
      fmt::format("box          largest tracking error {:.2e} m (bound {:.0e}, {}), {:.2e} rad\n",
                  errors.position, kBoxPositionBound, verdict(errors.position, kBoxPositionBound),
                  errors.rotation);
  text += fmt::format(
      "squeeze      {:.1f} N commanded; tension off by at most {:.2e} N, moments by {:.2e} N m "
      "(bound {:.0e}, {})\n",
      -plan.internal[0], errors.internal_force, errors.internal_moment, kBoxForceBound,
      verdict(std::max(errors.internal_force, errors.internal_moment), kBoxForceBound));
  text += fmt::format(
      "drift        of the right grasp against the left: {:.2e} m, {:.2e} rad (bound {:.0e}, {}); "
      "at the start {:.1e}\n",
      errors.drift, errors.drift_rotation, kBoxDriftBound,
      verdict(std::max(errors.drift, errors.drift_rotation), kBoxDriftBound), outcome.initial_gap);
  text +=
      fmt::format("at the end   the fastest joint turns at {:.4f} rad/s (bound {}, {})\n",
                  errors.final_speed, kBoxRestBound, verdict(errors.final_speed, kBoxRestBound));
  text += fmt::format(
      "control      median {:.2f} us, 99 % {:.2f} us, max {:.2f} us over {} cycles\n"
      "             thesis: {:.0f} us on a 266 MHz Pentium II, {:.0f} times the median here\n",
      median, 1e-3 * control.quantile(0.99), 1e-3 * control.maximum(), control.count(),
      kBoxThesisMicroseconds, median > 0.0 ? kBoxThesisMicroseconds / median : 0.0);
  return text;
}

report::Plot box_figure(const BoxOutcome& outcome, const BoxPlan& plan) {
  const report::Table& table = outcome.table;
  report::Plot plot;
  plot.title = "Box to the floor in both hands, posture advised (Chang fig. 7.10)";
  plot.x_label = "time (s)";
  plot.x = table.column(0);
  report::PlotPanel box{"Box", "position (m)", {}, 0.1};
  constexpr std::array kNames = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    box.lines.push_back({kNames[i], table.column(kActual + i), false});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    box.lines.push_back({i == 0 ? "wanted" : "", table.column(1 + i), true});
  }
  plot.panels.push_back(std::move(box));
  plot.panels.push_back({"Distance between wanted and actual position",
                         "distance (\u00b5m)",
                         {{"box", scaled(table.column(kErrors), 1e6), false}},
                         0.0});
  plot.panels.push_back({"Internal force between the hands: commanded and acting",
                         "tension (N)",
                         {{"tension", table.column(kInternal), false},
                          {"commanded", std::vector<double>(table.rows(), plan.internal[0]), true}},
                         10.0});
  plot.panels.push_back(
      {"Internal forces less the commanded ones, after a cycle under one torque",
       "(mN, mN m)",
       {{"tension", scaled(table.column(kInternal), 1e3, plan.internal[0]), false},
        {"torsion", scaled(table.column(kInternal + 1), 1e3, plan.internal[1]), false},
        {"bending, left", scaled(table.column(kInternal + 2), 1e3, plan.internal[2]), false}},
       0.0});
  plot.panels.push_back({"Drift of the right grasp against the left",
                         "(fm, 1e-15 rad)",
                         {{"position", scaled(table.column(kDrift), 1e15), false},
                          {"rotation", scaled(table.column(kDrift + 1), 1e15), false}},
                         0.0});
  plot.panels.push_back(joint_panel(table, plan.run, "Posture: away from the advised one",
                                    "angle (rad)", kJoints, true));
  plot.panels.push_back(joint_panel(table, plan.run, "Joint torques that change most",
                                    "torque (N m)", kJoints + plan.run.joints.size(), false));
  return plot;
}

}  // namespace treeline::experiments
