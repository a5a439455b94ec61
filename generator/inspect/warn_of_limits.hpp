#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Warns of joints that move in the scene and whose limits permit no motion: one place (lower =
/// upper), no speed (velocity = 0) or no force (effort = 0), as exporters write where nobody has
/// filled the limits in. Each of the three once, at the first such joint, with a count.
void warn_of_limits(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
