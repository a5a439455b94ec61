#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "drawing/place_links.hpp"
#include "drawing/read_visuals.hpp"
#include "drawing/solids.hpp"

namespace treeline {

/// One moment of a motion.
struct Moment {
  std::vector<double> q;              ///< rad, m
  std::string caption;                ///< below the picture
  std::vector<Eigen::Vector3d> path;  ///< of a point up to this moment, m, world; may be empty
  Solids held;                        ///< objects in its hands
};

/// From where the robot is seen, in parallel projection.
struct View {
  double azimuth = 0.75;    ///< of the camera about z, from x towards y, rad
  double elevation = 0.25;  ///< of the camera above the horizontal, rad
};

/// Draws a robot at several moments, side by side and at one scale, as a stand-alone SVG 1.1 file:
/// the boxes, cylinders and spheres of its URDF. A link without such a shape is drawn as rods from
/// its origin to those of the links it carries. `standing` is drawn beside the robot at every
/// moment. What is nearer hides what is behind it: by the middles of faces, which long faces are
/// cut for. Background, ground and captions follow the reader's preference of light or dark.
std::string draw_robot(const Robot& robot, const LinkPlacer& placer,
                       const std::vector<Visual>& visuals, const std::vector<Moment>& moments,
                       const View& view, const Solids& standing = {});

}  // namespace treeline
