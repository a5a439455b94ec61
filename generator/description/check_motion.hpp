#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// Indices of the joints whose coordinate moves no mass and no inertia: neither the joint nor one
/// that mimics it has any beyond it. Their rows of the mass matrix are zero.
std::vector<int> find_massless_joints(const Robot& robot);

/// Whether any link of the robot has mass or a moment of inertia.
bool moves_inertia(const Robot& robot);

/// Warns of a world with inertia, and of links that have a shape but no inertial.
void check_motion(const Robot& robot, const std::vector<UrdfElement>& elements,
                  UrdfReading& reading);

}  // namespace treeline
