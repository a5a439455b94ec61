#pragma once

#include <Eigen/Geometry>

#include "description/robot.hpp"
#include "description/rotation.hpp"

namespace treeline {

/// The rigid transform of a pose: of what is in its frame to where the pose is given.
inline Eigen::Isometry3d isometry_of(const Pose& pose) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = rotation_from_rpy<double>(pose.rpy);
  frame.translation() = Eigen::Vector3d(pose.xyz.data());
  return frame;
}

}  // namespace treeline
