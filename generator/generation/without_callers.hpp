#pragma once

#include "description/scene.hpp"

namespace treeline {

/// The scene without what calls its functions: damped control, limits, a controller.
inline Scene without_callers(Scene scene) {
  scene.damped.reset();
  scene.remove_limits();
  scene.controller.reset();
  return scene;
}

}  // namespace treeline
