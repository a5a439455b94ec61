#include "simulation/collide.hpp"

#include <gtest/gtest.h>

#include "simulation/sample.hpp"

// Would catch: a normal that points into the touched shape, a point in the wrong frame, a shape
// that does not move with its link, and links of one robot that touch each other.

namespace treeline::tests {
namespace {

using namespace simulation;  // NOLINT(google-build-using-namespace)

TEST(Collide, BallOnTheGround) {
  Sample sample = balls(1);
  const CollisionScene scene(sample.model, {sphere_on(0, 0.1), ground()});
  sample.state.q.head<3>() << 0.3, -0.2, 0.11;
  EXPECT_TRUE(scene.touches(sample.model, sample.state.q).empty());
  sample.state.q(2) = 0.09;
  const auto touches = scene.touches(sample.model, sample.state.q);
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_EQ(touches[0].body, 0);
  EXPECT_EQ(touches[0].other_body, interpreter::kWorld);
  EXPECT_NEAR(touches[0].depth, 0.01, 1e-12);
  EXPECT_LT((touches[0].normal - Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((touches[0].position - Vector3(0.3, -0.2, -0.005)).norm(), 1e-12);
}

TEST(Collide, EveryShapeOnAnInclinedPlane) {
  Sample sample = balls(1);
  const Matrix3 R = interpreter::rotation_about<double>(Vector3::UnitY(), 0.5);
  Shape plane = ground();
  plane.R = R;
  plane.p = {0, 0, 1};
  const Vector3 n = R.col(2);
  for (const auto& [kind, size, reach] :
       {std::tuple{ShapeKind::sphere, Vector3(0.1, 0, 0), 0.1},
        std::tuple{ShapeKind::capsule, Vector3(0.1, 0.4, 0), 0.1 + 0.2 * std::cos(0.5)},
        std::tuple{ShapeKind::cylinder, Vector3(0.1, 0.4, 0),
                   0.1 * std::sin(0.5) + 0.2 * std::cos(0.5)},
        std::tuple{ShapeKind::box, Vector3(0.2, 0.2, 0.4),
                   0.1 * std::sin(0.5) + 0.2 * std::cos(0.5)}}) {
    SCOPED_TRACE(static_cast<int>(kind));
    Shape shape = sphere_on(0, 0.1);
    shape.kind = kind;
    shape.size = size;
    const CollisionScene scene(sample.model, {shape, plane});
    sample.state.q.head<3>() = plane.p + n * (reach - 0.01);
    const auto touches = scene.touches(sample.model, sample.state.q);
    ASSERT_EQ(touches.size(), 1U);
    if (kind != ShapeKind::box) {  // along the edge any point is as deep
      EXPECT_NEAR(touches[0].depth, 0.01, 1e-9);
    }
    EXPECT_LT((touches[0].normal - n).norm(), 1e-9);
    sample.state.q.head<3>() = plane.p + n * (reach + 0.01);
    EXPECT_TRUE(scene.touches(sample.model, sample.state.q).empty());
  }
}

TEST(Collide, TwoBallsInTheAir) {
  Sample sample = balls(2);
  const CollisionScene scene(sample.model, {sphere_on(0, 0.1), sphere_on(1, 0.1), ground()});
  sample.state.q.head<3>() << 0, 0, 1;
  sample.state.q.segment<3>(7) << 0.18, 0, 1;
  const auto touches = scene.touches(sample.model, sample.state.q);
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_EQ(touches[0].body, 1);
  EXPECT_EQ(touches[0].other_body, 0);
  EXPECT_LT((touches[0].normal - Vector3::UnitX()).norm(), 1e-9);
  EXPECT_NEAR(touches[0].depth, 0.02, 1e-9);
}

// A tree whose links are all balls larger than the distance between them.
TEST(Collide, LinksOfOneRobotDoNotTouch) {
  const Sample sample = random_sample(3, {.joints = 5, .branching = 0.5, .floating_base = true});
  std::vector<Shape> shapes{ground()};
  shapes[0].p.z() = -100;
  for (int i = 0; i < sample.model.size(); ++i) shapes.push_back(sphere_on(i, 1));
  EXPECT_TRUE(CollisionScene(sample.model, shapes).touches(sample.model, sample.state.q).empty());
  shapes[0].p.z() = 100;  // all deep inside
  EXPECT_EQ(CollisionScene(sample.model, shapes).touches(sample.model, sample.state.q).size(),
            static_cast<std::size_t>(sample.model.size()));
}

}  // namespace
}  // namespace treeline::tests
