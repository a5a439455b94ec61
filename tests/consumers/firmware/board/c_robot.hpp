#pragma once
// The functions of a folder in C by the names that they have in C++. FIRMWARE_C is the folder's
// name, FIRMWARE_C_CAPITALS the same in capitals.
#include FIRMWARE_HEADER

#define JOIN_NAMES(name, rest) name##rest
#define JOIN(name, rest) JOIN_NAMES(name, rest)

namespace c_robot {

using Real = JOIN(FIRMWARE_C, _real);
inline constexpr int kCoordinates = JOIN(FIRMWARE_C_CAPITALS, _COORDINATES);
inline constexpr int kVelocities = JOIN(FIRMWARE_C_CAPITALS, _VELOCITIES);
inline constexpr int kTaskRows = JOIN(FIRMWARE_C_CAPITALS, _TASK_ROWS);

inline constexpr auto& control_torque = JOIN(FIRMWARE_C, _control_torque);

}  // namespace c_robot
