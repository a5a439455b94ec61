#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// A key at the top of a scene.
struct SceneKey {
  const char* name;
  /// Reads its value into the scene. Null for what other readers take from the file: robots,
  /// ground, obstacles and avoidance.
  void (*read)(const SceneElement& value, const Robot& robot, Scene& scene) = nullptr;
  /// Notes for a scene without the key, if there are any.
  void (*note_absence)(const SceneElement& top, const Robot& robot) = nullptr;
};

/// Every key that a scene may have, in the order in which they are read.
const std::vector<SceneKey>& scene_keys();

}  // namespace treeline
