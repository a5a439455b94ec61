#pragma once

#include "description/urdf_element.hpp"

namespace treeline {

/// Warns of what stands inside the elements of visuals, collisions and materials that hold
/// attributes alone, such as `<color>`: nothing reads it. The same of shapes behind the first one
/// in a `<geometry>`.
void check_looks(const UrdfElement& robot);

}  // namespace treeline
