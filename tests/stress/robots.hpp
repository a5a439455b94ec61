#pragma once

#include <string>

#include "description/robot.hpp"
#include "description/scene.hpp"

/// Robots that are difficult to compute with.
namespace treeline::stress {

struct Case {
  Robot robot;
  Scene scene;
};

/// A serial arm, or a binary tree of such links. Axes alternate z, y, z ...; links are rods.
struct ArmOptions {
  int links = 6;
  bool binary_tree = false;  ///< link i is attached to link (i - 1) / 2
  bool floating = false;
  double length = 0.3;       ///< m, of a link
  double mass = 2;           ///< kg, of the first link
  double mass_growth = 1;    ///< ratio of each link's mass to that of the one before
  double slenderness = 0.1;  ///< radius over length of each rod; determines ratios of inertias
  bool balls = false;   ///< balls of radius slenderness x length at each origin instead of rods
  int light_link = -1;  ///< index of a link whose mass and inertia are multiplied
  double light = 1;     ///< by this factor
};

/// Makes the robot with one operational point with all rows on the last link (a tree has another on
/// the first leaf).
Case make_arm(const ArmOptions& options);

/// Reads the file's robot, with one point with all rows on `link`.
Case read_robot(const std::string& urdf, const std::string& link);

}  // namespace treeline::stress
