#pragma once

#include <string>
#include <vector>

#include "read_motion.hpp"

namespace urdf {
class ModelInterface;
}

namespace treeline::pictures {

/// Settings of a strip of pictures.
struct StripSettings {
  std::vector<double> times;  ///< s, one picture each, from left to right
  /// Columns of the motion with x, y and z of a point (m, world). Its path is drawn up to each
  /// picture. Empty: no path.
  std::vector<std::string> path;
  double azimuth = 0.75;    ///< of the camera about z, from x towards y, rad
  double elevation = 0.18;  ///< of the camera above the horizontal, rad
};

/// Draws a robot with a fixed base at several moments of a motion, side by side, as a stand-alone
/// SVG 1.1 file: the boxes, cylinders and spheres of its URDF in parallel projection. The motion
/// has columns `time` and `q_JOINT`; a joint without a column stays at 0. Empty, with the reason in
/// `error`, if a required column is missing.
std::string draw_strip(const urdf::ModelInterface& robot, const Motion& motion,
                       const StripSettings& settings, std::string& error);

}  // namespace treeline::pictures
