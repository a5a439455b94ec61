#pragma once

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A warning where the scene's controller asks for another `speed_rise` than the default, and
/// motors need a longer one, which is emitted.
void warn_of_speed_rise(const Scene& scene, const Generation& generation, Diagnostics& diagnostics);

}  // namespace treeline
