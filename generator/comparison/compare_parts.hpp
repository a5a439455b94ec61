#pragma once

#include "comparison/difference.hpp"

namespace treeline {

/// Compares masses, centres of mass and inertias of the links that both robots have.
void compare_inertias(const Robot& first, const Robot& second, const RobotMatch& match,
                      RobotDifference& difference);

/// Compares types, mimics and limits of the joints that both robots have.
void compare_joints(const Robot& first, const Robot& second, const RobotMatch& match,
                    RobotDifference& difference);

/// Compares poses, mass matrix, gravity and inverse dynamics at random states, see
/// `RobotDifference`.
void compare_motion(const Robot& first, const Robot& second, const RobotMatch& match,
                    RobotDifference& difference);

}  // namespace treeline
