#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Reports hands that cannot hold what the scene says: fewer coordinates than the grasps have rows,
/// grasps at one place, on a line or in a plane where the virtual linkage needs more.
void check_objects(const SceneElement& top, const Robot& robot, const Scene& scene);

}  // namespace treeline
