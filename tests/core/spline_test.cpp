// Closed forms of the cubic, boundary conditions, derivatives by difference quotients. Would catch:
// a wrong coefficient, a velocity that is not the derivative, and motion beyond the ends.
#include "core/spline.hpp"

#include <gtest/gtest.h>

namespace {

using treeline::core::hermite_segment;
using treeline::core::rest_to_rest;

TEST(Spline, RestToRestClosedForm) {
  const double from[2] = {1.0, -2.0};
  const double to[2] = {3.0, 4.0};
  const auto segment = rest_to_rest(from, to, 2.0);
  // Halfway: the middle, 3/2 of the mean speed, no acceleration. At the start: 6 d / T^2.
  const auto middle = segment.at(1.0);
  EXPECT_DOUBLE_EQ(middle.position[0], 2.0);
  EXPECT_DOUBLE_EQ(middle.velocity[0], 1.5);
  EXPECT_DOUBLE_EQ(middle.velocity[1], 4.5);
  EXPECT_NEAR(middle.acceleration[0], 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(segment.at(0.0).acceleration[0], 3.0);
  EXPECT_DOUBLE_EQ(segment.at(2.0).acceleration[1], -9.0);
}

TEST(Spline, HermiteMeetsItsEnds) {
  const double x0[1] = {0.3};
  const double v0[1] = {-1.0};
  const double x1[1] = {0.9};
  const double v1[1] = {2.0};
  const auto segment = hermite_segment(x0, v0, x1, v1, 0.7);
  EXPECT_DOUBLE_EQ(segment.at(0.0).position[0], 0.3);
  EXPECT_DOUBLE_EQ(segment.at(0.0).velocity[0], -1.0);
  EXPECT_NEAR(segment.at(0.7).position[0], 0.9, 1e-15);
  EXPECT_NEAR(segment.at(0.7).velocity[0], 2.0, 1e-14);
}

TEST(Spline, VelocityAndAccelerationAreDerivatives) {
  const double x0[1] = {0.3};
  const double v0[1] = {-1.0};
  const double x1[1] = {0.9};
  const double v1[1] = {2.0};
  const auto segment = hermite_segment(x0, v0, x1, v1, 0.7);
  const double h = 1e-5;  // error of the quotients: h^2 times the third derivative, plus 1e-16/h
  for (double t = 0.05; t < 0.65; t += 0.05) {
    const auto before = segment.at(t - h);
    const auto after = segment.at(t + h);
    EXPECT_NEAR(segment.at(t).velocity[0], (after.position[0] - before.position[0]) / (2 * h),
                1e-8);
    EXPECT_NEAR(segment.at(t).acceleration[0], (after.velocity[0] - before.velocity[0]) / (2 * h),
                1e-8);
  }
}

TEST(Spline, RestsOutside) {
  const float from[1] = {1.0F};
  const float to[1] = {2.0F};
  const auto segment = rest_to_rest(from, to, 0.5F);
  for (const float t : {-1.0F, 0.75F}) {
    const auto motion = segment.at(t);
    EXPECT_EQ(motion.position[0], t < 0.0F ? 1.0F : 2.0F);
    EXPECT_EQ(motion.velocity[0], 0.0F);
    EXPECT_EQ(motion.acceleration[0], 0.0F);
  }
}

}  // namespace
