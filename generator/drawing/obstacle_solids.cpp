#include "drawing/obstacle_solids.hpp"

#include "description/rotation.hpp"

namespace treeline {

Solids obstacle_solids(const std::vector<SceneObstacle>& obstacles) {
  constexpr Color kAvoided = {0.91, 0.55, 0.25};
  constexpr Color kTouched = {0.62, 0.62, 0.66};
  Solids solids;
  for (const SceneObstacle& obstacle : obstacles) {
    const Color& color = obstacle.avoided ? kAvoided : kTouched;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation_from_rpy<double>(obstacle.origin.rpy);
    pose.translation() = Eigen::Vector3d(obstacle.origin.xyz.data());
    if (obstacle.radius > 0) {
      solids.balls.push_back({pose.translation(), obstacle.radius, color});
    } else {
      add_box(Eigen::Vector3d(obstacle.size.data()), pose, color, solids);
    }
  }
  return solids;
}

}  // namespace treeline
