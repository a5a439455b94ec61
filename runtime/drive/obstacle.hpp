#pragma once

#include <cmath>

namespace treeline::drive {

inline constexpr int kMostObstacles = 64;
inline constexpr int kMostGuardedPoints = 64;

/// A body that stands in the world: all places that are within `radius` of a box. A sphere is that
/// of a box without size.
struct Obstacle {
  double center[3] = {};
  double rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< the box's axes in its columns
  double half[3] = {};                               ///< half the edges of the box, m
  double radius = 0.0;                               ///< m
  bool avoided = true;                               ///< false: the robot may touch it
};

/// A point of a link that keeps away from obstacles and feels them.
struct GuardedPoint {
  int link = 0;            ///< as `RobotDescription::links` counts them
  int point = -1;          ///< the operational point that it is; -1: none
  double on_link[3] = {};  ///< m, in the link's frame
};

/// Signed distance (m) of the place `p` in the world from the obstacle's surface, negative inside.
/// `away` is its gradient: the unit vector that leads away on the shortest way.
inline double distance_to(const Obstacle& obstacle, const double (&p)[3],
                          double (&away)[3]) noexcept {
  double local[3];
  double outside[3];
  double squared = 0.0;
  for (int i = 0; i < 3; ++i) {
    local[i] = 0.0;
    for (int j = 0; j < 3; ++j) {
      local[i] += obstacle.rotation[3 * j + i] * (p[j] - obstacle.center[j]);
    }
    const double nearest = std::fmin(std::fmax(local[i], -obstacle.half[i]), obstacle.half[i]);
    outside[i] = local[i] - nearest;
    squared += outside[i] * outside[i];
  }
  double distance = std::sqrt(squared);
  if (distance > 0.0) {
    for (double& component : outside) {
      component /= distance;
    }
  } else {  // within the box: out through the nearest face
    int face = 0;
    for (int i = 1; i < 3; ++i) {
      const bool nearer =
          std::fabs(local[i]) - obstacle.half[i] > std::fabs(local[face]) - obstacle.half[face];
      face = nearer ? i : face;
    }
    outside[face] = local[face] < 0.0 ? -1.0 : 1.0;
    distance = std::fabs(local[face]) - obstacle.half[face];
  }
  for (int i = 0; i < 3; ++i) {
    away[i] = 0.0;
    for (int j = 0; j < 3; ++j) {
      away[i] += obstacle.rotation[3 * i + j] * outside[j];
    }
  }
  return distance - obstacle.radius;
}

/// The repulsive potential of Khatib 1986 (FIRAS), eq. 17, for a unit mass:
///     U(rho) = eta / 2 (1 / rho - 1 / reach)^2    for rho < reach, else 0.
/// A loop of finite rate cannot follow a curvature that grows without bounds: below the distance
/// where it would pass `largest_curvature`, U goes on with constant curvature.
struct Repulsion {
  double reach = 0.15;             ///< m: obstacles farther away do nothing
  double clearance = 0.02;         ///< m: rho = distance - clearance
  double eta = 5e-4;               ///< m^4/s^2
  double largest_curvature = 1e5;  ///< 1/s^2
};

/// Effect of a potential at a distance: -dU/drho (m/s^2), U itself (m^2/s^2), and the damping (1/s)
/// of motion along the gradient.
struct Push {
  double acceleration = 0.0;
  double energy = 0.0;
  double damping = 0.0;
};

inline Push push_at(const Repulsion& repulsion, double distance) noexcept {
  const double rho = distance - repulsion.clearance;
  const double reach = repulsion.reach;
  if (rho >= reach) {
    return {};
  }
  // 3 eta / rho^4 bounds the curvature of U.
  const double least =
      std::fmin(std::sqrt(std::sqrt(3.0 * repulsion.eta / repulsion.largest_curvature)), reach);
  const double at = std::fmax(rho, least);
  const double depth = at - rho;
  const double gap = 1.0 / at - 1.0 / reach;
  const double curvature = 3.0 * repulsion.eta / (at * at * at * at);
  const double slope = repulsion.eta * gap / (at * at);
  Push push;
  push.acceleration = slope + curvature * depth;
  push.energy = 0.5 * repulsion.eta * gap * gap + slope * depth + 0.5 * curvature * depth * depth;
  push.damping = std::sqrt(curvature) * gap * at;  // grows from 0 at the reach
  return push;
}

}  // namespace treeline::drive
