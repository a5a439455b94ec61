#pragma once

#include <span>
#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/propose_scene.hpp"

/// Scenes of every kind that a robot may stand in, as text that people would write.
namespace treeline::tests {

struct SceneKind {
  const char* name;
  /// The scene without its base, for the points that `init-scene` proposes; empty where the robot
  /// has too few of them.
  std::string (*print)(const SceneProposal& proposal);
};

std::span<const SceneKind> scene_kinds();

}  // namespace treeline::tests
