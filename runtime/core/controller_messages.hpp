#pragma once
// Messages of a front end as commands of an emitted controller. C++17, freestanding.

#include "core/mode.hpp"

namespace treeline::core {

/// Writes what a message asks for to the command of a controller, with the sequence number that
/// makes it a new one, with the values that `MessageKind` lists. `Message` has kind, index,
/// duration, values.
template <class Controller, class Message>
inline void fill_command(const Message& message, uint32_t sequence,
                         typename Controller::Command& command) noexcept {
  using Real = typename Controller::Real;
  command.kind = static_cast<int32_t>(message.kind);
  command.sequence = sequence;
  command.point = message.index;
  command.duration = static_cast<Real>(message.duration);
  if (message.kind == MessageKind::set_posture || message.kind == MessageKind::lead_posture) {
    for (int i = 0; i < Controller::kJoints; ++i) {
      command.goal[i] = static_cast<Real>(message.values[i]);
    }
  }
  if constexpr (Controller::kTask) {
    if (message.kind == MessageKind::move_point || message.kind == MessageKind::lead_point) {
      for (int i = 0; i < 3; ++i) {
        command.position[i] = static_cast<Real>(message.values[i]);
      }
      for (int i = 0; i < 9; ++i) {
        command.rotation[i] = static_cast<Real>(message.values[3 + i]);
      }
    }
  }
  if constexpr (Controller::kForce) {
    if (message.kind == MessageKind::press) {
      for (int i = 0; i < 3; ++i) {
        command.direction[i] = static_cast<Real>(message.values[i]);
      }
      command.force = static_cast<Real>(message.values[3]);
    }
  }
}

}  // namespace treeline::core
