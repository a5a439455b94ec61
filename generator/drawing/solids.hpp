#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "description/mesh/mesh.hpp"

namespace treeline {

inline constexpr int kThinSides = 12;  ///< of a cylinder that is thin in the picture
inline constexpr int kThickSides = 24;

/// A flat convex part of a solid's surface, in world coordinates (m).
struct Face {
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d normal;  ///< unit length, outwards
  Color color{};
};

/// A ball, which looks like a disc from every direction.
struct Ball {
  Eigen::Vector3d center;
  double radius = 0;  ///< m
  Color color{};
};

/// Faces and balls of a picture.
struct Solids {
  std::vector<Face> faces;
  std::vector<Ball> balls;
};

/// Adds what is to be seen elsewhere.
void add_solids(const Solids& others, Solids& solids);

/// Adds a box with edges of these lengths, m, about the origin of `pose`.
void add_box(const Eigen::Vector3d& size, const Eigen::Isometry3d& pose, const Color& color,
             Solids& solids);

/// Adds a cylinder about the z axis of `pose`, half of it below the origin; m. It has `sides` flat
/// ones.
void add_cylinder(double radius, double length, int sides, const Eigen::Isometry3d& pose,
                  const Color& color, Solids& solids);

/// Adds a thin rod between two points, with round ends; m.
void add_rod(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
             const Color& color, Solids& solids);

}  // namespace treeline
