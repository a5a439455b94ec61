#include "solid_faces.hpp"

#include <urdf_model/link.h>

#include <cmath>
#include <numbers>

namespace treeline::pictures {
namespace {

void add_face(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal,
              const Eigen::Isometry3d& pose, const Color& color, Solids& solids) {
  Face face;
  for (const Eigen::Vector3d& corner : corners) face.corners.push_back(pose * corner);
  face.normal = pose.linear() * normal;
  face.color = color;
  solids.faces.push_back(face);
}

void add_box(const urdf::Vector3& size, const Eigen::Isometry3d& pose, const Color& color,
             Solids& solids) {
  const Eigen::Vector3d half = 0.5 * Eigen::Vector3d(size.x, size.y, size.z);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      normal[axis] = side;
      std::vector<Eigen::Vector3d> corners;
      for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        Eigen::Vector3d corner;
        corner[axis] = side * half[axis];
        corner[(axis + 1) % 3] = a * half[(axis + 1) % 3];
        corner[(axis + 2) % 3] = b * half[(axis + 2) % 3];
        corners.push_back(corner);
      }
      add_face(corners, normal, pose, color, solids);
    }
  }
}

void add_cylinder(double radius, double length, const Eigen::Isometry3d& pose, const Color& color,
                  Solids& solids) {
  constexpr int kSides = 20;
  const auto rim = [&](int k, double z) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  std::vector<Eigen::Vector3d> bottom;
  std::vector<Eigen::Vector3d> top;
  for (int k = 0; k < kSides; ++k) {
    bottom.push_back(rim(k, -0.5 * length));
    top.push_back(rim(k, 0.5 * length));
    const double middle = 2.0 * std::numbers::pi * (k + 0.5) / kSides;
    add_face({bottom.back(), rim(k + 1, -0.5 * length), rim(k + 1, 0.5 * length), top.back()},
             {std::cos(middle), std::sin(middle), 0.0}, pose, color, solids);
  }
  add_face(bottom, -Eigen::Vector3d::UnitZ(), pose, color, solids);
  add_face(top, Eigen::Vector3d::UnitZ(), pose, color, solids);
}

}  // namespace

void add_solid(const urdf::Geometry& shape, const Eigen::Isometry3d& pose, const Color& color,
               Solids& solids) {
  if (const auto* box = dynamic_cast<const urdf::Box*>(&shape)) {
    add_box(box->dim, pose, color, solids);
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&shape)) {
    add_cylinder(cylinder->radius, cylinder->length, pose, color, solids);
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&shape)) {
    solids.balls.push_back({pose.translation(), sphere->radius, color});
  }
}

}  // namespace treeline::pictures
