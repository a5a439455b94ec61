#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace urdf {
class Geometry;
}

namespace treeline::pictures {

using Color = std::array<double, 3>;  ///< red, green, blue, 0 to 1

/// A flat convex part of a solid's surface, in world coordinates (m).
struct Face {
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d normal;  ///< unit length, outwards
  Color color{};
};

/// A ball, which looks like a disc from every direction.
struct Ball {
  Eigen::Vector3d center;
  double radius = 0.0;  ///< m
  Color color{};
};

struct Solids {
  std::vector<Face> faces;
  std::vector<Ball> balls;
};

/// Adds a box, a cylinder or a sphere of a URDF. `pose` is that of the shape in the world. Meshes
/// are left out.
void add_solid(const urdf::Geometry& shape, const Eigen::Isometry3d& pose, const Color& color,
               Solids& solids);

}  // namespace treeline::pictures
