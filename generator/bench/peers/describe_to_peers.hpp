#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// See `peer::Point`.
struct PeerPoint {
  std::string link;
  std::array<double, 9> R{};
  std::array<double, 3> p{};
  std::array<bool, 6> rows{};
  bool world_axes = true;
};

/// What peers are told of a robot in a scene beside its URDF, see `peer::Robot`.
struct PeerDescription {
  bool floating = false;
  std::array<double, 3> gravity{};
  std::vector<std::string> links;  ///< for each entry of qd the link that it moves
  std::vector<PeerPoint> points;   ///< operational points
};

/// Nothing for a robot that peers cannot be asked for: `why_not` gets a sentence.
std::optional<PeerDescription> describe_to_peers(const Robot& robot, const Scene& scene,
                                                 std::string& why_not);

/// The URDF that peers read of a robot that they can be asked for: without shapes, losses and
/// limits; angles as the scene takes them, joints that it locks fixed where they are held. Numbers
/// are the robot's own to the last bit, but for the displacements of joints that are locked.
std::string print_plain_urdf(const Robot& robot, const Scene& scene);

}  // namespace treeline
