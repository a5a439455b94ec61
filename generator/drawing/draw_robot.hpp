#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "drawing/camera.hpp"
#include "drawing/place_links.hpp"
#include "drawing/read_visuals.hpp"
#include "drawing/solids.hpp"

namespace treeline {

/// One moment of a motion.
struct Moment {
  std::vector<double> q;  ///< rad, m
  std::string caption;    ///< below the picture
  /// Where each drawn point went up to this moment, m, world. A path may be empty.
  std::vector<std::vector<Eigen::Vector3d>> paths;
  Solids held;  ///< objects in its hands
};

/// How the moments of an animation follow each other, over and over.
struct Film {
  double rate = 10;    ///< moments a second
  double pause = 0.5;  ///< for which the last is shown before the first comes again, s
};

/// Draws a robot at several moments, side by side and at one scale, as a stand-alone SVG 1.1 file:
/// the boxes, cylinders, spheres and meshes of its URDF. A link without such a shape is drawn as
/// rods from its origin to those of the links it carries; one that weighs nothing is not drawn
/// where others have a shape. `standing` is drawn beside the robot at every moment. What is nearer
/// hides what is behind it: by the middles of faces, which long faces are cut for. Background,
/// ground and captions follow the reader's preference of light or dark.
std::string draw_robot(const Robot& robot, const LinkPlacer& placer,
                       const std::vector<Visual>& visuals, const std::vector<Moment>& moments,
                       const View& view, const Solids& standing = {});

/// Draws the same moments one after another: a strip that CSS moves past a window. Where that is
/// not supported, or the reader prefers reduced motion, the first moment stays.
std::string animate_robot(const Robot& robot, const LinkPlacer& placer,
                          const std::vector<Visual>& visuals, const std::vector<Moment>& moments,
                          const View& view, const Film& film, const Solids& standing = {});

/// How long a film of so many moments lasts, s.
double duration_of(const Film& film, std::size_t moments);

}  // namespace treeline
