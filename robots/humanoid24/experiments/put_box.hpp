#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "box_outcome.hpp"
#include "close_grasp.hpp"
#include "object_task_controller.hpp"
#include "robot_with_object.hpp"
#include "run_with_object.hpp"
#include "touch_floor.hpp"

namespace treeline::experiments {

template <class F>
ObjectTaskController<F> make_object_controller(const BoxPlan& plan) {
  std::array<double, F::kVelocities> springs;
  std::copy(plan.run.posture_stiffness.begin(), plan.run.posture_stiffness.end(), springs.begin());
  return {{plan.run.stiffness, plan.run.damping}, {springs, plan.posture_damping}, plan.internal};
}

/// Appends one cycle as a row of the outcome's table, in the order of `box_table_names`. The
/// internal forces are those at the cycle's beginning under `held`, the torque computed one cycle
/// before, where the effect of holding it is largest.
template <class F>
void record_box(const servo::Report<F>& report, const ObjectTaskController<F>& controller,
                const double (&held)[F::kVelocities], report::Table& table) noexcept {
  constexpr int nv = F::kVelocities;
  double row[kBoxColumns + 2 * nv];
  int at = 0;
  row[at++] = report.time;
  const auto& tracking = controller.tracking();
  for (const double x : tracking.wanted.position) {
    row[at++] = x;
  }
  for (const double x : tracking.position) {
    row[at++] = x;
  }
  const auto norm = [](const double* v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  };
  row[at++] = norm(tracking.error);
  row[at++] = norm(tracking.error + 3);
  row[at++] = norm(tracking.drift);
  row[at++] = norm(tracking.drift + 3);
  double qdd[nv];
  double xdd[6];
  double f_grasp[12];
  double internal[6];
  F::object_forward_dynamics(report.state.q, report.state.qd, held, kStabilisation, qdd, xdd,
                             f_grasp, internal);
  for (const double force : internal) {
    row[at++] = force;
  }
  row[at++] = 1e-3 * static_cast<double>(report.control_nanoseconds);
  for (int i = 0; i < nv; ++i) {
    row[at++] = report.state.q[i];
  }
  for (int i = 0; i < nv; ++i) {
    row[at++] = report.tau[i];
  }
  table.append(row);
}

/// Message that moves the box upright to the plan's target.
inline servo::Message put_message(const BoxPlan& plan) {
  servo::Message message = servo::message_of(servo::MessageKind::move_point);
  message.index = 0;
  message.duration = plan.run.duration;
  constexpr double kUpright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::copy(plan.run.target.begin(), plan.run.target.end(), message.values.begin());
  std::copy(std::begin(kUpright), std::end(kUpright), message.values.begin() + 3);
  return message;
}

/// Runs the plan on the simulated closed chain F with `clock`: start, hold for the lead, move,
/// settle, stop, end.
template <class F, servo::Clock ClockType>
BoxOutcome put_box(const BoxPlan& plan, const RunSettings& settings, const JointLimits& limits,
                   ClockType& clock) {
  servo::StateOf<F> initial;
  std::copy(plan.run.start.begin(), plan.run.start.end(), std::begin(initial.q));
  const double gap = close_grasp<F>(initial.q);
  servo::SimulatedRobot<F> robot(initial, settings.substeps);
  ObjectTaskController<F> controller = make_object_controller<F>(plan);
  servo::LoopSettings loop_settings;
  loop_settings.rate = plan.run.rate;
  const double total = settings.lead + plan.run.duration + plan.run.settle;
  BoxOutcome outcome(box_table_names(plan.run.joints),
                     static_cast<std::size_t>(total * plan.run.rate) + 2);
  outcome.initial_gap = gap;
  const auto record = [&](const servo::Report<F>& report, const double(&held)[F::kVelocities]) {
    record_box<F>(report, controller, held, outcome.table);
  };
  const Script script = {{settings.lead, put_message(plan)},
                         {total, servo::message_of(servo::MessageKind::disconnect)}};
  run_with_object<F>(robot, controller, clock, loop_settings, safety_limits<F>(limits), script,
                     record, outcome);
  return outcome;
}

}  // namespace treeline::experiments
