#pragma once

#include <string>

#include "description/read_robots.hpp"

namespace treeline {

/// All robots of a scene as one URDF, as `join_robots` names them, for programs that show robots:
/// every element of each file, with names of links, joints and materials behind the robot's name
/// and a slash. Names of meshes are put behind it, too.
std::string print_joined_urdf(const SceneRobots& robots);

}  // namespace treeline
