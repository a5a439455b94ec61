#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "description/robot.hpp"
#include "description/rotation.hpp"

namespace treeline {

/// Links that move as one, in the order of the tree. The first one carries the others.
struct Body {
  std::vector<int> links;
  int parent = -1;  ///< index of a body
  int joint = -1;   ///< the joint that moves it
  std::vector<int> children;
};

/// The bodies of a robot, parents first, and the frames of all links in that of the root at q = 0.
struct BodyTree {
  std::vector<Body> bodies;
  std::vector<Eigen::Isometry3d> frames;  ///< by link
};

BodyTree group_bodies(const Robot& robot);

/// The rigid transform of a pose: of what is in its frame to where the pose is given.
inline Eigen::Isometry3d isometry_of(const Pose& pose) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = rotation_from_rpy<double>(pose.rpy);
  frame.translation() = Eigen::Vector3d(pose.xyz.data());
  return frame;
}

}  // namespace treeline
