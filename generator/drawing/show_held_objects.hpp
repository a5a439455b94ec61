#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "description/surroundings.hpp"

namespace treeline {

/// A URDF's text with a scene's objects as further links, for programs that show robots: each is
/// fixed to its first hand, has its `shapes` and is called `NAME, held`. Objects without shapes are
/// left out; text that is no URDF is returned as it is.
std::string show_held_objects(const std::string& urdf_text, const Scene& scene,
                              const std::vector<std::vector<SceneShape>>& shapes);

}  // namespace treeline
