#include "three_arms.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "object_task_controller.hpp"
#include "puma_trio.hpp"
#include "puma_trio_joints.hpp"
#include "robot_with_object.hpp"
#include "run_with_object.hpp"

namespace treeline::experiments {
namespace {

constexpr int kArms = 3;
constexpr double kStart[6] = {0.0, -0.9, 2.9, 0.0, 1.1415926535897931, 0.0};  ///< of each arm

struct Generated {
  static constexpr int kCoordinates = puma_trio::kCoordinates;
  static constexpr int kVelocities = puma_trio::kVelocities;
  static constexpr auto& object_state = puma_trio::object_state;
  static constexpr auto& object_control_torque = puma_trio::object_control_torque;
  static constexpr auto& object_forward_dynamics = puma_trio::object_forward_dynamics;
};
using Arms = RobotWithObject<Generated, kArms>;
/// Eighteen joints for eighteen rows leave no posture to advise.
using Controller = ObjectTaskController<Arms, NoPosture<Arms>>;
using Internal = std::array<double, Arms::kInternal>;
constexpr int nv = Arms::kVelocities;

enum Column : std::size_t {
  kActing = kOwnColumns,
  kCommanded = kActing + 4,
  kJoints = kCommanded + 4,
  kColumns = kJoints + Arms::kCoordinates
};

Internal commanded_internal(const ThreeArmsPlan& plan) {
  Internal internal{};
  std::copy(std::begin(plan.tensions), std::end(plan.tensions), internal.begin());
  return internal;
}

/// Appends a cycle. Forces are those at its beginning under `held`, the torque of the cycle before.
void record(const servo::Report<Arms>& report, const Controller& controller,
            const Internal& commanded, const double (&held)[nv], report::Table& table) {
  double qdd[nv], xdd[6], forces[6 * kArms], internal[Arms::kInternal];
  puma_trio::object_forward_dynamics(report.state.q, report.state.qd, held, kStabilisation, qdd,
                                     xdd, forces, internal);
  double row[kColumns] = {};
  fill_object_columns(report.time, controller.tracking(), row);
  for (std::size_t i = 0; i < 3; ++i) {
    row[kActing + i] = internal[i];
    row[kCommanded + i] = commanded[i];
  }
  for (std::size_t i = 3; i < commanded.size(); ++i) {
    row[kActing + 3] = std::max(row[kActing + 3], std::abs(internal[i]));
  }
  std::copy(std::begin(report.state.q), std::end(report.state.q), row + kJoints);
  table.append(row);
}

servo::StateOf<Arms> start_state() {
  servo::StateOf<Arms> state;
  for (int i = 0; i < Arms::kCoordinates; ++i) state.q[i] = kStart[i % 6];
  return state;
}

}  // namespace

ThreeArmsOutcome carry_with_three_arms(const ThreeArmsPlan& plan) {
  const servo::StateOf<Arms> start = start_state();
  servo::SimulatedRobot<Arms> robot(start, plan.substeps);
  const Internal commanded = commanded_internal(plan);
  Controller controller({plan.stiffness, plan.damping}, {}, commanded);
  servo::SimulatedClock clock;
  servo::LoopSettings settings;
  settings.rate = plan.rate;
  const auto limits = servo::limits_of(puma_trio::kLowerLimits, puma_trio::kUpperLimits,
                                       puma_trio::kVelocityLimits, puma_trio::kEffortLimits);
  const double back = 2.0 * plan.lead + plan.duration;
  const double total = back + plan.duration + plan.lead;
  ThreeArmsOutcome outcome{make_outcome(
      report::with_coordinates(
          {"tension_12", "tension_23", "tension_31", "largest_moment", "tension_12_commanded",
           "tension_23_commanded", "tension_31_commanded", "moments_commanded"},
          Arms::kCoordinates),
      total, plan.rate)};
  const Script script = {
      {plan.lead, move_object<Arms>(start, plan.shift, plan.turn, plan.duration)},
      {back, move_object<Arms>(start, {0.0, 0.0, 0.0}, 0.0, plan.duration)},
      {total, servo::message_of(servo::MessageKind::disconnect)}};
  run_with_object<Arms>(
      robot, controller, clock, settings, limits, script,
      [&](const auto& report, const double(&held)[nv]) {
        record(report, controller, commanded, held, outcome.table);
      },
      outcome);
  return outcome;
}

ThreeArmsErrors largest_errors(const ThreeArmsOutcome& outcome) {
  const report::Table& table = outcome.table;
  ThreeArmsErrors errors{largest_object_errors(table), 0.0, largest(table, kActing + 3)};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t i = 0; i < 3; ++i) {
      errors.tensions = std::max(
          errors.tensions, std::abs(table.at(row, kActing + i) - table.at(row, kCommanded + i)));
    }
  }
  return errors;
}

