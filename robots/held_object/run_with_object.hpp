#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "core/orientation.hpp"
#include "servo/loop.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::experiments {

/// Messages, and the times from which on they are sent, s. The last one ends the run, and is the
/// next one at a fault.
using Script = std::vector<std::pair<double, servo::Message>>;

/// Runs the script on the simulated robot F, which holds an object. `record(report, held)` is
/// called for each cycle in which the loop controls. `held` is the torque of the cycle before: it
/// acts when the report's state is measured. The outcome's fault and control times are set.
template <class F, class Controller, servo::Clock ClockType, class Record, class Outcome>
void run_with_object(servo::SimulatedRobot<F>& robot, Controller& controller, ClockType& clock,
                     const servo::LoopSettings& settings,
                     const servo::SafetyLimits<F::kCoordinates, F::kVelocities>& limits,
                     const Script& script, const Record& record, Outcome& outcome) {
  using Robot = servo::SimulatedRobot<F>;
  servo::Mailbox mailbox;
  auto loop = std::make_unique<servo::ServoLoop<F, Robot, Controller, ClockType>>(
      settings, limits, robot, controller, clock, mailbox);
  std::size_t next = 0;
  double held[F::kVelocities] = {};
  bool holding = false;
  mailbox.push(servo::message_of(servo::MessageKind::start));
  loop->run([&](const servo::Report<F>& report) {
    if (report.mode == servo::Mode::running) {
      record(report, holding ? held : report.tau);
      std::copy(std::begin(report.tau), std::end(report.tau), held);
      holding = true;
    }
    if (next == script.size()) return;
    const bool faulted = report.mode == servo::Mode::faulted;
    if (faulted) next = script.size() - 1;
    if ((faulted || report.time >= script[next].first) && mailbox.push(script[next].second)) ++next;
  });
  outcome.fault = loop->fault();
  outcome.control = loop->control_times();
}

/// Message that moves the object to the pose that it has in `state`, shifted by m and turned about
/// the vertical by rad.
template <class F>
servo::Message move_object(const servo::StateOf<F>& state, const double (&shift)[3], double turn,
                           double duration) {
  double position[3], rotation[9], velocity[6], drift[F::kDrift], rate[F::kDrift];
  F::object_state(state.q, state.qd, position, rotation, velocity, drift, rate);
  const double vector[3] = {0.0, 0.0, turn};
  double turned[9];
  core::rotation_from_vector(vector, turned);
  servo::Message message = servo::message_of(servo::MessageKind::move_point);
  message.index = 0;
  message.duration = duration;
  for (std::size_t i = 0; i < 3; ++i) message.values[i] = position[i] + shift[i];
  std::copy(std::begin(turned), std::end(turned), message.values.begin() + 3);
  return message;
}

}  // namespace treeline::experiments
