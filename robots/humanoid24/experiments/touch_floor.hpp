#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "outcome.hpp"
#include "plan.hpp"
#include "report/table.hpp"
#include "servo/loop.hpp"
#include "servo/pose_task_controller.hpp"
#include "servo/simulated_robot.hpp"
#include "servo/spring_posture.hpp"

namespace treeline::experiments {

/// Settings of a run.
struct RunSettings {
  double lead = 0.25;  ///< s for which both hands hold before the left one moves
  int substeps = 4;    ///< integration steps per cycle
};

template <class F>
servo::SafetyLimits<F::kCoordinates, F::kVelocities> safety_limits(const JointLimits& joints) {
  servo::SafetyLimits<F::kCoordinates, F::kVelocities> limits;
  for (std::size_t i = 0; i < joints.lower.size(); ++i) {
    limits.lower[i] = joints.lower[i];
    limits.upper[i] = joints.upper[i];
    limits.velocity[i] = joints.velocity[i];
    limits.torque[i] = joints.effort[i];
  }
  return limits;
}

template <class F>
using TouchController = servo::PoseTaskController<F, servo::SpringPosture<F>>;

/// The plan has springs.
template <class F>
TouchController<F> make_controller(const Plan& plan, const JointLimits& limits) {
  double lower[F::kVelocities];
  double upper[F::kVelocities];
  std::copy_n(limits.lower.begin(), F::kVelocities, lower);
  std::copy_n(limits.upper.begin(), F::kVelocities, upper);
  const servo::SpringSettings springs{plan.spring, 1.0, plan.limit_margin, plan.limit_strength,
                                      1.0 / plan.rate};
  return {{plan.stiffness, plan.damping}, {springs, lower, upper}};
}

/// Appends one cycle as a row of the outcome's table, in the order of `table_names`.
template <class F, class Controller>
void record(const servo::Report<F>& report, const Controller& controller, double time,
            report::Table& table) noexcept {
  constexpr int nv = F::kVelocities;
  double row[kFixedColumns + 2 * nv];
  int at = 0;
  row[at++] = time;
  for (int hand = 0; hand < 2; ++hand) {
    const auto& tracking = controller.tracking(hand);
    for (int i = 0; i < 3; ++i) {
      row[at++] = tracking.wanted.position[i];
    }
    for (int i = 0; i < 3; ++i) {
      row[at++] = tracking.position[i];
    }
    const double* e = tracking.error;
    row[at++] = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    row[at++] = std::sqrt(e[3] * e[3] + e[4] * e[4] + e[5] * e[5]);
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

/// Message that moves the left hand to its target on the floor and keeps its orientation.
template <class F>
servo::Message touch_message(const Plan& plan, const TouchController<F>& controller) {
  servo::Message message;
  message.kind = servo::MessageKind::move_point;
  message.index = 0;
  message.duration = plan.duration;
  std::copy(plan.target.begin(), plan.target.end(), message.values.begin());
  const auto& rotation = controller.tracking(0).wanted.rotation;
  std::copy(std::begin(rotation), std::end(rotation), message.values.begin() + 3);
  return message;
}

/// Runs the plan on the simulated robot F, whose operational points are the left and the right
/// hand, with `clock`: start, hold for the lead, move, settle, stop, end.
template <class F, servo::Clock ClockType>
Outcome touch_floor(const Plan& plan, const RunSettings& settings, const JointLimits& limits,
                    ClockType& clock) {
  using Robot = servo::SimulatedRobot<F>;
  using Controller = TouchController<F>;
  servo::StateOf<F> initial;
  std::copy(plan.start.begin(), plan.start.end(), std::begin(initial.q));
  Robot robot(initial, settings.substeps);
  Controller controller = make_controller<F>(plan, limits);
  servo::Mailbox mailbox;
  servo::LoopSettings loop_settings;
  loop_settings.rate = plan.rate;
  auto loop = std::make_unique<servo::ServoLoop<F, Robot, Controller, ClockType>>(
      loop_settings, safety_limits<F>(limits), robot, controller, clock, mailbox);

  const double total = settings.lead + plan.duration + plan.settle;
  Outcome outcome(table_names(plan.joints), static_cast<std::size_t>(total * plan.rate) + 2);
  bool moving = false;
  bool leaving = false;
  mailbox.push(servo::message_of(servo::MessageKind::start));
  loop->run([&](const servo::Report<F>& report) {
    if (report.mode == servo::Mode::running) {
      record(report, controller, report.time, outcome.table);
    }
    if (!moving && report.time >= settings.lead) {
      moving = mailbox.push(touch_message<F>(plan, controller));
    }
    if (!leaving && (report.time >= total || report.mode == servo::Mode::faulted)) {
      leaving = mailbox.push(servo::message_of(servo::MessageKind::disconnect));
    }
  });
  outcome.fault = loop->fault();
  outcome.control = loop->control_times();
  outcome.periods = loop->cycle().periods();
  outcome.jitters = loop->cycle().jitters();
  outcome.skips = loop->cycle().skips();
  return outcome;
}

}  // namespace treeline::experiments
