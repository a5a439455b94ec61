#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "driving/robot_shapes.hpp"

namespace treeline {
namespace {

using Eigen::Vector3d;

/// The point of a shape that is farthest in a direction; of a sphere its centre.
Vector3d support(const Visual& shape, const Vector3d& direction) {
  const Vector3d d = shape.pose.linear().transpose() * direction;
  Vector3d local = Vector3d::Zero();
  if (shape.kind == VisualKind::box) {
    for (int i = 0; i < 3; ++i) local[i] = std::copysign(0.5 * shape.size[i], d[i]);
  } else if (shape.kind == VisualKind::cylinder) {
    const double across = std::hypot(d.x(), d.y());
    const double share = across > 0 ? shape.size.x() / across : 0;
    local = {share * d.x(), share * d.y(), std::copysign(0.5 * shape.size.y(), d.z())};
  }
  return shape.pose * local;
}

double radius_of(const Visual& shape) {
  return shape.kind == VisualKind::sphere ? shape.size.x() : 0;
}

using Simplex = std::vector<Vector3d>;

/// The point nearest to the origin in the plane, line or point through some points, where it lies
/// between them.
bool nearest_between(const Simplex& points, Vector3d& nearest) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Ones(n + 1, n + 1);
  A(n, n) = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      A(i, j) = points[static_cast<std::size_t>(i)].dot(points[static_cast<std::size_t>(j)]);
    }
  }
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
  b[n] = 1;
  const Eigen::FullPivLU<Eigen::MatrixXd> factors(A);
  if (!factors.isInvertible()) return false;
  const Eigen::VectorXd weights = factors.solve(b);
  nearest.setZero();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!(weights[i] >= 0)) return false;
    nearest += weights[i] * points[static_cast<std::size_t>(i)];
  }
  return true;
}

/// The point of a simplex of at most four corners that is nearest to the origin; leaves the corners
/// between which it lies.
Vector3d reduce(Simplex& simplex) {
  Simplex best;
  Vector3d nearest = Vector3d::Zero();
  const unsigned count = 1U << simplex.size();
  for (unsigned chosen = 1; chosen < count; ++chosen) {
    Simplex part;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if ((chosen >> i & 1U) != 0) part.push_back(simplex[i]);
    }
    Vector3d here;
    if (!nearest_between(part, here)) continue;
    if (!best.empty() && here.norm() >= nearest.norm()) continue;
    nearest = here;
    best = std::move(part);
  }
  simplex = std::move(best);
  return nearest;
}

}  // namespace

double convex_distance(const Visual& a, const Visual& b) {
  constexpr int kMostSteps = 100;
  constexpr double kFine = 1e-6;  // m
  const double radii = radius_of(a) + radius_of(b);
  Vector3d v = a.pose.translation() - b.pose.translation();
  Simplex simplex;
  for (int step = 0; step < kMostSteps; ++step) {
    const double distance = v.norm();
    if (distance <= radii + kFine && step > 0) return 0;
    const Vector3d s = support(a, -v) - support(b, v);
    if (!simplex.empty() && distance - v.dot(s) / distance < kFine) break;
    simplex.push_back(s);
    v = reduce(simplex);
  }
  return std::max(v.norm() - radii, 0.0);
}

double lowest_of(const Visual& shape) {
  return support(shape, -Vector3d::UnitZ()).z() - radius_of(shape);
}

}  // namespace treeline
