#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// Names of the source files that are emitted for a scene, without their endings, known before
/// anything is generated: a build lists them when it is configured. With `optimize: size` a
/// controller may turn out not to have a `controller_gravity` of its own.
std::vector<std::string> predict_sources(const Scene& scene);

}  // namespace treeline
