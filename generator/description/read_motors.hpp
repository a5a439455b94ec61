#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Reads `motors` of a controller: of each joint its gear, the constant of its motor, and perhaps
/// the largest current.
void read_motors(const SceneElement& element, const Robot& robot, const Scene& scene,
                 SceneController& controller);

/// Reports as an error a joint whose motor is not listed where others are: its current would be
/// told by nobody.
void check_motors(const SceneElement& top, const Robot& robot, const Scene& scene);

}  // namespace treeline
