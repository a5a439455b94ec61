#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Gives a scene without `damped` one that suits the robot, with a note, so that its task yields
/// near singularities: directions that feel heavier than six times what moves, in rotations at an
/// eighth of the robot's reach. Tasks with priorities or `singular: exact` are left as they are.
void assume_damping(const Robot& robot, Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
