#pragma once

#include <span>
#include <vector>

#include "recursion/methods/center_of_mass.hpp"

namespace treeline {

/// The centre of mass has the world's axes, which do not turn.
template <class Scalar>
void append_of_center(const Vector3<Scalar>& linear, std::vector<Scalar>& entries) {
  entries.insert(entries.end(), {linear.x, linear.y, linear.z});
  entries.insert(entries.end(), 3, Scalar(0.0));
}

template <class Scalar>
void append_turned(const std::vector<WorldPose<Scalar>>& poses, int link,
                   const Vector3<Scalar>& linear, const Vector3<Scalar>& angular,
                   std::vector<Scalar>& entries) {
  const Matrix3<Scalar>& R = poses[static_cast<std::size_t>(link)].R;
  for (const Vector3<Scalar>& v : {R * linear, R * angular}) {
    entries.insert(entries.end(), {v.x, v.y, v.z});
  }
}

/// [v; w] of every operational point, world axes: the velocity of its origin over its angular
/// velocity, all six whichever rows the scene controls. One outward pass.
template <class Scalar>
std::vector<Scalar> point_velocities(const Tree<Scalar>& tree,
                                     const std::vector<JointTransform<Scalar>>& X,
                                     std::span<const Scalar> qd) {
  const auto velocities = link_velocities(tree, X, {qd, {}});
  const auto poses = world_poses(tree, X);
  std::vector<Scalar> entries;
  for (const TreePoint<Scalar>& point : tree.operational_points) {
    if (point.center_of_mass) {
      append_of_center(center_of_mass_velocity(tree, X, velocities), entries);
      continue;
    }
    if (point.link < 0) {
      entries.insert(entries.end(), 6, Scalar(0.0));
      continue;
    }
    const auto& [v, w] = velocities[static_cast<std::size_t>(point.link)];
    append_turned(poses, point.link, v + cross(w, point.p), w, entries);
  }
  return entries;
}

/// [dv/dt; dw/dt] of every operational point, world axes, without gravity: the rates of what
/// `point_velocities` gives.
template <class Scalar>
std::vector<Scalar> point_accelerations(const Tree<Scalar>& tree,
                                        const std::vector<JointTransform<Scalar>>& X,
                                        const JointRates<Scalar>& rates) {
  const auto motions = outward_motion(tree, X, rates, Vector3<Scalar>{});
  const auto poses = world_poses(tree, X);
  std::vector<Scalar> entries;
  for (const TreePoint<Scalar>& point : tree.operational_points) {
    if (point.center_of_mass) {
      append_of_center(center_of_mass_acceleration(tree, X, motions), entries);
      continue;
    }
    if (point.link < 0) {
      entries.insert(entries.end(), 6, Scalar(0.0));
      continue;
    }
    const LinkMotion<Scalar>& motion = motions[static_cast<std::size_t>(point.link)];
    append_turned(poses, point.link, acceleration_at(motion, point.p), motion.wd, entries);
  }
  return entries;
}

}  // namespace treeline
