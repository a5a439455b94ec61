#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Place of a link of the URDF: its moving link, -1 for the world, and its pose there.
struct LinkPlace {
  int link = -1;
  Digits50Pose pose;
};

/// Index of a joint's first coordinate and velocity; -1 for a joint that does not move.
struct FirstCoordinate {
  int q, v;
};

/// The robot and the scene with the places of links and joints in the mechanism.
struct PlacedRobot {
  const Robot& robot;
  const Scene& scene;
  const std::vector<LinkPlace>& links;         ///< in the order of the robot's links
  const std::vector<FirstCoordinate>& joints;  ///< in the order of the robot's joints
};

/// Returns the pose with its structure made exact, and records in the mechanism what was changed,
/// under the name `element`.
Digits50Pose resolved_as(const Digits50Pose& pose, const std::string& element,
                         Mechanism& mechanism);

/// Adds all that the scene attaches to links or names of joints: points, forces, contacts, objects,
/// constraints, loops, couplings, passive joints, payloads and inputs.
void place_scene(const PlacedRobot& placed, Mechanism& mechanism);

}  // namespace treeline
