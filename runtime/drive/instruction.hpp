#pragma once

#include "servo/message.hpp"

namespace treeline::drive {

/// How the loop controls the robot while it runs.
enum class Control : int { joint, task, gravity };

/// Instruction of a message of kind `instruction` to the controller: `Message::index`. Names in
/// brackets are the entries of `Message::values`; durations are in `Message::duration`, 0: at half
/// the speed limits.
enum class Instruction : int {
  set_control,    ///< [control]
  move_joint,     ///< [coordinate, relative, to]
  move_posture,   ///< like `move_joint`, but the control stays
  go_home,        ///< []
  move_point,     ///< [point, relative, x, y, z]; point -1: the floating base
  turn_point,     ///< [point, relative, 3: rotation vector | 4: quaternion x y z w]
  drag_point,     ///< [point, oriented, x, y, z, qx, qy, qz, qw]; lease
  drag_joint,     ///< [coordinate, to]; lease
  pull_link,      ///< [link, x, y, z on the link, x, y, z in the world]; lease
  hold_all,       ///< []
  hold_point,     ///< [point]
  release_point,  ///< [point]
  set_gains,      ///< [0: joint, 1: task, 2: both; stiffness 1/s^2; damping 1/s]
  begin_here,     ///< []: the present state becomes the goal
  follow,         ///< []: the reference; in `duration` to its beginning
};

/// Gains that a drive begins with, until `set_gains` changes them: 1/s^2 and 1/s.
inline constexpr double kStiffness = 225.0;
inline constexpr double kDamping = 30.0;

/// Time for which a drag or a pull is obeyed, s.
inline constexpr double kLease = 0.125;

/// Number of the point that stands for the floating base.
inline constexpr int kBasePoint = -1;

inline servo::Message make_message(Instruction instruction) noexcept {
  servo::Message message;
  message.kind = servo::MessageKind::instruction;
  message.index = static_cast<int>(instruction);
  return message;
}

}  // namespace treeline::drive
