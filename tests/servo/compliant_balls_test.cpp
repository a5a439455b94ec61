// Simulated balls that touch another one. Would catch: balls that pull, a contact at the wrong
// place, so that rolling counts as slipping, friction that is too small or too large, and springs
// that outlive their contact.
#include "servo/compliant_balls.hpp"

#include <gtest/gtest.h>

namespace treeline::servo {
namespace {

constexpr BallMaterial kMaterial{1e4, 20.0, 0.5};
constexpr double kRadius = 0.01, kOther = 0.03, kDepth = 1e-4;

/// A ball above another one, so deep in it.
CompliantBalls<1>::Balls above(double depth) {
  CompliantBalls<1>::Balls balls{};
  balls[0].center = {0.0, 0.0, kRadius + kOther - depth};
  return balls;
}

CompliantBalls<1> contact() {
  return {{kRadius}, kOther, kMaterial};
}

TEST(CompliantBalls, PressAlongTheNormalAndNeverPull) {
  const MovingBall other;
  const auto pressed = contact().touches(above(kDepth), other)[0];
  EXPECT_NEAR(pressed.force[2], 1e4 * kDepth, 1e-12);
  EXPECT_EQ(pressed.force[0], 0.0);
  EXPECT_NEAR(pressed.point[2], kOther - 0.5 * kDepth, 1e-15);
  auto parting = above(kDepth);
  parting[0].velocity = {0.0, 0.0, 1.0};  // 20 N of damping against 1 N of the spring
  EXPECT_EQ(contact().touches(parting, other)[0].force[2], 0.0);
  parting[0].center[2] += 2.0 * kDepth;
  parting[0].velocity = {1.0, 0.0, -1.0};
  EXPECT_EQ(contact().touches(parting, other)[0].force[0], 0.0);
}

TEST(CompliantBalls, RollWithoutSlipping) {
  auto balls = above(kDepth);
  MovingBall other;
  other.spin = {0.0, 2.0, 0.0};
  balls[0].spin = {0.0, -2.0 * (kOther - 0.5 * kDepth) / (kRadius - 0.5 * kDepth), 0.0};
  auto rolling = contact();
  for (int step = 0; step < 1000; ++step) rolling.stretch_springs(1e-3, balls, other);
  const BallTouch touch = rolling.touches(balls, other)[0];
  EXPECT_NEAR(touch.sliding[0], 0.0, 1e-15);  // of velocities of 0.06 m/s
  EXPECT_NEAR(touch.force[0], 0.0, 1e-10);    // of a spring that 0.06 m would stretch to 600 N
  EXPECT_EQ(rolling.slipped(), 0.0);
}

TEST(CompliantBalls, StickUntilFrictionIsUsedUp) {
  auto balls = above(kDepth);
  const MovingBall other;
  auto sliding = contact();
  const auto slide = [&](double way) {
    balls[0].velocity = {0.0, 1e-3, 0.0};  // the place stays, as matter flows past the contact
    for (int step = 0; step < 1000; ++step) sliding.stretch_springs(way, balls, other);
    balls[0].velocity = {};
  };
  slide(2e-5);  // 20 um, of 50 um that friction holds
  EXPECT_NEAR(sliding.touches(balls, other)[0].force[1], -1e4 * 2e-5, 1e-9);
  EXPECT_EQ(sliding.slipped(), 0.0);
  slide(8e-5);  // 100 um in all
  EXPECT_NEAR(sliding.touches(balls, other)[0].force[1], -0.5 * 1e4 * kDepth, 1e-9);
  EXPECT_NEAR(sliding.slipped(), 5e-5, 1e-12);
  sliding.stretch_springs(1.0, above(-kDepth), other);
  EXPECT_EQ(sliding.touches(balls, other)[0].force[1], 0.0);
}

}  // namespace
}  // namespace treeline::servo
