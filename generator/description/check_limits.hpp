#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Why a scene that holds no rows does not permit supported_control_torque.
const char* why_unsupported(const Scene& scene);

/// Functions that `limited_control_torque` calls.
std::vector<Function> functions_of_limits(const Scene& scene);

/// Adds to functions that the scene did not list those that `limited_control_torque` calls.
void add_functions_of_limits(const Robot& robot, Scene& scene);

/// Reports what limits of torques and friction lack.
void check_limits(const SceneElement& top, const Robot& robot, const Scene& scene);

}  // namespace treeline
