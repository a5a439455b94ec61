#pragma once

#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <vector>

namespace treeline::peer {

/// A robot in DART, and memory for what a call takes.
struct Solver {
  dart::dynamics::SkeletonPtr skeleton;
  std::vector<Eigen::Index> place;  ///< index in DART's velocities, by entry of our qd
  bool floating = false;
  Eigen::VectorXd q, x;

  /// Converts a free joint's position. DART has the logarithm of the rotation followed by the
  /// position, we have position and quaternion.
  void load_position(const double* from) {
    std::size_t at = 0;
    if (floating) {
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.linear() = Eigen::Quaterniond(from[6], from[3], from[4], from[5]).toRotationMatrix();
      pose.translation() << from[0], from[1], from[2];
      q.head<6>() = dart::dynamics::FreeJoint::convertToPositions(pose);
      at = 6;
    }
    const std::size_t extra = floating ? 1 : 0;
    for (; at < place.size(); ++at) q(place[at]) = from[at + extra];
    skeleton->setPositions(q);
  }
  const Eigen::VectorXd& ordered(const double* from) {
    for (std::size_t i = 0; i < place.size(); ++i) x(place[i]) = from[i];
    return x;
  }
  void store(const Eigen::VectorXd& from, double* to) const {
    for (std::size_t i = 0; i < place.size(); ++i) to[i] = from(place[i]);
  }
};

}  // namespace treeline::peer
