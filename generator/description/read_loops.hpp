#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// Whether the element is a joint that closes a loop, as Drake and Isaac Sim write it: `<loop_joint
/// name type><axis xyz/><link1 link xyz rpy/><link2 link xyz rpy/></loop_joint>`, where the type is
/// `spherical`, `fixed`, or about or along the axis, which has the same components in both frames,
/// `revolute`, `continuous`, `prismatic`.
bool is_loop_joint(const UrdfElement& element);

/// Reads it. An error for another type, for a link that the robot does not have, and for a name
/// that is taken.
void read_loop_joint(const UrdfElement& element, Robot& robot);

}  // namespace treeline
