#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "description/mesh/mesh.hpp"

namespace treeline {

/// A homogeneous solid of density 1: its inertia is about its centre.
struct Solid {
  double volume = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// The solid that a closed surface bounds. `overlapping`: each triangle adds its tetrahedron with
/// the centre, whichever side shows, as MuJoCo counts by default.
Solid solid_within(const std::vector<Triangle>& surface, bool overlapping);

/// The surface itself as a shell: its area stands for the volume.
Solid solid_on(const std::vector<Triangle>& surface);

}  // namespace treeline
