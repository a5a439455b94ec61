#pragma once

#include <vector>

#include "description/robot.hpp"

namespace treeline {

/// The robot's joints in the order in which coordinates are numbered: depth first from the root,
/// the children of a link in the file's order. Every joint comes after the one that carries its
/// parent link. Indices into `Robot::joints`. The robot must be a tree, of any depth.
std::vector<int> joints_depth_first(const Robot& robot);

}  // namespace treeline
