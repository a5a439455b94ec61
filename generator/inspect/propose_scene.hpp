#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A scene to start from, guessed from the shape of a robot and its names.
struct SceneProposal {
  std::string kind;  ///< `a quadruped`
  Base base = Base::fixed;
  std::string base_reason;
  std::vector<ScenePoint> points;     ///< at origins of links, with the rows that can move
  std::vector<std::string> left_out;  ///< links at ends of limbs without a point
  std::set<std::string> at_joints;    ///< links of points that lie at joints, not at a tip
  std::vector<std::string> beyond;    ///< joints beyond the points, for instance of fingers
};

/// Proposes a scene with a point at the end of each limb, or before it if a link's name indicates a
/// tool, a hand or a foot. Wheels, propellers, heads and fingers of hands get none. `base`
/// overrides the guess.
SceneProposal propose_scene(const Robot& robot, std::optional<Base> base);

/// Prints the proposal as the text of a scene, with comments. `file` is the name of the URDF for
/// the reader; `functions` are those that the scene permits.
std::string print_scene(const Robot& robot, const SceneProposal& proposal, const std::string& file,
                        const std::vector<Function>& functions);

}  // namespace treeline
