// Would catch: distances of boxes, cylinders and spheres that are not those of closed forms, in any
// pose.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "driving/robot_shapes.hpp"

namespace treeline {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

Visual shape(VisualKind kind, const Vector3d& size, const Vector3d& at,
             const Eigen::Matrix3d& turned = Eigen::Matrix3d::Identity()) {
  Visual visual;
  visual.kind = kind;
  visual.size = size;
  visual.pose.translation() = at;
  visual.pose.linear() = turned;
  return visual;
}
Visual box(const Vector3d& size, const Vector3d& at) {
  return shape(VisualKind::box, size, at);
}

TEST(ConvexDistance, IsThatOfClosedForms) {
  const Visual unit = box({1, 1, 1}, {0, 0, 0});
  EXPECT_NEAR(convex_distance(unit, box({1, 1, 1}, {1.2, 0.3, 0})), 0.2, 1e-5);
  EXPECT_NEAR(convex_distance(unit, box({1, 1, 1}, {1.3, 1.4, 0})), 0.5, 1e-5);
  EXPECT_EQ(convex_distance(unit, box({1, 1, 1}, {0.9, 0, 0})), 0.0);
  EXPECT_EQ(convex_distance(unit, box({0.1, 0.1, 0.1}, {0, 0, 0})), 0.0);
  const Visual ball = shape(VisualKind::sphere, {0.25, 0, 0}, {1, 0.1, 0.2});
  EXPECT_NEAR(convex_distance(unit, ball), 0.25, 1e-5);
  EXPECT_NEAR(convex_distance(ball, shape(VisualKind::sphere, {0.5, 0, 0}, {1, 0.1, 2.2})), 1.25,
              1e-5);
  // A roof: the edge of a box that is turned by 45 degrees, over a face.
  const Visual edge = shape(VisualKind::box, {1, 1, 1}, {0.1, 0.1, 0.6 + std::sqrt(0.5)},
                            AngleAxisd(std::numbers::pi / 4, Vector3d::UnitX()).toRotationMatrix());
  EXPECT_NEAR(convex_distance(unit, edge), 0.1, 1e-5);
  // A cylinder that lies along x, beside the box; and one that stands.
  const auto lying = AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()).toRotationMatrix();
  EXPECT_NEAR(convex_distance(unit, shape(VisualKind::cylinder, {0.2, 2, 0}, {0, 0.8, 0}, lying)),
              0.1, 1e-5);
  EXPECT_NEAR(convex_distance(unit, shape(VisualKind::cylinder, {0.2, 2, 0}, {0.8, 0.8, 0})),
              0.3 * std::sqrt(2.0) - 0.2, 1e-5);
}

// Moved and turned together, both are as far from each other.
TEST(ConvexDistance, DoesNotDependOnAxes) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vector3d(number(rng), number(rng), number(rng)); };
  int apart = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const auto kind = [&] { return static_cast<VisualKind>(std::abs(number(rng)) * 2.999); };
    const auto size = [&] { return Vector3d(0.1 + vector().cwiseAbs().array()); };
    const auto turned = [&] {
      return AngleAxisd(3 * number(rng), vector().normalized()).toRotationMatrix();
    };
    Visual a = shape(kind(), size(), vector(), turned());
    Visual b = shape(kind(), size(), 2 * vector(), turned());
    const double distance = convex_distance(a, b);
    EXPECT_NEAR(convex_distance(b, a), distance, 1e-5) << draw;
    apart += distance > 0 ? 1 : 0;
    Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
    move.linear() = turned();
    move.translation() = vector();
    a.pose = move * a.pose;
    b.pose = move * b.pose;
    EXPECT_NEAR(convex_distance(a, b), distance, 1e-5) << draw;
  }
  EXPECT_GT(apart, 30);
  EXPECT_LT(apart, 195);
}

TEST(LowestOf, IsTheLowestPoint) {
  EXPECT_NEAR(lowest_of(box({1, 1, 2}, {0, 0, 3})), 2.0, 1e-12);
  EXPECT_NEAR(lowest_of(shape(VisualKind::sphere, {0.5, 0, 0}, {0, 0, 3})), 2.5, 1e-12);
  const auto lying = AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()).toRotationMatrix();
  EXPECT_NEAR(lowest_of(shape(VisualKind::cylinder, {0.2, 2, 0}, {0, 0, 1}, lying)), 0.8, 1e-12);
}

}  // namespace
}  // namespace treeline
