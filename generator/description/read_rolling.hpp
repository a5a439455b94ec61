#pragma once

#include <string>

#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Reads `rolling: {radius, axis, on_radius}` of a constraint into the loop, whose rows are those
/// that `fields` list, or x y z.
void read_rolling(const SceneFields& fields, SceneLoop& loop);

}  // namespace treeline
