#pragma once

#include <cstddef>
#include <cstdint>

#include "core/controller_messages.hpp"
#include "servo/message.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::servo {

/// An emitted controller (`NAME_controller.h`, struct `NAME::Controller`) as the controller of a
/// `ServoLoop`: the same code as in firmware. The loop's period must be `config().period`. The loop
/// checks and brakes by itself; a fault of the controller alone makes it return its own safe
/// torque, see `output()`. Messages are taken one a cycle, in the order of the queue. Commands do
/// not become stale, since the loop itself notices who leaves it.
template <class Emitted, class F>
class EmittedController {
 public:
  EmittedController() noexcept { Emitted::default_config(config_); }

  typename Emitted::Config& config() noexcept { return config_; }
  const typename Emitted::Output& output() const noexcept { return output_; }
  /// Further inputs of the controller, such as the measured force.
  typename Emitted::Input& input() noexcept { return input_; }

  void start(double /*time*/, const StateOf<F>& /*state*/) noexcept {
    state_ = {};
    Message message;
    message.kind = MessageKind::start;
    send(message);
  }

  void apply(double /*time*/, const Message& message) noexcept { send(message); }

  void control(double /*time*/, const StateOf<F>& state, double (&tau)[F::kVelocities]) noexcept {
    static_assert(F::kVelocities == Emitted::kJoints && F::kCoordinates == Emitted::kJoints);
    for (int i = 0; i < Emitted::kJoints; ++i) {
      input_.q[i] = static_cast<typename Emitted::Real>(state.q[i]);
      input_.qd[i] = static_cast<typename Emitted::Real>(state.qd[i]);
    }
    Message message;
    if (!waiting_.pop(message)) message.kind = MessageKind::instruction;
    core::fill_command<Emitted>(message, ++sequence_, input_.command);
    Emitted::step(config_, state_, input_, output_);
    for (int i = 0; i < Emitted::kJoints; ++i) {
      tau[i] = static_cast<double>(output_.tau[i]);
    }
  }

  /// Messages that were lost since too many came at once.
  std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  void send(const Message& message) noexcept { dropped_ += waiting_.insert(message) ? 0 : 1; }

  typename Emitted::Config config_{};
  typename Emitted::State state_{};
  typename Emitted::Input input_{};
  typename Emitted::Output output_{};
  MessageQueue<16> waiting_;
  std::uint32_t sequence_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace treeline::servo
