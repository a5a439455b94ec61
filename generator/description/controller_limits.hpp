#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Whether the controller has a motor of its own for a joint.
bool is_driven(const Joint& joint, const Scene& scene);

/// Limits of a joint in the controller: those that the scene states or waives there, else the
/// URDF's. A motor whose current is limited has no more torque than that gives.
Limits limits_in_controller(const Joint& joint, const SceneController& controller);

/// Reports as an error what the controller has no limit of that a file states and the scene does
/// not waive: positions of joints that have ends, speeds, torques. It guards by nothing else. So
/// it reports ends of which one is the scene's, that leave no position between them.
void check_controller_limits(const SceneElement& top, const Robot& robot, const Scene& scene);

}  // namespace treeline
