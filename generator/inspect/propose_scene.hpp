#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A scene to start from, guessed from a URDF: names, limits, the shape of the tree.
struct SceneProposal {
  Base base = Base::fixed;
  std::string base_reason;
  std::vector<ScenePoint> points;     ///< at origins of links, with the rows that can be moved
  std::vector<std::string> left_out;  ///< links at ends of the tree without a point
  std::vector<std::string> beyond;    ///< joints beyond the points, as of fingers
};

/// A point at each end of the tree, or before it where a link's name tells of a tool, a hand or a
/// foot. `base` goes before the guess.
SceneProposal propose_scene(const Robot& robot, std::optional<Base> base);

/// The proposal as the text of a scene, with comments. `file` is the URDF as the reader would name
/// it; `functions` are those that the scene permits.
std::string print_scene(const Robot& robot, const SceneProposal& proposal, const std::string& file,
                        const std::vector<Function>& functions);

}  // namespace treeline
