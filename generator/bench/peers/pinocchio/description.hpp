#pragma once

#include <array>
#include <string>
#include <vector>

namespace treeline::peer::pin {

/// A frame fixed to a link, all six of its rows controlled in the world's axes.
struct Point {
  std::string link;
  std::array<double, 9> R{};  ///< in the link's frame, row-major
  std::array<double, 3> p{};
};

/// What Pinocchio has to know of a robot.
struct Description {
  std::string urdf;                ///< path
  bool floating = false;           ///< the root link on a free joint
  std::vector<std::string> links;  ///< moved by each entry of qd
  std::array<double, 3> gravity{};
  std::vector<Point> points;
};

}  // namespace treeline::peer::pin
