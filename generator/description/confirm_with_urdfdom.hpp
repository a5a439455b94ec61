#pragma once

#include <vector>

#include "description/urdf_parts.hpp"

namespace treeline {

/// A second opinion from urdfdom on the same elements: names, tree, joint types, poses, axes,
/// inertias and mimics as the file has them. False, with an error, when the two readers disagree,
/// which would be a fault of this program. urdfdom is given only the elements and attributes that
/// matter to the dynamics, with placeholders for what it insists on and the dynamics does not need.
bool confirm_with_urdfdom(const Robot& robot, const std::vector<NamedJoint>& joints,
                          const std::vector<UrdfElement>& links, UrdfReading& reading);

}  // namespace treeline
