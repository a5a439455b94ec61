#pragma once

#include <string>
#include <vector>

#include "read_motion.hpp"

namespace urdf {
class ModelInterface;
}

namespace treeline::pictures {

/// What a strip shows.
struct StripSettings {
  std::vector<double> times;  ///< s, a picture each, from left to right
  /// Columns of the motion that hold the x, y and z of a point (m, world): its path is drawn up to
  /// each picture. Empty: no path.
  std::vector<std::string> path;
  double azimuth = 0.75;    ///< rad, of the camera about z, from x towards y
  double elevation = 0.18;  ///< rad, of the camera above the horizontal
};

/// Draws a robot with a fixed base at several moments of a motion, side by side, as a stand-alone
/// SVG 1.1 file: the boxes, cylinders and spheres of its URDF, seen from far away. The motion has
/// columns `time` and `q_JOINT`; a joint without a column stays at 0. Empty, with the reason in
/// `error`, when a column that is needed is missing.
std::string draw_strip(const urdf::ModelInterface& robot, const Motion& motion,
                       const StripSettings& settings, std::string& error);

}  // namespace treeline::pictures
