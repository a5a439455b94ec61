#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "description/group_bodies.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A ball or a box by which a link collides.
struct TouchShape {
  std::string link;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of its middle in the link's frame
  Eigen::Vector3d size = Eigen::Vector3d::Zero();          ///< edges of a box, m; 0 of a ball
  double radius = 0;                                       ///< of a ball, m
};

/// Where a foot touches the ground at q = 0, in the axes of the root.
struct FootPlace {
  Eigen::Vector3d at;
  bool is_of_balls = false;
};

/// Finds it: below its lowest balls, else in the middle of the lowest side of its boxes. Nothing
/// where that is not below its joint.
std::optional<FootPlace> place_foot(const Robot& robot, const BodyTree& tree, const Body& body,
                                    const Eigen::Vector3d& up,
                                    const std::vector<TouchShape>& shapes);

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

/// Number of random states within the limits on which the choice is based.
inline constexpr int kRowStates = 9;

/// Chooses the rows of each of the points, which come with all rows: those that their links can
/// move in independently of each other. Each point is first considered alone, with the joints of
/// its own chain and the base at rest; then all of them together, translations before rotations.
/// Some points may keep no row.
void choose_rows(const Robot& robot, const Scene& scene, std::vector<ScenePoint>& points);

/// Keeps, of the points' rows, those that can be moved independently of each other in half of some
/// random states, translations before rotations.
void keep_independent_rows(const Robot& robot, const Scene& scene, std::vector<ScenePoint>& points);

}  // namespace treeline
