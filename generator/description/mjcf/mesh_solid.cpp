#include <cmath>

#include "description/mjcf/read_geom.hpp"

namespace treeline {
namespace {

double area_of(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  return (b - a).cross(c - a).norm() / 2;
}

/// The centre of the surface's area.
Eigen::Vector3d center_of_surface(const std::vector<Triangle>& surface) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (const Triangle& triangle : surface) {
    const auto& [a, b, c] = triangle.corners;
    const double part = area_of(triangle);
    sum += part * (a + b + c) / 3;
    area += part;
  }
  return area > 0 ? Eigen::Vector3d(sum / area) : sum;
}

/// The tetrahedron of a triangle with a fourth corner: corners are relative to that.
struct Tetrahedron {
  Eigen::Vector3d a, b, c;
  double volume;
};

Tetrahedron tetrahedron(const std::array<Eigen::Vector3d, 3>& triangle,
                        const Eigen::Vector3d& fourth, bool overlapping) {
  const Eigen::Vector3d a = triangle[0] - fourth, b = triangle[1] - fourth,
                        c = triangle[2] - fourth;
  const double volume = a.cross(b).dot(c) / 6;
  return {a, b, c, overlapping ? std::abs(volume) : volume};
}

Eigen::Vector3d center_of(const std::vector<Triangle>& surface, bool overlapping) {
  const Eigen::Vector3d from = center_of_surface(surface);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double volume = 0;
  for (const Triangle& triangle : surface) {
    const Tetrahedron part = tetrahedron(triangle.corners, from, overlapping);
    moment += part.volume / 4 * (part.a + part.b + part.c);
    volume += part.volume;
  }
  return from + moment / volume;
}

/// Moments of inertia about two axes each from second moments.
Eigen::Matrix3d inertia_from(const Eigen::Matrix3d& second) {
  return second.trace() * Eigen::Matrix3d::Identity() - second;
}

}  // namespace

/// Second moments of a tetrahedron of volume V with corners a, b, c and 0 are
/// V / 20 (aa' + bb' + cc' + ss'), where s = a + b + c.
Solid solid_within(const std::vector<Triangle>& surface, bool overlapping) {
  Solid solid;
  solid.center = center_of(surface, overlapping);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Triangle& triangle : surface) {
    const auto [a, b, c, volume] = tetrahedron(triangle.corners, solid.center, overlapping);
    const Eigen::Vector3d sum = a + b + c;
    solid.volume += volume;
    second += volume / 20 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  solid.inertia = inertia_from(second);
  return solid;
}

/// Second moments of a triangle of area A with corners a, b, c are
/// A / 12 (aa' + bb' + cc' + ss'), where s = a + b + c.
Solid solid_on(const std::vector<Triangle>& surface) {
  Solid solid;
  solid.center = center_of_surface(surface);
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Triangle& triangle : surface) {
    const double area = area_of(triangle);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : triangle.corners) {
      const Eigen::Vector3d from = corner - solid.center;
      sum += from;
      second += area / 12 * from * from.transpose();
    }
    second += area / 12 * sum * sum.transpose();
    solid.volume += area;
  }
  solid.inertia = inertia_from(second);
  return solid;
}

}  // namespace treeline
