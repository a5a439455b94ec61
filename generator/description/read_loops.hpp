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

/// Whether the element is a `<constraint>` as it is proposed for URDF (urdfdom, pull request 264):
/// `<constraint name type><parent link/><parent_origin xyz rpy/><parent_axis xyz/>`, and likewise
/// of the child.
bool is_constraint(const UrdfElement& element);

/// Reads it as a loop that a scene can close, of the types of a `<loop_joint>`. With a note.
void read_constraint_hint(const UrdfElement& element, Robot& robot);

/// Finds pairs of links `closing_NAME_1` and `closing_NAME_2`, as onshape-to-robot leaves them
/// where it opens a loop: points that a scene can hold together. With a note.
void find_closing_frames(Robot& robot, UrdfReading& reading);

}  // namespace treeline
