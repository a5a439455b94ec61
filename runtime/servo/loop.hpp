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
#include "servo/safe_state.hpp"
#include "servo/safety.hpp"
#include "servo/state_machine.hpp"
#include "servo/statistics.hpp"
#include "servo/watch_motion.hpp"
#include "servo/watch_references.hpp"

namespace treeline::servo {

/// Requirements of the loop on a controller. Times are in s since the loop began. `start` is called
/// when control begins, with the initial state; `apply` with every message that does not concern
/// the loop itself; `control` once per cycle while running. If there is a `prepare()`, it is called
/// where the loop waits, shortly before the next cycle: it may load code and data into caches. If
/// there is a `compare`, see `find_left_behind`, references that are left behind are a fault. None
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
  BrakeSettings brake;           ///< in every mode except running
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
  Fault fault;          ///< first fault since the last reset
  bool brakes = false;  ///< mechanical brakes should be closed now
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
        safe_(settings.brake, 1.0 / settings.rate, limits),
        motion_(limits.jump),
        robot_(robot),
        controller_(controller),
        mailbox_(mailbox),
        cycle_(clock, static_cast<std::int64_t>(std::llround(1e9 / settings.rate))) {}

  /// Runs one cycle. `observe(const Report<F>&)` is called after the torque is written. Returns
  /// false if the loop has ended.
  template <class Observer>
  bool step(Observer&& observe) {
    cycle_.begin_cycle();
    count_time();
    watch_delay(cycle_.timing().jitter);
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
    robot_.pass_time(period());
    wait();
    skipped_ = cycle_.timing().skipped;
    pass_skipped(skipped_);
    watch_deadline(skipped_);
    ticks_ += 1 + skipped_;
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
  double period() const noexcept { return 1e-9 * static_cast<double>(cycle_.period()); }

  /// Reads the robot. Numbers that are not finite go no further: the last ones that were, moved on,
  /// stand for them.
  void read_robot() {
    StateOf<F> state;
    robot_.read(state);
    unreadable_ = check_finite(state);
    jumped_ = unreadable_ ? Fault{} : motion_.see(state, least_elapsed_, most_elapsed_);
    if (!unreadable_) least_elapsed_ = most_elapsed_ = 0.0;
    if (safe_.see(state)) report_.state = state;
    for (int i = 0; jumped_ && i < F::kVelocities; ++i) {
      if (motion_.leap(i) != 0.0) safe_.set_back(i, motion_.leap(i));
    }
  }

  /// A robot that is simulated moves by ticks, another one by the machine's time.
  void count_time() noexcept {
    const double by_ticks = period() * static_cast<double>(1 + skipped_);
    const double by_clock = 1e-9 * static_cast<double>(cycle_.timing().period);
    least_elapsed_ += std::min(by_ticks, by_clock);
    most_elapsed_ += std::max(by_ticks, by_clock);
  }

  /// Ticks that were missed pass for the robot one by one. After a stall they are dropped: no
  /// simulation is to go on under a torque that long.
  void pass_skipped(std::int64_t skipped) {
    const auto most = static_cast<std::int64_t>(limits_.longest_delay / period());
    const std::int64_t passed = std::min(skipped, most);
    for (std::int64_t i = 0; i < passed; ++i) {
      robot_.pass_time(period());
    }
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
        if (before == Mode::faulted) believe_robot();
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

  /// A reset takes the robot as it is; one that was lost is where it began.
  void believe_robot() {
    if constexpr (requires { robot_.restore(); }) robot_.restore();
    motion_.forget();
    safe_.believe();
    read_robot();
    admit(report_.state, admitted_);
  }

  /// Controls if the state is safe; brakes if it is not, or if the loop is not running.
  void command_torque() {
    report_.control_nanoseconds = 0;
    if (unreadable_) {
      raise(unreadable_);
    } else if (const Fault fault = check_state(admitted_, report_.state)) {
      raise(fault);
    } else if (jumped_) {
      raise(jumped_);
    }
    if constexpr (requires { robot_.fault(); }) {
      if (const Fault fault = robot_.fault()) raise(fault);
    }
    follow_back(limits_, report_.state, admitted_);
    if (report_.mode == Mode::running) {
      control();
    }
    if (report_.mode == Mode::running) {
      safe_.release(report_.tau);
    } else {
      brake();
    }
    report_.brakes = wants_brakes();
  }

  void brake() noexcept {
    if (safe_.brake(report_.tau)) {
      raise({FaultKind::moved});
    }
    if (report_.mode == Mode::stopping && rests()) {
      report_.mode = next_mode(report_.mode, Event::at_rest);
    }
  }

  /// Torque alone cannot be trusted, or is not needed any more.
  bool wants_brakes() const noexcept {
    if (report_.mode != Mode::faulted) return false;
    const FaultKind kind = report_.fault.kind;
    return kind == FaultKind::state_not_finite || kind == FaultKind::torque_not_finite ||
           kind == FaultKind::jump || kind == FaultKind::moved || unreadable_ || rests();
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
    } else if (const Fault left = find_left_behind(controller_, time(), limits_.following)) {
      raise(left);
    }
  }

  bool rests() const noexcept { return !unreadable_ && safe_.rests(); }

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
    watch_delay(skipped * cycle_.period());
  }

  /// A robot that moves has been left alone for so long, ns.
  void watch_delay(std::int64_t late) noexcept {
    const double seconds = 1e-9 * static_cast<double>(late);
    if (!(seconds > limits_.longest_delay)) return;
    motion_.forget();
    if (report_.mode == Mode::running || report_.mode == Mode::stopping) {
      raise({FaultKind::stalled, -1, seconds, limits_.longest_delay});
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
  SafeState<F> safe_;
  MotionWatch<F> motion_;
  Proxy& robot_;
  ControllerType& controller_;
  Mailbox& mailbox_;
  Cycle<ClockType> cycle_;
  MessageQueue<64> queue_;
  DurationStatistics control_times_;
  Report<F> report_;
  Fault unreadable_;  ///< a number of this cycle's measurement that is not finite
  Fault jumped_;      ///< a coordinate of this cycle's that its velocity does not explain
  /// Time since the last measurement whose numbers were finite, s.
  double least_elapsed_ = 0.0;
  double most_elapsed_ = 0.0;
  std::int64_t skipped_ = 0;  ///< ticks that the last cycle missed
  std::int64_t ticks_ = 0;
  std::int64_t cycles_ = 0;
  std::uint64_t dropped_ = 0;
  int overruns_ = 0;
  bool disconnecting_ = false;
  double disconnect_time_ = 0.0;
};

}  // namespace treeline::servo
