#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "cli/read_robot_files.hpp"
#include "description/surroundings.hpp"
#include "drawing/place_links.hpp"
#include "drawing/read_visuals.hpp"

namespace treeline::experiments {

/// What carries a body: a link, an object in a hand, or the world.
enum class Carrier { link, object, world };

/// A convex shape that nothing may pass through.
struct CollisionBody {
  std::string name;  ///< of its link, its object or its obstacle
  Carrier carrier = Carrier::world;
  int index = 0;  ///< of its link, or of the point that holds its object
  VisualKind kind = VisualKind::box;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();          ///< as of a `Visual`
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< in what carries it
};

/// The `<collision>` shapes of the links, the shapes of the objects in their first hands, and the
/// obstacles.
std::vector<CollisionBody> collision_bodies(const RobotWithFiles& read, const Scene& scene,
                                            Diagnostics& diagnostics);

/// Where the bodies are in the world at coordinates `q`.
std::vector<Eigen::Isometry3d> place_bodies(const std::vector<CollisionBody>& bodies,
                                            const LinkPlacer& placer, std::span<const double> q);

}  // namespace treeline::experiments
