#pragma once

#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Reads the largest torques of motors, `urdf` or a map from joint to number, into
/// `scene.torque_limits`.
void read_torque_limits(const SceneElement& element, const Robot& robot, Scene& scene);

}  // namespace treeline
