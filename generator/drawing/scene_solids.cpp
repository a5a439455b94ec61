#include "drawing/scene_solids.hpp"

#include <algorithm>

#include "description/group_bodies.hpp"

namespace treeline {
namespace {

void add_shape(const SceneShape& shape, const Eigen::Isometry3d& frame, const Color& color,
               Solids& solids) {
  const Eigen::Isometry3d pose = frame * isometry_of(shape.origin);
  if (shape.radius > 0) {
    solids.balls.push_back({pose.translation(), shape.radius, color});
  } else {
    add_box(Eigen::Vector3d(shape.size.data()), pose, color, solids);
  }
}

}  // namespace

Solids obstacle_solids(const std::vector<SceneObstacle>& obstacles) {
  constexpr Color kAvoided = {0.91, 0.55, 0.25};
  constexpr Color kTouched = {0.62, 0.62, 0.66};
  Solids solids;
  for (const SceneObstacle& obstacle : obstacles) {
    const Color& color = obstacle.avoided ? kAvoided : kTouched;
    add_shape(obstacle, Eigen::Isometry3d::Identity(), color, solids);
  }
  return solids;
}

Solids object_solids(const std::vector<SceneObject>& objects,
                     const std::vector<std::vector<SceneShape>>& shapes,
                     const std::vector<ScenePoint>& names,
                     std::span<const Eigen::Isometry3d> points) {
  constexpr Color kHeld = {0.79, 0.66, 0.46};
  Solids solids;
  for (std::size_t i = 0; i < objects.size() && i < shapes.size(); ++i) {
    const SceneGrasp& grasp = objects[i].grasps.front();
    const auto hand = std::find_if(names.begin(), names.end(), [&](const ScenePoint& point) {
      return point.name == grasp.point;
    });
    const Eigen::Isometry3d frame =
        points[static_cast<std::size_t>(hand - names.begin())] * isometry_of(grasp.origin);
    for (const SceneShape& shape : shapes[i]) add_shape(shape, frame, kHeld, solids);
  }
  return solids;
}

}  // namespace treeline
