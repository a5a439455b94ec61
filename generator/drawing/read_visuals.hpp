#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "drawing/solids.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

enum class VisualKind { box, cylinder, sphere, mesh };

/// A `<visual>` of a link, or a `<collision>`.
struct Visual {
  std::string link;
  VisualKind kind = VisualKind::mesh;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< edges; or radius, length; or radius; m
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< in the link's frame
  Color color{};
};

/// The visuals of a URDF that can be read as one, in the file's order. A visual without a shape
/// that has a size is left out, with a warning. Where all visuals of a link are meshes, the boxes,
/// cylinders and spheres by which it collides follow them.
std::vector<Visual> read_visuals(const std::string& urdf, const std::string& file,
                                 Diagnostics& diagnostics);

/// The boxes, cylinders and spheres by which the links of a URDF collide, in the file's order.
std::vector<Visual> read_collisions(const std::string& urdf, const std::string& file,
                                    Diagnostics& diagnostics);

}  // namespace treeline
