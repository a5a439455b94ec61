#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/read_drawn_robot.hpp"
#include "drawing/draw_robot.hpp"

namespace treeline {

/// Which moments of which motion are drawn.
struct MomentOptions {
  std::string motion;              ///< file; empty: none
  std::vector<double> q, to;       ///< where it stands, or where a motion begins and turns back
  std::vector<double> times;       ///< s; of an animation: the first and the last
  std::vector<std::string> paths;  ///< points or links
  int pictures = 5;
  bool animate = false;
  double seconds = 0;  ///< that an animation takes; 0: as recorded
  Film film;
};

/// The moments that are drawn, with the objects in the hands. Nothing, with an error, where the
/// motion cannot be read or is not this robot's, or a time or a name is not in it.
std::optional<std::vector<Moment>> choose_moments(const MomentOptions& options,
                                                  const DrawnRobot& drawn, const LinkPlacer& placer,
                                                  Diagnostics& diagnostics);

}  // namespace treeline
