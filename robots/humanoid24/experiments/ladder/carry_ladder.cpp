#include "carry_ladder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "close_grasp.hpp"
#include "humanoid_pair.hpp"
#include "humanoid_pair_joints.hpp"
#include "object_task_controller.hpp"
#include "robot_with_object.hpp"
#include "run_with_object.hpp"

namespace treeline::experiments {
namespace {

constexpr int kHands = 4;
constexpr int kJoints = humanoid_pair::kVelocities / 2;

struct Generated {
  static constexpr int kCoordinates = humanoid_pair::kCoordinates;
  static constexpr int kVelocities = humanoid_pair::kVelocities;
  static constexpr auto& mass_matrix = humanoid_pair::mass_matrix;
  static constexpr auto& object_state = humanoid_pair::object_state;
  static constexpr auto& object_control_torque = humanoid_pair::object_control_torque;
  static constexpr auto& object_forward_dynamics = humanoid_pair::object_forward_dynamics;
};
using Humanoids = RobotWithObject<Generated, kHands>;
using Controller = ObjectTaskController<Humanoids>;
constexpr int nv = Humanoids::kVelocities;

/// Posture of each humanoid at the start, as for `put_box`: hands before the body at 1.1 m.
constexpr double kStart[kJoints] = {0.3969,  -0.9523, 0.1667, 0,       0.6163,  0,
                                    -1.2661, -0.1319, 0.0595, -0.5180, 0.0329,  1.0512,
                                    0.1723,  -1.2662, 0.1319, -0.0594, -0.5180, -0.0330,
                                    1.0512,  -0.1723, 0,      0,       0,       0};
constexpr int kLeftRoll = 7, kLeftYaw = 8, kRightRoll = 14, kRightYaw = 15;  ///< of a shoulder
/// Turns of the shoulders that keep the upper arms off the chest, first and second, rad: the
/// second's end of the ladder goes farther aside.
constexpr double kElbowsOut[2] = {0.3, 0.35}, kArmsIn = 0.2;
/// Springs of the posture, N m/rad: legs and waist, arms, head.
constexpr double kSprings[kJoints] = {200, 200, 200, 10, 300, 10, 20, 55, 55, 27, 5, 5,
                                      5,   20,  55,  55, 27,  5,  5,  5,  5,  5,  1, 1};

enum Column : std::size_t {
  kSqueeze = kOwnColumns,
  kCommanded = kSqueeze + 2,
  kInternalError,
  kCoordinates,
  kColumns = kCoordinates + Humanoids::kCoordinates
};
/// Rods of the virtual linkage between the hands of one humanoid: 12 and 34.
constexpr std::array<std::size_t, 2> kOwnRods = {0, 5};

std::array<double, Humanoids::kInternal> commanded_internal(const LadderPlan& plan) {
  std::array<double, Humanoids::kInternal> internal{};
  for (const std::size_t rod : kOwnRods) internal[rod] = -plan.squeeze;
  return internal;
}

Controller make_controller(const LadderPlan& plan) {
  std::array<double, nv> springs{};
  for (std::size_t i = 0; i < springs.size(); ++i) springs[i] = kSprings[i % kJoints];
  return {{plan.stiffness, plan.damping}, {springs, 1.0}, commanded_internal(plan)};
}

servo::StateOf<Humanoids> start_state() {
  servo::StateOf<Humanoids> state;
  for (int i = 0; i < Humanoids::kCoordinates; ++i) state.q[i] = kStart[i % kJoints];
  for (int robot = 0; robot < 2; ++robot) {
    double* q = state.q + robot * kJoints;
    q[kLeftRoll] += kElbowsOut[robot];
    q[kRightRoll] -= kElbowsOut[robot];
    q[kLeftYaw] -= kArmsIn;
    q[kRightYaw] += kArmsIn;
  }
  close_grasp<Humanoids>(state.q);
  return state;
}

/// Appends a cycle. Forces are those at its beginning under `held`, the torque of the cycle before.
void record(const servo::Report<Humanoids>& report, const Controller& controller,
            const std::array<double, Humanoids::kInternal>& commanded, const double (&held)[nv],
            report::Table& table) {
  double qdd[nv], xdd[6], forces[6 * kHands], internal[Humanoids::kInternal];
  humanoid_pair::object_forward_dynamics(report.state.q, report.state.qd, held, kStabilisation, qdd,
                                         xdd, forces, internal);
  double row[kColumns] = {};
  fill_object_columns(report.time, controller.tracking(), row);
  for (std::size_t i = 0; i < kOwnRods.size(); ++i) row[kSqueeze + i] = internal[kOwnRods[i]];
  row[kCommanded] = commanded[kOwnRods[0]];
  for (std::size_t i = 0; i < commanded.size(); ++i) {
    row[kInternalError] = std::max(row[kInternalError], std::abs(internal[i] - commanded[i]));
  }
  std::copy(std::begin(report.state.q), std::end(report.state.q), row + kCoordinates);
  table.append(row);
}

std::vector<std::string> column_names() {
  std::vector<std::string> names = {"squeeze_first", "squeeze_second", "squeeze_commanded",
                                    "internal_error"};
  for (const char* joint : humanoid_pair::kCoordinateJoints) {
    names.push_back(std::string("q_") + joint);
  }
  return names;
}

}  // namespace

LadderOutcome carry_ladder(const LadderPlan& plan) {
  const servo::StateOf<Humanoids> start = start_state();
  servo::SimulatedRobot<Humanoids> robot(start, plan.substeps);
  Controller controller = make_controller(plan);
  servo::SimulatedClock clock;
  servo::LoopSettings settings;
  settings.rate = plan.rate;
  const auto limits =
      servo::limits_of(humanoid_pair::kLowerLimits, humanoid_pair::kUpperLimits,
                       humanoid_pair::kVelocityLimits, humanoid_pair::kEffortLimits);
  const double total = 2.0 * plan.lead + plan.duration;
  LadderOutcome outcome{make_outcome(column_names(), total, plan.rate)};
  const auto commanded = commanded_internal(plan);
  const Script script = {
      {plan.lead, move_object<Humanoids>(start, plan.shift, plan.turn, plan.duration)},
      {total, servo::message_of(servo::MessageKind::disconnect)}};
  run_with_object<Humanoids>(
      robot, controller, clock, settings, limits, script,
      [&](const auto& report, const double(&held)[nv]) {
        record(report, controller, commanded, held, outcome.table);
      },
      outcome);
  return outcome;
}

LadderErrors largest_errors(const LadderOutcome& outcome) {
  return {largest_object_errors(outcome.table), largest(outcome.table, kInternalError)};
}

bool within_bounds(const LadderOutcome& outcome) {
  const LadderErrors errors = largest_errors(outcome);
  return !outcome.fault && errors.object.position < 1e-4 && errors.object.rotation < 1e-3 &&
         errors.internal < 1.0 && errors.object.drift < 1e-9 && errors.object.lift > 0.06;
}

std::string summary(const LadderOutcome& outcome) {
  const LadderErrors errors = largest_errors(outcome);
  const servo::DurationStatistics& control = outcome.control;
  return describe_stop(outcome.fault, humanoid_pair::kCoordinateJoints) +
         fmt::format(
             "ladder       largest tracking error {:.2e} m, {:.2e} rad (bounds 1e-4, 1e-3), lifted "
             "{:.3f} m\n"
             "internal     forces and moments off by at most {:.2e} (bound 1)\n"
             "drift        between the grasps {:.2e} (bound 1e-9)\n"
             "control      of both humanoids: median {:.2f} us, 99 % {:.2f} us over {} cycles\n"
             "bounds       {}\n",
             errors.object.position, errors.object.rotation, errors.object.lift, errors.internal,
             errors.object.drift, 1e-3 * control.median(), 1e-3 * control.quantile(0.99),
             control.count(), within_bounds(outcome) ? "kept" : "BROKEN");
}

std::string page_table(const LadderOutcome& outcome) {
  const LadderErrors errors = largest_errors(outcome);
  return fmt::format(
      "| over {:.1f} s | |\n|---|---|\n"
      "| ladder, worst error | {:.1e} m, {:.1e} rad |\n"
      "| tensions (N) and internal moments (N m), worst error (after a cycle under one torque) | "
      "{:.3f} |\n"
      "| drift between the grasps, m and rad | {} |\n",
      outcome.table.column(kTime).back(), errors.object.position, errors.object.rotation,
      errors.internal, describe_drift(errors.object));
}

report::Plot figure(const LadderOutcome& outcome) {
  const report::Table& table = outcome.table;
  report::Plot plot;
  plot.title = "Two humanoids carry a ladder (Chang section 7.1)";
  plot.x_label = "time (s)";
  plot.x = table.column(kTime);
  constexpr std::array kNames = {"x", "y", "z"};
  report::PlotPanel ladder{"Ladder", "position (m)", {}, 0.1};
  for (std::size_t i = 0; i < 3; ++i) {
    ladder.lines.push_back({kNames[i], table.column(kActual + i), false});
    ladder.lines.push_back({i == 0 ? "wanted" : "", table.column(kWanted + i), true});
  }
  plot.panels.push_back(std::move(ladder));
  plot.panels.push_back(distance_panel(table, "ladder"));
  plot.panels.push_back({"Internal forces between the hands of each",
                         "tension (N)",
                         {{"first", table.column(kSqueeze), false},
                          {"second", table.column(kSqueeze + 1), false},
                          {"commanded", table.column(kCommanded), true}},
                         1.0});
  return plot;
}

}  // namespace treeline::experiments
