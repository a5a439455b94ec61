#include "drawing/solids.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace treeline {
namespace {

void add_face(const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal,
              const Eigen::Isometry3d& pose, const Color& color, Solids& solids) {
  Face face;
  for (const Eigen::Vector3d& corner : corners) face.corners.push_back(pose * corner);
  face.normal = pose.linear() * normal;
  face.color = color;
  solids.faces.push_back(face);
}

}  // namespace

void add_solids(const Solids& others, Solids& solids) {
  solids.faces.insert(solids.faces.end(), others.faces.begin(), others.faces.end());
  solids.balls.insert(solids.balls.end(), others.balls.begin(), others.balls.end());
}

void add_box(const Eigen::Vector3d& size, const Eigen::Isometry3d& pose, const Color& color,
             Solids& solids) {
  const Eigen::Vector3d half = 0.5 * size;
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

void add_cylinder(double radius, double length, int sides, const Eigen::Isometry3d& pose,
                  const Color& color, Solids& solids) {
  const auto rim = [&](int k, double z) {
    const double angle = 2 * std::numbers::pi * k / sides;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  std::vector<Eigen::Vector3d> bottom;
  std::vector<Eigen::Vector3d> top;
  for (int k = 0; k < sides; ++k) {
    bottom.push_back(rim(k, -0.5 * length));
    top.push_back(rim(k, 0.5 * length));
    const double middle = 2 * std::numbers::pi * (k + 0.5) / sides;
    add_face({bottom.back(), rim(k + 1, -0.5 * length), rim(k + 1, 0.5 * length), top.back()},
             {std::cos(middle), std::sin(middle), 0}, pose, color, solids);
  }
  add_face(bottom, -Eigen::Vector3d::UnitZ(), pose, color, solids);
  add_face(top, Eigen::Vector3d::UnitZ(), pose, color, solids);
}

void add_rod(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
             const Color& color, Solids& solids) {
  solids.balls.push_back({from, radius, color});
  solids.balls.push_back({to, radius, color});
  const Eigen::Vector3d along = to - from;
  if (along.norm() <= radius) return;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(0.5 * (from + to)));
  pose.rotate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along));
  add_cylinder(radius, along.norm(), kThinSides, pose, color, solids);
}

}  // namespace treeline
