#pragma once

#include <optional>
#include <string>

#include "description/scene_element.hpp"
#include "description/surroundings.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The scene's keys `ground`, `obstacles` and `avoidance` and the `shapes` of its `objects`, out of
/// its `fields`. Errors: an obstacle or a shape that is not one sphere or one box; names that
/// repeat; sizes that are not positive; a point that repeats or is on an unknown link; more than a
/// loop can watch; friction or restitution that no ground has.
SceneSurroundings read_surroundings(const SceneFields& fields, const Robot& robot);

/// Reads the surroundings from the text of a scene that has been read without error.
SceneSurroundings surroundings_of(const std::string& scene_text, const Robot& robot);

}  // namespace treeline
