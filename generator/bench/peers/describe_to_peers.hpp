#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A frame of a link, see `peer::Point`.
struct PeerPoint {
  std::string link;
  std::array<double, 9> R{};
  std::array<double, 3> p{};
  std::array<bool, 6> rows{};
  bool world_axes = true;
};

/// Rows that are held, see `peer::Constraint`.
struct PeerConstraint {
  std::string name;
  PeerPoint frame;
  std::optional<PeerPoint> other;  ///< absent: the world
};

/// Description of a robot in a scene for peers, in addition to its URDF; see `peer::Robot`.
struct PeerDescription {
  bool floating = false;
  std::array<double, 3> gravity{};
  std::vector<std::string> links;                ///< the link that each entry of qd moves
  std::vector<PeerPoint> points;                 ///< operational points
  std::vector<PeerConstraint> constraints = {};  ///< without couplings and what rolls
};

/// Makes the description. Returns nothing for a robot that peers cannot handle; `why_not` receives
/// a sentence about the reason.
std::optional<PeerDescription> describe_to_peers(const Robot& robot, const Scene& scene,
                                                 std::string& why_not);

/// Prints the URDF for peers: without shapes, losses and limits; with angles as the scene uses
/// them; with locked joints fixed at their values. Numbers are the robot's to the last bit, except
/// the displacements of locked joints.
std::string print_plain_urdf(const Robot& robot, const Scene& scene);

}  // namespace treeline
