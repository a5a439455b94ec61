#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A scene to start from, guessed from names, limits and the tree of a URDF.
struct SceneProposal {
  Base base = Base::fixed;
  std::string base_reason;
  std::vector<ScenePoint> points;     ///< at origins of links, with the rows that can move
  std::vector<std::string> left_out;  ///< links at leaves of the tree without a point
  std::vector<std::string> beyond;    ///< joints beyond the points, for instance of fingers
};

/// Proposes a scene with a point at each leaf of the tree, or before it if a link's name indicates
/// a tool, a hand or a foot. `base` overrides the guess.
SceneProposal propose_scene(const Robot& robot, std::optional<Base> base);

/// Prints the proposal as the text of a scene, with comments. `file` is the name of the URDF for
/// the reader; `functions` are those that the scene permits.
std::string print_scene(const Robot& robot, const SceneProposal& proposal, const std::string& file,
                        const std::vector<Function>& functions);

}  // namespace treeline
