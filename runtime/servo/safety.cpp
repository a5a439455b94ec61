#include "servo/safety.hpp"

#include <cmath>
#include <cstdio>

namespace treeline::servo {
namespace {

/// Says how a coordinate exceeds a limit: what it did, by how much, and the limit.
std::string beyond_limit(const std::string& who, const char* did, const Fault& fault) {
  char numbers[64];  // two of at most 13 characters
  std::snprintf(numbers, sizeof numbers, "%.6g, beyond its limit %.6g", fault.value, fault.limit);
  return who + " " + did + " " + numbers;
}

}  // namespace

std::string describe(const Fault& fault, const std::string& name) {
  const std::string who = name.empty() ? "coordinate " + std::to_string(fault.index) : name;
  switch (fault.kind) {
    case FaultKind::none:
      return "no fault";
    case FaultKind::position_limit:
      return beyond_limit(who, "is at", fault);
    case FaultKind::velocity_limit:
      return beyond_limit(who, "moves at", fault);
    case FaultKind::torque_limit:
      return beyond_limit(who, "was commanded", fault);
    case FaultKind::state_not_finite:
      return who + " reads a number that is not finite";
    case FaultKind::torque_not_finite:
      return who + " was commanded a number that is not finite";
    case FaultKind::deadline:
      return std::to_string(std::lround(fault.value)) + " cycles in a row missed their deadline, " +
             std::to_string(std::lround(fault.limit)) + " are allowed";
    case FaultKind::robot_gone:
      return "the robot is no longer connected";
    case FaultKind::emergency_stop:
      return "emergency stop";
    case FaultKind::stalled:
      return "a cycle was " + std::to_string(std::lround(1e3 * fault.value)) + " ms late, " +
             std::to_string(std::lround(1e3 * fault.limit)) + " ms are allowed";
    case FaultKind::jump:
      return beyond_limit(who, "moves otherwise than its velocity says, by", fault);
    case FaultKind::moved:
      return "the robot was dragged away while it should stand";
    case FaultKind::fell:
      return "the robot has fallen";
    case FaultKind::following:
      return beyond_limit(fault.index < 0 ? "a point" : who, "is away from its reference by",
                          fault);
  }
  return {};
}

}  // namespace treeline::servo
