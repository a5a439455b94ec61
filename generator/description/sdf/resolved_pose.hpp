#pragma once

#include <Eigen/Geometry>
#include <ignition/math/Pose3.hh>

namespace treeline {

/// A pose of libsdformat as a matrix and a place, quaternion and place as they are.
inline Eigen::Isometry3d to_isometry(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.linear() = Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).toRotationMatrix();
  isometry.translation() = Eigen::Vector3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z());
  return isometry;
}

}  // namespace treeline
