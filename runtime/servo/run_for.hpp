#pragma once

#include <memory>
#include <type_traits>

#include "servo/loop.hpp"

namespace treeline::servo {

/// Fault and measurements of a run that has ended.
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

/// A controller that is a function of time and state, for programs that send no messages:
/// bool law(time, state, tau), false ends the run.
template <RobotFunctions F, class Law>
class LawController {
 public:
  explicit LawController(Law& law) noexcept : law_(law) {}
  void start(double, const StateOf<F>&) noexcept {}
  void apply(double, const Message&) noexcept {}
  void control(double time, const StateOf<F>& state, double (&tau)[F::kVelocities]) {
    goes_on_ = law_(time, state, tau) && goes_on_;
  }
  bool goes_on() const noexcept { return goes_on_; }

 private:
  Law& law_;
  bool goes_on_ = true;
};

/// Lets a law control a robot `rate` times a second of simulated time, for `seconds`, both ends
/// included, or until it ends
/// the run or the loop faults.
template <RobotFunctions F, RobotProxy<F> Proxy, class Law>
RunEnd run_law(double seconds, double rate,
               const SafetyLimits<F::kCoordinates, F::kVelocities>& limits, Proxy& robot,
               Law&& law) {
  LoopSettings settings;
  settings.rate = rate;
  settings.longest_braking = 0.0;  // what follows is of no interest
  LawController<F, std::remove_reference_t<Law>> controller(law);
  SimulatedClock clock;
  Mailbox mailbox;
  return run_for<F>(seconds, settings, limits, robot, controller, clock, mailbox,
                    [&](const Report<F>&) {
                      if (!controller.goes_on()) mailbox.push(message_of(MessageKind::disconnect));
                    });
}

}  // namespace treeline::servo
