#pragma once

#include <vector>

#include "description/read_joint.hpp"

namespace treeline {

/// Gives every joint the indices of its links and the robot its joints and root, and reports what
/// keeps them from being one tree: a link that no element defines, two parents, a loop, several
/// roots. `elements` are those of the robot's links.
void connect_tree(std::vector<NamedJoint>& joints, const std::vector<UrdfElement>& elements,
                  Robot& robot, UrdfReading& reading);

}  // namespace treeline
