#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace treeline {

/// A homogeneous solid of density 1: its inertia is about its centre.
struct Solid {
  double volume = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// Three corners each, in the order that shows the outside.
using Triangles = std::vector<std::array<Eigen::Vector3d, 3>>;

/// Triangles of an STL (binary or text) or OBJ file; nothing where it is another or is malformed.
/// Polygons of OBJ are cut into triangles at their first corner.
std::optional<Triangles> read_triangles(const std::string& bytes);

/// The solid that a closed surface bounds. `overlapping`: each triangle adds its tetrahedron with
/// the centre, whichever side shows, as MuJoCo counts by default.
Solid solid_within(const Triangles& surface, bool overlapping);

}  // namespace treeline
