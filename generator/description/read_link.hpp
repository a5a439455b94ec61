#pragma once

#include "description/robot.hpp"
#include "description/urdf_element.hpp"

namespace treeline {

/// Reads `<link>`: its name and its first `<inertial>`. Shapes and materials do not matter.
Link read_link(const UrdfElement& element);

}  // namespace treeline
