#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <iterator>

#include "servo/clock.hpp"
#include "servo/cycle.hpp"
#include "servo/message.hpp"
#include "servo/robot_proxy.hpp"
#include "servo/safety.hpp"
#include "servo/state_machine.hpp"
#include "servo/statistics.hpp"

namespace treeline::servo {

/// Requirements of the loop on a controller. Times are in s since the loop began. `start` is called
/// when control begins, with the initial state; `apply` with every message that does not concern
/// the loop itself; `control` once per cycle while running. If there is a `prepare()`, it is called
/// where the loop waits, shortly before the next cycle: it may load code and data into caches. None
/// of them may allocate or block.
template <class C, class F>
concept Controller = requires(C& controller, double time, const StateOf<F>& state,
                              const Message& message, double (&tau)[F::kVelocities]) {
  controller.start(time, state);
  controller.apply(time, message);
  controller.control(time, state, tau);
};

struct LoopSettings {
  double rate = 1000.0;          ///< Hz
  double braking = 20.0;         ///< 1/s: qdd = -braking qd in every mode except running
  double rest_speed = 1e-3;      ///< largest |qd| that counts as at rest, rad/s or m/s
  double longest_braking = 5.0;  ///< s until the loop ends after a disconnect, even if not at rest
  double prepare_lead = 1e-4;    ///< s before a cycle at which its controller prepares for it
  int messages_per_cycle = 4;    ///< largest number of messages applied in one cycle
};

/// Report of one cycle.
template <class F>
struct Report {
  std::int64_t cycle = 0;
  double time = 0.0;  ///< time of the measurement, s
  Mode mode = Mode::idle;
  Fault fault;  ///< first fault since the last reset
  StateOf<F> state;
  double tau[F::kVelocities] = {};
  CycleTiming timing;
  std::int64_t control_nanoseconds = 0;  ///< time of the controller alone; 0 unless running
};

/// Servo loop of Chang fig. 9.2 at a fixed rate. Each cycle receives messages, queues them, applies
/// the most urgent ones, checks safety, controls, and reports. The loop ends when the robot is
/// gone, or when the front end disconnects; it then brakes to rest first, for at most
/// `longest_braking`. Nothing is allocated after construction.
template <RobotFunctions F, RobotProxy<F> Proxy, Controller<F> ControllerType, Clock ClockType>
class ServoLoop {
 public:
  using Limits = SafetyLimits<F::kCoordinates, F::kVelocities>;

  /// The references must outlive the loop.
  ServoLoop(const LoopSettings& settings, const Limits& limits, Proxy& robot,
            ControllerType& controller, ClockType& clock, Mailbox& mailbox)
      : settings_(settings),
        limits_(limits),
        admitted_(limits),
        robot_(robot),
        controller_(controller),
        mailbox_(mailbox),
        cycle_(clock, static_cast<std::int64_t>(std::llround(1e9 / settings.rate))) {}

  /// Runs one cycle. `observe(const Report<F>&)` is called after the torque is written. Returns
  /// false if the loop has ended.
  template <class Observer>
  bool step(Observer&& observe) {
    cycle_.begin_cycle();
    receive();
    if (!robot_.connected()) {
      raise({FaultKind::robot_gone});
      fill_report();
      observe(report_);
      return false;
    }
    read_robot();
    apply_messages();
    command_torque();
    robot_.write(report_.tau);
    fill_report();
    observe(report_);
    const double period = 1e-9 * static_cast<double>(cycle_.period());
    robot_.pass_time(period);
    wait();
    const std::int64_t skipped = cycle_.timing().skipped;
    if (skipped > 0) {
      robot_.pass_time(period * static_cast<double>(skipped));
    }
    watch_deadline(skipped);
    ticks_ += 1 + skipped;
    return !(disconnecting_ && may_end());
  }

  /// Runs cycles until the loop ends.
  template <class Observer>
  void run(Observer&& observe) {
    while (step(observe)) {
    }
  }

  /// Time of the next cycle, or of the one in progress, s since the loop began.
  double time() const noexcept {
    return 1e-9 * static_cast<double>(ticks_) * static_cast<double>(cycle_.period());
  }
  Mode mode() const noexcept { return report_.mode; }
  const Fault& fault() const noexcept { return report_.fault; }
  const Cycle<ClockType>& cycle() const noexcept { return cycle_; }
  /// Time spent in `control`, by the machine's clock.
  const DurationStatistics& control_times() const noexcept { return control_times_; }
  /// Number of messages lost because the queue was full.
  std::uint64_t dropped_messages() const noexcept { return dropped_; }

 private:
  /// Reads the robot. A state that is not finite goes no further: the last one that was stays in
  /// the report.
  void read_robot() {
    const StateOf<F> last = report_.state;
    robot_.read(report_.state);
    unreadable_ = check_finite(report_.state);
    if (unreadable_) report_.state = last;
  }

