#pragma once

#include <Eigen/Geometry>
#include <span>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "drawing/camera.hpp"
#include "drawing/read_visuals.hpp"
#include "drawing/solids.hpp"

namespace treeline {

/// The shapes of obstacles. Those that the robot avoids are orange, the others grey.
Solids obstacle_solids(const std::vector<SceneObstacle>& obstacles);

/// The shapes of a scene's objects, each in its first hand. `shapes` are those of each object,
/// `names` the scene's operational points and `points` their poses in the world.
Solids object_solids(const std::vector<SceneObject>& objects,
                     const std::vector<std::vector<SceneShape>>& shapes,
                     const std::vector<ScenePoint>& names,
                     std::span<const Eigen::Isometry3d> points);

/// Largest distance between the origins of two links along an axis of the world, m; at least 1 mm.
double size_of(const std::vector<Eigen::Isometry3d>& links);

/// The shapes of a robot whose links have these poses. Rods stand for links without a shape;
/// `size` sets their thickness. A link that weighs nothing has none where others have a shape.
Solids robot_solids(const Robot& robot, const std::vector<Visual>& visuals,
                    const std::vector<Eigen::Isometry3d>& links, double size);

/// A line through points of a picture, as the data of an SVG path: the first point, then the steps
/// from one to the next.
std::string print_line(const std::vector<Eigen::Vector2i>& points);

/// What is to be seen of solids, as elements of SVG in the camera's units, painted in
/// `currentColor` of each. What is nearer is painted over what is behind it: by the middles of
/// faces. Faces of four corners are cut before until no edge is longer than `longest`, m.
std::string print_solids(const Camera& camera, const Solids& solids, double longest);

}  // namespace treeline
