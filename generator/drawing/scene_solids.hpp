#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "drawing/solids.hpp"

namespace treeline {

/// The shapes of obstacles. Those that the robot avoids are orange, the others grey.
Solids obstacle_solids(const std::vector<SceneObstacle>& obstacles);

/// The shapes of a scene's objects, each in its first hand. `shapes` are those of each object,
/// `names` the scene's operational points and `points` their poses in the world.
Solids object_solids(const std::vector<SceneObject>& objects,
                     const std::vector<std::vector<SceneShape>>& shapes,
                     const std::vector<ScenePoint>& names,
                     std::span<const Eigen::Isometry3d> points);

}  // namespace treeline
