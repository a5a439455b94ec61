#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/ground_unit.hpp"

namespace treeline {

/// The step on the ground that the scene asks for, of a robot of which something that moves may
/// touch it. Its functions are those of the robot alone: the scene's points play no part.
GroundUnit compose_ground(const Robot& robot, const Scene& scene);

}  // namespace treeline
