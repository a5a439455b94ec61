// The simulated ground. Would catch: a ground that pulls, points that creep while friction holds
// them, and friction that is too small or too large.
#include "servo/compliant_ground.hpp"

#include <gtest/gtest.h>

namespace treeline::servo {
namespace {

constexpr double kGravity = 9.81;

/// A mass of 1 kg on the ground under gravity and the force `along` the plane, N, for `time` s by
/// semi-implicit Euler steps of 0.1 ms.
struct Block {
  CompliantGround<1> ground{GroundMaterial{1e4, 60.0, 0.5}};
  CompliantGround<1>::Vectors x{}, v{};

  void advance(double along, double time) {
    constexpr double kStep = 1e-4;
    for (double now = 0.0; now < time; now += kStep) {
      const auto force = ground.forces(x, v);
      const double a[3] = {force[0][0] + along, force[0][1], force[0][2] - kGravity};
      for (std::size_t k = 0; k < 3; ++k) {
        v[0][k] += kStep * a[k];
        x[0][k] += kStep * v[0][k];
      }
      ground.slide_springs(x);
    }
  }
};

TEST(CompliantGround, CarriesAWeightAndHoldsItWithinFriction) {
  Block block;
  block.advance(0.0, 1.0);
  // The spring's depth; what is left of the transient after 30 time constants is below 1e-12.
  EXPECT_NEAR(block.x[0][2], -kGravity / 1e4, 1e-9);
  block.advance(0.2 * kGravity, 1.0);  // overshoots to less than twice as much
  EXPECT_NEAR(block.x[0][0], 0.2 * kGravity / 1e4, 1e-9);
  EXPECT_EQ(block.ground.slipped(), 0.0);
}

TEST(CompliantGround, SlidesBeyondFriction) {
  Block block;
  block.advance(0.0, 1.0);
  block.advance(0.8 * kGravity, 1.0);
  // a = (0.8 - 0.5) g once the spring is stretched, by 0.5 g / k, which takes about 12 ms. Until
  // then friction is less by up to 0.5 g.
  EXPECT_NEAR(block.v[0][0], 0.3 * kGravity, 0.012 * 0.5 * kGravity);
  EXPECT_GT(block.ground.slipped(), 1.0);
}

TEST(CompliantGround, NeverPulls) {
  CompliantGround<1> ground{GroundMaterial{1e4, 60.0, 0.5}};
  ground.slide_springs({{{0.0, 0.0, -1e-3}}});
  EXPECT_EQ(ground.forces({{{0.0, 0.0, -1e-3}}}, {{{0.0, 0.0, 1.0}}})[0][2], 0.0);
  EXPECT_EQ(ground.forces({{{0.0, 0.0, 1e-3}}}, {{{0.0, 0.0, -1.0}}})[0][2], 0.0);
  EXPECT_EQ(ground.forces({{{0.1, 0.0, 1e-3}}}, {{{1.0, 0.0, 0.0}}})[0][0], 0.0);
}

}  // namespace
}  // namespace treeline::servo
