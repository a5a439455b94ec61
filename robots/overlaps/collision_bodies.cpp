#include "overlaps/collision_bodies.hpp"

#include <algorithm>

#include "description/group_bodies.hpp"
#include "description/read_surroundings.hpp"

namespace treeline::experiments {
namespace {

CollisionBody body_of(const SceneShape& shape, const std::string& name, Carrier carrier, int index,
                      const Eigen::Isometry3d& frame) {
  const bool ball = shape.radius > 0;
  return {name,
          carrier,
          index,
          ball ? VisualKind::sphere : VisualKind::box,
          ball ? Eigen::Vector3d(shape.radius, 0, 0) : Eigen::Vector3d(shape.size.data()),
          frame * isometry_of(shape.origin)};
}

template <class Named>
int index_of(const std::vector<Named>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const Named& entry) { return entry.name == name; });
  return static_cast<int>(found - list.begin());
}

}  // namespace

std::vector<CollisionBody> collision_bodies(const RobotWithFiles& read, const Scene& scene,
                                            Diagnostics& diagnostics) {
  std::vector<CollisionBody> bodies;
  for (const Visual& shape :
       read_collisions(shown_urdf(read.files), read.robot.file, diagnostics)) {
    bodies.push_back({shape.link, Carrier::link, index_of(read.robot.links, shape.link), shape.kind,
                      shape.size, shape.pose});
  }
  const SceneSurroundings around = surroundings_of(read.files.scene_text, read.robot);
  for (std::size_t i = 0; i < scene.objects.size() && i < around.shapes.size(); ++i) {
    const SceneGrasp& grasp = scene.objects[i].grasps.front();
    for (const SceneShape& shape : around.shapes[i]) {
      bodies.push_back(body_of(shape, scene.objects[i].name, Carrier::object,
                               index_of(scene.operational_points, grasp.point),
                               isometry_of(grasp.origin)));
    }
  }
  for (const SceneObstacle& obstacle : around.obstacles) {
    bodies.push_back(
        body_of(obstacle, obstacle.name, Carrier::world, 0, Eigen::Isometry3d::Identity()));
  }
  return bodies;
}

std::vector<Eigen::Isometry3d> place_bodies(const std::vector<CollisionBody>& bodies,
                                            const LinkPlacer& placer, std::span<const double> q) {
  const auto links = placer.place(q);
  const auto points = placer.place_points(q);
  std::vector<Eigen::Isometry3d> poses;
  for (const CollisionBody& body : bodies) {
    const auto index = static_cast<std::size_t>(body.index);
    const Eigen::Isometry3d frame = body.carrier == Carrier::link ? links[index]
                                    : body.carrier == Carrier::object
                                        ? points[index]
                                        : Eigen::Isometry3d::Identity();
    poses.push_back(frame * body.pose);
  }
  return poses;
}

}  // namespace treeline::experiments
