#pragma once

#include "random_mechanism.hpp"

/// Robots as CAD programs export them: numbers that should be 0, a quarter turn or an axis are so
/// only up to rounding.
namespace treeline::tests {

namespace detail {

inline void add_noise(Rng& rng, double angle, double length, Pose& pose) {
  for (double& x : pose.rpy) x += angle * rng.uniform(-1, 1);
  for (double& x : pose.xyz) x += length * rng.uniform(-1, 1);
}

inline void add_noise(Rng& rng, double angle, double length, std::vector<ScenePoint>& points) {
  for (ScenePoint& point : points) add_noise(rng, angle, length, point.origin);
}

}  // namespace detail

/// Adds up to `noise` (rad; for lengths relative to the longest offset) to every angle, every
/// offset and every component of an axis of `made`, in the robot and in the scene.
inline RandomMechanism with_noise(RandomMechanism made, double noise, std::uint64_t seed) {
  Rng rng(seed);
  double longest = 0;
  for (const Joint& joint : made.robot.joints) {
    for (const double x : joint.origin.xyz) longest = std::max(longest, std::abs(x));
  }
  const double length = noise * longest;
  for (Joint& joint : made.robot.joints) {
    detail::add_noise(rng, noise, length, joint.origin);
    for (double& x : joint.axis) x += noise * rng.uniform(-1, 1);
  }
  for (Link& link : made.robot.links) {
    if (link.inertial) detail::add_noise(rng, noise, length, link.inertial->origin);
  }
  for (auto* points : {&made.scene.operational_points, &made.scene.external_forces}) {
    detail::add_noise(rng, noise, length, *points);
  }
  return made;
}

}  // namespace treeline::tests
