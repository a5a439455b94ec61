#pragma once
// Modes of a control loop and the requests that lead from one to another: shared by the loops of
// servo and firmware and by emitted controllers. C++17, freestanding.

#include <stdint.h>

namespace treeline::core {

/// Modes of a loop.
///
///              start              stop, disconnect
///     idle ------------> running ------------------> stopping
///      ^ ^                 |                           |   |
///      | |                 | fault                     |   | fault
///      | |                 v                           |   v
///      | +------------- faulted <----------------------|---+
///      |     reset                                     |
///      +-----------------------------------------------+
///                          at rest
///
/// In idle, stopping and faulted the robot brakes: gravity is held and motion is damped. The
/// robot's state is read in every mode, and a fault in idle also leads to faulted. Events that are
/// not drawn change nothing. `disconnect` also ends the loop once it is idle, or faulted and at
/// rest.
enum class Mode : uint8_t { idle, running, stopping, faulted };

enum class Event : uint8_t { start, stop, at_rest, fault, reset };

constexpr Mode next_mode(Mode mode, Event event) noexcept {
  switch (event) {
    case Event::fault:
      return Mode::faulted;
    case Event::start:
      return (mode == Mode::idle) ? Mode::running : mode;
    case Event::stop:
      return (mode == Mode::running) ? Mode::stopping : mode;
    case Event::at_rest:
      return (mode == Mode::stopping) ? Mode::idle : mode;
    case Event::reset:
      return (mode == Mode::faulted) ? Mode::idle : mode;
  }
  return mode;
}

constexpr const char* mode_name(Mode mode) noexcept {
  switch (mode) {
    case Mode::idle:
      return "idle";
    case Mode::running:
      return "running";
    case Mode::stopping:
      return "stopping";
    case Mode::faulted:
      return "faulted";
  }
  return "";
}

/// Requests of a front end. The first five concern the loop, in order of decreasing urgency. The
/// others are passed to the controller.
enum class MessageKind : uint8_t {
  emergency_stop,  ///< go to the safe state now
  disconnect,      ///< the front end leaves: stop, then end the loop
  stop,            ///< brake to rest
  reset,           ///< leave the faulted mode
  start,           ///< begin to control from the present state
  move_point,      ///< index: point; values: position (3), row-major rotation (9); duration
  set_posture,     ///< values: desired posture q; duration where the controller moves there
  set_gains,       ///< values: kp, kv
  instruction,     ///< for controllers with messages of their own; index: which
  press,           ///< index: point; values: direction (3), force; duration until it is reached
  comply,          ///< yield like springs and dampers about the present pose
  lead_posture,    ///< while it complies: values, duration: posture that springs pull to by then
  lead_point,      ///< while it complies: index, values, duration as of `move_point`
  behave,          ///< index: set of tasks; duration until all of it are done
};

/// Whether a number that came from outside is a kind. A message kind has eight bits: without this
/// question, 256 would be taken for an emergency stop and 260 for a start.
constexpr bool is_message_kind(int32_t kind) noexcept {
  return (kind >= 0) && (kind <= static_cast<int32_t>(MessageKind::behave));
}

/// Urgency of a message. Of two waiting messages the more urgent one is applied first. The order is
/// that of MessageKind up to `start`; all later kinds are equally urgent.
constexpr int urgency(MessageKind kind) noexcept {
  constexpr int kLeast = static_cast<int>(MessageKind::move_point);
  return (static_cast<int>(kind) < kLeast) ? (kLeast - static_cast<int>(kind)) : 0;
}

}  // namespace treeline::core
