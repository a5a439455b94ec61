#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "description/robot.hpp"
#include "drawing/read_visuals.hpp"
#include "drawing/solids.hpp"

namespace treeline {

/// Largest distance between the origins of two links along an axis of the world, m; at least 1 mm.
double size_of(const std::vector<Eigen::Isometry3d>& links);

/// The shapes of a robot whose links have these poses. Rods stand for links without a shape;
/// `size` sets their thickness. A link that weighs nothing has none where others have a shape.
Solids robot_solids(const Robot& robot, const std::vector<Visual>& visuals,
                    const std::vector<Eigen::Isometry3d>& links, double size);

}  // namespace treeline