  /// Waits for the next tick. A controller may prepare for it, a moment before.
  void wait() {
    if constexpr (requires { controller_.prepare(); }) {
      cycle_.end_cycle(static_cast<std::int64_t>(std::llround(1e9 * settings_.prepare_lead)),
                       [this] { controller_.prepare(); });
    } else {
      cycle_.end_cycle();
    }
  }

  void raise(const Fault& fault) noexcept {
    if (report_.mode != Mode::faulted) {
      report_.fault = fault;
      report_.mode = next_mode(report_.mode, Event::fault);
    }
  }

  void receive() noexcept {
    Message message;
    while (mailbox_.pop(message)) {
      if (!queue_.insert(message)) {
        ++dropped_;
      }
    }
  }

  void apply_messages() {
    Message message;
    for (int i = 0; i < settings_.messages_per_cycle && queue_.pop(message); ++i) {
      apply(message);
    }
  }

  void apply(const Message& message) {
    const Mode before = report_.mode;
    switch (message.kind) {
      case MessageKind::emergency_stop:
        raise({FaultKind::emergency_stop});
        break;
      case MessageKind::disconnect:
        disconnect_time_ = disconnecting_ ? disconnect_time_ : time();
        disconnecting_ = true;
        report_.mode = next_mode(before, Event::stop);
        break;
      case MessageKind::stop:
        report_.mode = next_mode(before, Event::stop);
        break;
      case MessageKind::reset:
        report_.mode = next_mode(before, Event::reset);
        if (before == Mode::faulted) {
          admit(report_.state, admitted_);
        }
        report_.fault = report_.mode == Mode::faulted ? report_.fault : Fault{};
        break;
      case MessageKind::start:
        report_.mode = next_mode(before, Event::start);
        if (before != Mode::running && report_.mode == Mode::running) {
          controller_.start(time(), report_.state);
        }
        break;
      default:
        controller_.apply(time(), message);
    }
  }

  /// Controls if the state is safe; brakes if it is not, or if the loop is not running.
  void command_torque() {
    report_.control_nanoseconds = 0;
    if (unreadable_) {
      raise(unreadable_);
    } else if (const Fault fault = check_state(admitted_, report_.state)) {
      raise(fault);
    }
    follow_back(limits_, report_.state, admitted_);
    if (report_.mode == Mode::running) {
      control();
    }
    if (report_.mode != Mode::running) {
      if (unreadable_) {
        std::fill(std::begin(report_.tau), std::end(report_.tau), 0.0);
      } else {
        brake<F>(limits_, report_.state, settings_.braking, report_.tau);
      }
      if (report_.mode == Mode::stopping && rests()) {
        report_.mode = next_mode(report_.mode, Event::at_rest);
      }
    }
  }

  void control() {
    using Watch = std::chrono::steady_clock;
    const Watch::time_point before = Watch::now();
    controller_.control(time(), report_.state, report_.tau);
    const auto spent =
        std::chrono::duration_cast<std::chrono::nanoseconds>(Watch::now() - before).count();
    report_.control_nanoseconds = spent;
    control_times_.record(spent);
    if (const Fault fault = check_torque<F::kCoordinates, F::kVelocities>(limits_, report_.tau)) {
      raise(fault);
    }
  }

  bool rests() const noexcept {
    if (unreadable_) return false;
    for (const double speed : report_.state.qd) {
      if (!(std::fabs(speed) <= settings_.rest_speed)) {
        return false;
      }
    }
    return true;
  }

  bool may_end() const noexcept {
    const bool stands = report_.mode == Mode::idle || (report_.mode == Mode::faulted && rests());
    return stands || time() - disconnect_time_ > settings_.longest_braking;
  }

  void watch_deadline(std::int64_t skipped) noexcept {
    overruns_ = skipped > 0 ? overruns_ + 1 : 0;
    if (overruns_ > limits_.overruns_in_a_row && report_.mode == Mode::running) {
      raise({FaultKind::deadline, -1, static_cast<double>(overruns_),
             static_cast<double>(limits_.overruns_in_a_row)});
    }
  }

  void fill_report() noexcept {
    report_.cycle = cycles_++;
    report_.time = time();
    report_.timing = cycle_.timing();
  }

  LoopSettings settings_;
  Limits limits_;
  Limits admitted_;  ///< `limits_`, wider for a robot that was beyond them at a reset
  Proxy& robot_;
  ControllerType& controller_;
  Mailbox& mailbox_;
  Cycle<ClockType> cycle_;
  MessageQueue<64> queue_;
  DurationStatistics control_times_;
  Report<F> report_;
  Fault unreadable_;  ///< a number of this cycle's measurement that is not finite
  std::int64_t ticks_ = 0;
  std::int64_t cycles_ = 0;
  std::uint64_t dropped_ = 0;
  int overruns_ = 0;
  bool disconnecting_ = false;
  double disconnect_time_ = 0.0;
};

}  // namespace treeline::servo
