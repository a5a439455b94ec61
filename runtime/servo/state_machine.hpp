#pragma once

#include <cstdint>

namespace treeline::servo {

/// Modes of the loop.
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
enum class Mode : std::uint8_t { idle, running, stopping, faulted };

enum class Event : std::uint8_t { start, stop, at_rest, fault, reset };

constexpr Mode next_mode(Mode mode, Event event) noexcept {
  switch (event) {
    case Event::fault:
      return Mode::faulted;
    case Event::start:
      return mode == Mode::idle ? Mode::running : mode;
    case Event::stop:
      return mode == Mode::running ? Mode::stopping : mode;
    case Event::at_rest:
      return mode == Mode::stopping ? Mode::idle : mode;
    case Event::reset:
      return mode == Mode::faulted ? Mode::idle : mode;
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

}  // namespace treeline::servo
