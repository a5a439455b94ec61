#pragma once

#include <vector>

#include "description/surroundings.hpp"
#include "drawing/solids.hpp"

namespace treeline {

/// The shapes of obstacles. Those that the robot avoids are orange, the others grey.
Solids obstacle_solids(const std::vector<SceneObstacle>& obstacles);

}  // namespace treeline
