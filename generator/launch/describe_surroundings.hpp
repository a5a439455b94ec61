#pragma once

#include <vector>

#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "drive/robot_description.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The obstacles as front ends draw them.
std::vector<drive::DrivenObstacle> describe_obstacles(const std::vector<SceneObstacle>& obstacles);

/// Adds obstacles, and the points that keep away from them, to what front ends know of a robot: the
/// operational points on links that move, then those of the scene's `avoidance`. Errors: a point on
/// a link that does not move; a robot of so many links that forces on them are not computed.
bool describe_surroundings(const SceneSurroundings& surroundings, const Scene& control,
                           drive::RobotDescription& description, Diagnostics& diagnostics);

}  // namespace treeline