bool within_bounds(const ThreeArmsOutcome& outcome) {
  const ThreeArmsErrors errors = largest_errors(outcome);
  return !outcome.fault && errors.object.position < 1e-4 && errors.object.rotation < 1e-3 &&
         errors.tensions < 0.1 && errors.moments < 0.1 && errors.object.drift < 1e-9 &&
         errors.object.lift > 0.08;
}

std::string summary(const ThreeArmsOutcome& outcome) {
  const ThreeArmsErrors errors = largest_errors(outcome);
  const servo::DurationStatistics& control = outcome.control;
  return describe_stop(outcome.fault, puma_trio::kCoordinateJoints) +
         fmt::format(
             "beam         largest tracking error {:.2e} m, {:.2e} rad (bounds 1e-4, 1e-3), lifted "
             "{:.3f} m\n"
             "internal     tensions off by at most {:.2e} N, moments by {:.2e} N m (bounds 0.1)\n"
             "drift        between the grasps {:.2e} (bound 1e-9)\n"
             "control      of three arms: median {:.2f} us, 99 % {:.2f} us over {} cycles\n"
             "bounds       {}\n",
             errors.object.position, errors.object.rotation, errors.object.lift, errors.tensions,
             errors.moments, errors.object.drift, 1e-3 * control.median(),
             1e-3 * control.quantile(0.99), control.count(),
             within_bounds(outcome) ? "kept" : "BROKEN");
}

std::string page_table(const ThreeArmsOutcome& outcome) {
  const ThreeArmsErrors errors = largest_errors(outcome);
  return fmt::format(
      "| over {:.1f} s | |\n|---|---|\n"
      "| beam, worst error | {:.1e} m, {:.1e} rad |\n"
      "| tensions and internal moments, worst error (after a cycle under one torque) | {:.0f} mN, "
      "{:.1f} mN m |\n"
      "| drift between the grasps, m and rad | {} |\n",
      outcome.table.column(kTime).back(), errors.object.position, errors.object.rotation,
      1e3 * errors.tensions, 1e3 * errors.moments, describe_drift(errors.object));
}

report::Plot figure(const ThreeArmsOutcome& outcome) {
  const report::Table& table = outcome.table;
  report::Plot plot;
  plot.title = "Three arms carry one beam (Chang section 7.2)";
  plot.x_label = "time (s)";
  plot.x = table.column(kTime);
  constexpr std::array kNames = {"x", "y", "z"};
  constexpr std::array kRods = {"rod 12", "rod 23", "rod 31"};
  report::PlotPanel beam{"Beam", "position (m)", {}, 0.1};
  report::PlotPanel tensions{"Internal forces: tensions", "force (N)", {}, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    beam.lines.push_back({kNames[i], table.column(kActual + i), false});
    tensions.lines.push_back({kRods[i], table.column(kActing + i), false});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    beam.lines.push_back({i == 0 ? "wanted" : "", table.column(kWanted + i), true});
    tensions.lines.push_back({i == 0 ? "commanded" : "", table.column(kCommanded + i), true});
  }
  plot.panels.push_back(std::move(beam));
  plot.panels.push_back(distance_panel(table, "beam"));
  plot.panels.push_back(std::move(tensions));
  return plot;
}

}  // namespace treeline::experiments
