#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"

namespace treeline {

/// A sphere or a box about the origin of its frame.
struct SceneShape {
  Pose origin;
  std::array<double, 3> size{};  ///< edges of a box, m; 0 for a sphere
  double radius = 0;             ///< of a sphere, m; 0 for a box
};

/// A body that stands in the world, in which its origin is, beside the robot.
struct SceneObstacle : SceneShape {
  std::string name;
  bool avoided = true;  ///< false: the robot may touch it
};

/// A point of a link that keeps away from obstacles.
struct SceneGuard {
  std::string link;
  std::array<double, 3> xyz{};  ///< in the link's frame, m
};

/// How a robot keeps away from obstacles, see `drive::Repulsion`.
struct SceneAvoidance {
  double reach = 0.15;             ///< m
  double clearance = 0.02;         ///< m
  double strength = 5e-4;          ///< m^4/s^2
  std::vector<SceneGuard> points;  ///< beside the operational points
};

/// The ground, z < 0.
struct SceneGround {
  double friction = 0.8;   ///< Coulomb's coefficient
  double restitution = 0;  ///< speed after a blow by speed before, 0 to 1
  bool step = false;       ///< asks for NAME_ground.h: a step of time on it
};

/// What of a link's shape reaches a plane first: balls of one radius about some points, or the rims
/// of disks about them. In the link's frame, m.
struct SceneTouch {
  std::string link;
  std::vector<std::array<double, 3>> points;
  double radius = 0;
  std::array<double, 3> axis{};  ///< unit vector along the disks' axis; zero: balls
};

/// What is around a robot, and the looks of its objects. Of it generated code depends on a ground
/// with a step alone.
struct SceneSurroundings {
  std::optional<SceneGround> ground;
  std::vector<SceneObstacle> obstacles;
  SceneAvoidance avoidance;
  std::vector<std::vector<SceneShape>> shapes;  ///< of each object, in its frame; may be empty
};

}  // namespace treeline
