#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/place_foot.hpp"

namespace treeline {

/// A scene to start from, guessed from the shape of a robot and its names.
struct SceneProposal {
  std::string kind;  ///< `a quadruped`
  Base base = Base::fixed;
  std::string base_reason;
  std::vector<ScenePoint> points;              ///< with the rows that can move
  std::vector<ScenePoint> feet;                ///< points on which the robot stands
  std::vector<std::string> left_out;           ///< links at ends of limbs without a point
  std::map<std::string, std::string> remarks;  ///< by link of a point: where it is, not at a frame
  std::vector<std::string> beyond;  ///< joints beyond the points, for instance of fingers
};

/// Proposes a scene with a point at the end of each limb, or before it if a link's name indicates a
/// tool, a hand or a foot. Wheels, propellers, heads and fingers of hands get none. `base`
/// overrides the guess. A foot's point is where it touches by the `shapes`, if its file has no
/// frame there.
SceneProposal propose_scene(const Robot& robot, std::optional<Base> base,
                            const std::vector<TouchShape>& shapes = {});

/// Prints the proposal as the text of a scene, with comments. `file` is the name of the URDF for
/// the reader; `functions` are those that the scene permits.
std::string print_scene(const Robot& robot, const SceneProposal& proposal, const std::string& file,
                        const std::vector<Function>& functions);

}  // namespace treeline
