#pragma once

#include <memory>

#include "servo/loop.hpp"

namespace treeline::servo {

/// What is left of a run.
struct RunEnd {
  Fault fault;                 ///< that ended it, if any
  DurationStatistics control;  ///< time of the controller
};

/// Starts a loop, lets it control for `seconds` (of the loop's time, both ends included), and
/// disconnects; a fault ends it before. `observe(const Report<F>&)` is called in every cycle that
/// controlled, before the robot moves on. It may push messages into `mailbox`.
template <RobotFunctions F, RobotProxy<F> Proxy, Controller<F> ControllerType, Clock ClockType,
          class Observer>
RunEnd run_for(double seconds, const LoopSettings& settings,
               const SafetyLimits<F::kCoordinates, F::kVelocities>& limits, Proxy& robot,
               ControllerType& controller, ClockType& clock, Mailbox& mailbox, Observer&& observe) {
  auto loop = std::make_unique<ServoLoop<F, Proxy, ControllerType, ClockType>>(
      settings, limits, robot, controller, clock, mailbox);
  Message message;
  message.kind = MessageKind::start;
  mailbox.push(message);
  message.kind = MessageKind::disconnect;
  const double last = seconds - 0.5 / settings.rate;  // the time of a cycle is rounded
  bool leaving = false;
  loop->run([&](const Report<F>& report) {
    if (report.mode == Mode::running) {
      observe(report);
    }
    if (!leaving && (report.time >= last || report.mode == Mode::faulted)) {
      leaving = mailbox.push(message);
    }
  });
  return {loop->fault(), loop->control_times()};
}

}  // namespace treeline::servo
