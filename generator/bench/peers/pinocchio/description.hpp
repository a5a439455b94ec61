#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace treeline::peer::pin {

/// A frame fixed to a link. Of an operational point all six rows are controlled, in world axes.
struct Point {
  std::string link;
  std::array<double, 9> R{};  ///< in the link's frame, row-major
  std::array<double, 3> p{};
};

/// A frame that is held relative to another one, or to the world.
struct Held {
  Point first;
  std::optional<Point> second;
  bool turns = false;  ///< rotation is held, too
};

/// Everything that Pinocchio needs to know about a robot.
struct Description {
  std::string urdf;                ///< path
  bool floating = false;           ///< the root link has a free joint
  std::vector<std::string> links;  ///< the link that each entry of qd moves
  std::array<double, 3> gravity{};
  std::vector<Point> points;
  std::vector<Held> held = {};
};

}  // namespace treeline::peer::pin
