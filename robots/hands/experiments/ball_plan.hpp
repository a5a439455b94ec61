#pragma once

#include "core/spline.hpp"

namespace treeline::experiments {

/// How the ball moves: turned about each axis of the world to either side, and led around a
/// triangle, each leg from rest to rest.
struct BallPlan {
  double hold = 0.5;     ///< before the first leg and after the last one, s
  double leg = 1.5;      ///< s
  double turn = 0.5;     ///< to either side, rad
  double way = 0.01;     ///< m
  double squeeze = 3.0;  ///< of a finger, N

  [[nodiscard]] double duration() const noexcept;
};

/// Displacement (m) over rotation vector (rad) of the ball against where it was, world axes.
core::Motion<6, double> ball_at(const BallPlan& plan, double time) noexcept;

}  // namespace treeline::experiments
