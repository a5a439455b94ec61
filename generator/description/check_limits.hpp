#pragma once

#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// What supported_control_torque lacks in a scene that holds rows and does not permit it.
inline constexpr const char* kNoTask = "there is no operational point, and no joint is passive";

/// What `limited_control_torque` calls.
std::vector<Function> functions_of_limits(const Scene& scene);

/// Adds to functions that the scene did not list those that `limited_control_torque` calls.
void add_functions_of_limits(Scene& scene);

/// Reports what limits of torques and friction lack.
void check_limits(const SceneElement& top, const Scene& scene);

}  // namespace treeline
