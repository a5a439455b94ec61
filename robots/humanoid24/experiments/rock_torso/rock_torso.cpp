#include "rock_torso.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "humanoid24_functions.hpp"
#include "joint_panel.hpp"
#include "servo/clock.hpp"
#include "servo/run_for.hpp"
#include "touch_floor.hpp"

namespace treeline::experiments {
namespace {

static_assert(Humanoid24::kVelocities == kRockingJoints);
using Robot = servo::SimulatedRobot<Humanoid24>;
using Controller = servo::PoseTaskController<Humanoid24>;

constexpr double kHandBound = 5e-6;             // m
constexpr double kFollowed = 0.6;               // of the advice
constexpr std::size_t kHandErrors[] = {7, 15};  // columns: distance, and angle after it
constexpr int kSubsteps = 4;

std::size_t joint_index(const Plan& pose, const char* name) {
  return static_cast<std::size_t>(std::find(pose.joints.begin(), pose.joints.end(), name) -
                                  pose.joints.begin());
}

/// The front end's message: the start with the waist turned.
servo::Message advise_message(const RockPlan& plan, const Plan& pose, double time) {
  servo::Message message;
  message.kind = servo::MessageKind::set_posture;
  std::copy(pose.start.begin(), pose.start.end(), message.values.begin());
  const WaistAdvice advice = advice_at(plan, time);
  message.values[joint_index(pose, "waist_roll")] += advice.roll;
  message.values[joint_index(pose, "waist_yaw")] += advice.yaw;
  return message;
}

double swing(const report::Table& table, std::size_t column) {
  const std::vector<double> values = table.column(column);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

}  // namespace

WaistAdvice advice_at(const RockPlan& plan, double time) noexcept {
  const double round = (time - plan.lead) / plan.period;
  if (!(round > 0.0 && round < plan.rounds)) {
    return {};
  }
  const double grown = std::min({round, plan.rounds - round, 1.0});
  const double side = grown * std::sin(2.0 * std::numbers::pi * round);
  return {plan.roll * side, plan.yaw * side};
}

Outcome rock_torso(const RockPlan& plan, const Plan& pose, const JointLimits& limits) {
  servo::StateOf<Humanoid24> initial;
  std::copy(pose.start.begin(), pose.start.end(), std::begin(initial.q));
  Robot robot(initial, kSubsteps);
  std::array<core::Gains<double>, Humanoid24::kVelocities> posture;
  posture.fill({plan.stiffness, 2.0 * std::sqrt(plan.stiffness)});
  Controller controller({pose.stiffness, pose.damping}, posture);
  servo::Mailbox mailbox;
  servo::SimulatedClock clock;
  servo::LoopSettings settings;
  settings.rate = plan.rate;
  Outcome outcome(table_names(pose.joints), static_cast<std::size_t>(plan.total() * plan.rate) + 2);
  double next_advice = plan.lead;
  const servo::RunEnd end = servo::run_for<Humanoid24>(
      plan.total(), settings, safety_limits<Humanoid24>(limits), robot, controller, clock, mailbox,
      [&](const servo::Report<Humanoid24>& report) {
        record(report, controller, report.time, outcome.table);
        if (report.time >= next_advice && mailbox.push(advise_message(plan, pose, report.time))) {
          next_advice += 1.0 / plan.advice_rate;
        }
      });
  outcome.fault = end.fault;
  outcome.control = end.control;
  return outcome;
}

RockFindings find_rocking(const Outcome& outcome, const Plan& pose) {
  const Errors errors = largest_errors(outcome.table);
  const auto of_joint = [&](const char* name) {
    return swing(outcome.table, kFixedColumns + joint_index(pose, name));
  };
  return {std::max(errors.left_position, errors.right_position),
          std::max(errors.left_rotation, errors.right_rotation), of_joint("waist_roll"),
          of_joint("waist_yaw")};
}

bool rocks_without_hands(const Outcome& outcome, const RockPlan& plan, const Plan& pose) {
  const RockFindings found = find_rocking(outcome, pose);
  return !outcome.fault && found.hands < kHandBound && found.roll > kFollowed * 2.0 * plan.roll &&
         found.yaw > kFollowed * 2.0 * plan.yaw;
}

std::string rock_summary(const Outcome& outcome, const RockPlan& plan, const Plan& pose) {
  const RockFindings found = find_rocking(outcome, pose);
  const servo::DurationStatistics& control = outcome.control;
  return fmt::format(
      "hands        off by at most {:.2e} m, {:.2e} rad (bound {:.0e} m)\n"
      "waist        rocks by {:.3f} rad of {:.3f} about x, {:.3f} of {:.3f} about z (bound {:.0f} "
      "%)\n"
      "control      median {:.2f} us over {} cycles\n"
      "claim        {}\n",
      found.hands, found.hands_rad, kHandBound, found.roll, 2.0 * plan.roll, found.yaw,
      2.0 * plan.yaw, 100.0 * kFollowed, 1e-3 * control.median(), control.count(),
      rocks_without_hands(outcome, plan, pose) ? "kept" : "BROKEN");
}

report::Plot rock_figure(const Outcome& outcome, const Plan& pose) {
  const report::Table& table = outcome.table;
  report::Plot plot;
  plot.title = "Both hands held, the torso rocks in their null space (Chang fig. 2.1, 2.3)";
  plot.x_label = "time (s)";
  plot.x = table.column(0);
  report::PlotPanel hands{"Hands: distance from their places", "distance (\u00b5m)", {}, 0.0};
  for (const std::size_t column : kHandErrors) {
    std::vector<double> error = table.column(column);
    for (double& value : error) {
      value *= 1e6;
    }
    hands.lines.push_back({column == kHandErrors[0] ? "left" : "right", std::move(error), false});
  }
  plot.panels.push_back(std::move(hands));
  plot.panels.push_back(
      joint_panel(table, pose, "Posture: away from the start", "angle (rad)", kFixedColumns, true));
  plot.panels.push_back(joint_panel(table, pose, "Joint torques that change most", "torque (N m)",
                                    kFixedColumns + pose.joints.size(), false));
  return plot;
}

}  // namespace treeline::experiments
