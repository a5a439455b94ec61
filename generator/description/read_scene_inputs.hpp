#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Reads what of the robot functions take as arguments: `gravity`, `payload`, `parameters`,
/// `base_parameters`, `tool`, `contact`. An error for links that are unknown or cannot move, and
/// for points that are unknown or hold an object. Everything else of the scene must have been read.
void read_scene_inputs(const SceneElement& element, const Robot& robot, Scene& scene);

/// Warns of what the scene lists under `inputs` and none of its functions depends on.
void check_inputs_used(const SceneElement& top, const Scene& scene);

}  // namespace treeline
