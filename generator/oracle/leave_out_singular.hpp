#pragma once

#include "description/diagnostic.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Where M is singular in every pose, takes the functions that need its inverse out of the scene,
/// with one warning that names the directions without inertia and what would cure them. Functions
/// that somebody asked for by name (`listed`: those of the scene are), `damped` among them, are not
/// taken out: an error says the same.
void leave_out_singular(const Robot& robot, Scene& scene, bool listed, Diagnostics& diagnostics);

}  // namespace treeline
