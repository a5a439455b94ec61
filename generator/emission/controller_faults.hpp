#pragma once

#include <array>
#include <cstdint>

namespace treeline {

/// Bits of faults.
inline constexpr std::uint32_t kFaultMeasurement = 1, kFaultPosition = 2, kFaultSpeed = 4,
                               kFaultTorque = 8, kFaultStale = 16, kFaultEmergency = 32,
                               kFaultMoved = 64, kFaultJump = 128, kFaultFollowing = 256,
                               kFaultConfig = 512;

/// Faults after which torque alone cannot be trusted.
inline constexpr std::uint32_t kFaultsUntrusted =
    kFaultMeasurement | kFaultTorque | kFaultMoved | kFaultJump | kFaultConfig;

/// A fault of an emitted controller, for its header and for notes of safety.
struct ControllerFault {
  std::uint32_t bit;
  const char* name;     ///< in capitals, behind `NAME_FAULT_`
  const char* meaning;  ///< beside the enumerator, in the words of the configuration
  const char* time;     ///< cycles from the event to torque that brakes
  /// Whether torque alone cannot be trusted, so that brakes are asked for at once.
  [[nodiscard]] constexpr bool asks_brakes_at_once() const { return (bit & kFaultsUntrusted) != 0; }
};

/// All faults, in the order of their bits. The step that finds a fault brakes by its own torque, so
/// that times count from the event to the step that can measure it.
inline constexpr std::array kControllerFaults = {
    ControllerFault{kFaultMeasurement, "MEASUREMENT", "a measurement is not finite", "0"},
    ControllerFault{kFaultPosition, "POSITION",
                    "a joint is beyond a limit by more than position_margin", "0"},
    ControllerFault{kFaultSpeed, "SPEED",
                    "a joint is faster than its limit by more than speed_margin", "0"},
    ControllerFault{kFaultTorque, "TORQUE", "a torque is not finite", "0"},
    ControllerFault{kFaultStale, "STALE", "no command for stale_ticks steps",
                    "stale_ticks + 1 since the last command"},
    ControllerFault{kFaultEmergency, "EMERGENCY", "EMERGENCY_STOP", "0"},
    ControllerFault{kFaultMoved, "MOVED", "dragged away by twice hold_reach while it should stand",
                    "0"},
    ControllerFault{kFaultJump, "JUMP", "q moves otherwise than qd says, by more than jump",
                    "0 for a jump; a sensor that is frozen: once the motion it hides exceeds jump"},
    ControllerFault{kFaultFollowing, "FOLLOWING", "a reference is not followed; a joint is blocked",
                    "0 beyond following; 1 s after the reference came to rest beyond half of it; "
                    "0.5 s after the reference of a point had to wait on its way"},
    ControllerFault{kFaultConfig, "CONFIG", "the configuration is not sound: see check_config",
                    "0"},
};

static_assert(
    [] {
      std::uint32_t bit = 1;
      for (const ControllerFault& fault : kControllerFaults) {
        if (fault.bit != bit) return false;
        bit *= 2;
      }
      return bit == 2 * kFaultConfig;
    }(),
    "every bit has a row");

}  // namespace treeline
