#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "description/group_bodies.hpp"

namespace treeline {

/// A ball or a box by which a link collides.
struct TouchShape {
  std::string link;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of its middle in the link's frame
  Eigen::Vector3d size = Eigen::Vector3d::Zero();          ///< edges of a box, m; 0 of a ball
};

/// Where a foot touches the ground, in the frame of its body's first link: the middle of its lowest
/// balls, else of the lowest side of its boxes, at q = 0. Nothing where that is not below its
/// joint.
std::optional<Eigen::Vector3d> place_foot(const Robot& robot, const BodyTree& tree,
                                          const Body& body, const Eigen::Vector3d& up,
                                          const std::vector<TouchShape>& shapes);

}  // namespace treeline
