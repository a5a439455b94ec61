#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A warning for each point of a controller's tasks that has rows which the joints cannot move
/// independently of its other rows and points: poses that it is sent to are then a fault.
void warn_of_rows(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
