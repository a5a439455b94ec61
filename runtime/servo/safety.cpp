#include "servo/safety.hpp"

#include <fmt/core.h>

namespace treeline::servo {

std::string describe(const Fault& fault, const std::string& name) {
  const std::string who = name.empty() ? fmt::format("coordinate {}", fault.index) : name;
  switch (fault.kind) {
    case FaultKind::none:
      return "no fault";
    case FaultKind::position_limit:
      return fmt::format("{} is at {:.6g}, beyond its limit {:.6g}", who, fault.value, fault.limit);
    case FaultKind::velocity_limit:
      return fmt::format("{} moves at {:.6g}, beyond its limit {:.6g}", who, fault.value,
                         fault.limit);
    case FaultKind::torque_limit:
      return fmt::format("{} was commanded {:.6g}, beyond its limit {:.6g}", who, fault.value,
                         fault.limit);
    case FaultKind::state_not_finite:
      return who + " reads a number that is not finite";
    case FaultKind::torque_not_finite:
      return who + " was commanded a number that is not finite";
    case FaultKind::deadline:
      return fmt::format("{:.0f} cycles in a row missed their deadline, {:.0f} are allowed",
                         fault.value, fault.limit);
    case FaultKind::robot_gone:
      return "the robot is no longer connected";
    case FaultKind::emergency_stop:
      return "emergency stop";
  }
  return {};
}

}  // namespace treeline::servo
