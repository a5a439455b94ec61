#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// Whether the element is a joint that closes a loop, as Isaac Sim writes it: `<loop_joint name
/// type="spherical|fixed"><link1 link xyz rpy/><link2 link xyz rpy/></loop_joint>`.
bool is_loop_joint(const UrdfElement& element);

/// Reads it. An error for another type, which does not say about which axis, for a link that the
/// robot does not have, and for a name that is taken.
void read_loop_joint(const UrdfElement& element, Robot& robot);

}  // namespace treeline
