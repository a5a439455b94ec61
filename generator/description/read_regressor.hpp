#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// Reads which columns regressors have: `parameters: all`, `base` or `none`, `links`, `payload`,
/// `rotors`, `friction: viscous` (`true`) or `coulomb`, `width`. An error for links that are
/// unknown, fixed to another or at rest, and for links or payloads together with base parameters.
/// Joints that the scene locks must have been read.
void read_regressor(const SceneElement& element, const Robot& robot, Scene& scene);

/// Warns of the key `regressor` where no function has a regressor.
void check_regressor_used(const SceneElement& top, const Scene& scene);

}  // namespace treeline
