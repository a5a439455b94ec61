#pragma once
// A control loop for microcontrollers around an emitted controller: what runtime/servo does, in
// C++17 without a library. The timer's interrupt calls `tick`; commands wait in a queue; time is
// whatever counter the firmware has.
//
// Modes and messages are those of the big loop (core/mode.hpp), and the controller brakes, checks
// and faults as `NAME_controller.h` states. What is added is time: a loop that is called too late
// too often in a row stops the robot as an emergency stop does.

#include <stddef.h>
#include <stdint.h>

#include "core/controller_messages.hpp"
#include "core/message_queue.hpp"
#include "core/mode.hpp"
#include "firmware/statistics.hpp"

namespace treeline::firmware {

/// A command of fixed size; `numbers` is 12 where points are moved, else as many as there are
/// joints.
template <class Number, int numbers>
struct Message {
  core::MessageKind kind = core::MessageKind::stop;
  int32_t index = 0;
  Number duration = Number(0);  ///< s
  Number values[numbers] = {};
};

/// Timing of the loop, in ticks of the clock.
struct Timing {
  uint32_t period = 0;             ///< between two calls of `tick`
  uint32_t latest = 0;             ///< a call later than this behind its time is an overrun
  uint32_t overruns_in_a_row = 3;  ///< allowed; one more is an emergency stop
};

/// The loop. `Controller` is `NAME::Controller` of the emitted header, `Clock` any callable that
/// returns a running count of 32 bits, which may wrap. No member allocates, waits or throws. `tick`
/// must not interrupt the others: mask the timer's interrupt around `post`, and around copies of
/// what the main program takes of `output` and the statistics, whose numbers belong together.
template <class Controller, class Clock, size_t waiting, size_t bins>
class Servo {
 public:
  using Real = typename Controller::Real;
  static constexpr int kNumbers =
      Controller::kTask && Controller::kJoints < 12 ? 12 : Controller::kJoints;
  using Command = Message<Real, kNumbers>;

  /// Constant: a static loop needs no start-up code. `begin` comes before the first tick.
  constexpr Servo(const Timing& timing, Clock clock) noexcept : clock_(clock), timing_(timing) {}

  /// Loads the configuration's defaults.
  void begin() noexcept { Controller::default_config(config_); }

  typename Controller::Config& config() noexcept { return config_; }
  /// Input for `tick`: q, qd and the other measurements that the controller takes.
  typename Controller::Input& input() noexcept { return input_; }
  const typename Controller::Output& output() const noexcept { return output_; }
  core::Mode mode() const noexcept { return static_cast<core::Mode>(output_.mode); }

  /// Leaves a command for one of the next ticks, the most urgent first. False: the queue is full.
  bool post(const Command& command) noexcept { return queue_.insert(command); }

  /// One cycle: takes a command, steps the controller, records how long it took and how late it
  /// was. Then `output().tau` is for the motors.
  void tick() noexcept {
    const uint32_t begun = clock_();
    watch(begun);
    Command command;
    if (late_ > timing_.overruns_in_a_row && mode() == core::Mode::running) {
      command.kind = core::MessageKind::emergency_stop;
      core::fill_command<Controller>(command, ++sequence_, input_.command);
      missed_ = true;
    } else if (queue_.pop(command)) {
      if (command.kind == core::MessageKind::reset) missed_ = false;
      core::fill_command<Controller>(command, ++sequence_, input_.command);
    }
    Controller::step(config_, state_, input_, output_);
    durations_.record(clock_() - begun);
  }

  /// Ticks of the clock that `tick` took, and that it was called behind its time.
  const Statistics<bins>& durations() const noexcept { return durations_; }
  const Statistics<bins>& delays() const noexcept { return delays_; }
  /// Whether lateness stopped the robot. A reset clears it.
  bool missed_deadlines() const noexcept { return missed_; }

 private:
  /// Compares the time of this call with that of the one before. A call that is late shifts those
  /// behind it, so that one delay counts once.
  void watch(uint32_t now) noexcept {
    const uint32_t passed = now - last_;
    const uint32_t delay = called_ && passed > timing_.period ? passed - timing_.period : 0;
    if (called_) delays_.record(delay);
    late_ = delay > timing_.latest ? late_ + 1 : 0;
    last_ = now;
    called_ = true;
  }

  Clock clock_;
  Timing timing_;
  typename Controller::Config config_ = {};
  typename Controller::State state_ = {};
  typename Controller::Input input_ = {};
  typename Controller::Output output_ = {};
  core::MessageQueue<Command, waiting> queue_;
  Statistics<bins> durations_;
  Statistics<bins> delays_;
  uint32_t sequence_ = 0;
  uint32_t last_ = 0;
  uint32_t late_ = 0;
  bool called_ = false;
  bool missed_ = false;
};

}  // namespace treeline::firmware
