#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "drive/robot_description.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Describes a robot to front ends. `links` is the scene for pulling. A speed or effort of 0, as
/// many files have it, counts as no limit; so do equal or exchanged limits of position.
drive::RobotDescription describe_robot(const Robot& robot, const Scene& control, const Scene& links,
                                       const Mechanism& mechanism);

/// Index in q of the first coordinate of each floating joint.
std::vector<int> floating_joints(const Mechanism& mechanism);

}  // namespace treeline
