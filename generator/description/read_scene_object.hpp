#pragma once

#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// The scene's list of objects into `scene.objects`: names that are identifiers and differ, a mass
/// and an inertia that a body can have, grasps by operational points, each of which holds one
/// object at most. `scene.operational_points` has been read.
void read_objects(const SceneElement& element, Scene& scene);

}  // namespace treeline
