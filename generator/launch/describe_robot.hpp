#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "drive/robot_description.hpp"
#include "mechanism/mechanism.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Describes a robot to front ends. `links` is the scene for pulling. A speed or effort of 0, as
/// many files have it, counts as no limit; so do equal or exchanged limits of position.
drive::RobotDescription describe_robot(const Robot& robot, const Scene& control, const Scene& links,
                                       const Mechanism& mechanism);

/// Index in q of the first coordinate of each floating joint.
std::vector<int> floating_joints(const Mechanism& mechanism);

/// The obstacles as front ends draw them.
std::vector<drive::DrivenObstacle> describe_obstacles(const std::vector<SceneObstacle>& obstacles);

/// Adds obstacles, and the points that keep away from them, to what front ends know of a robot: the
/// operational points on links that move, then those of the scene's `avoidance`. Errors: a point on
/// a link that does not move; a robot of so many links that forces on them are not computed.
bool describe_surroundings(const SceneSurroundings& surroundings, const Scene& control,
                           drive::RobotDescription& description, Diagnostics& diagnostics);

}  // namespace treeline
