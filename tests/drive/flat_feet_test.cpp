#include "drive/flat_feet.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

// Would catch: a foot that tips because more is asked than its sole can bear, a law for the wrong
// edge, forces beyond friction, and torques that are cut although the foot stands.

namespace treeline::drive {
namespace {

/// A sole from -0.1 to 0.2 m along x and 0.1 m to either side, pressed by 100 N. Its ankle, 0.05 m
/// above it, turns about y, and a slide pushes along x; at rest neither does.
struct Standing {
  static constexpr int kCoordinates = 2;
  static constexpr int kVelocities = 2;
  static constexpr int kLinks = 1;
  static constexpr int kHeldRows = 6;
  static constexpr int kWorldRows = 6;
  static constexpr WorldHold kWorldHolds[] = {
      {0, {0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {true, true, true, true, true, true}, false}};
  static constexpr SolePoint kSolePoints[] = {{{-0.1, -0.1, -0.04}, 0.01},
                                              {{0.2, -0.1, -0.05}, 0},
                                              {{-0.1, 0.1, -0.05}, 0},
                                              {{0.2, 0.1, -0.05}, 0},
                                              {{0.5, 0, 0.3}, 0}};
  static constexpr int kSoleEnds[] = {5};
  static constexpr double kFriction = 0.5;
  using GroundMemory = int;
  using GroundReport = int;

  static void link_frames(const double (&)[2], double (&p)[3], double (&R)[9]) noexcept {
    const std::array<double, 9> upright = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (int i = 0; i < 9; ++i) R[i] = upright[static_cast<std::size_t>(i)];
    p[0] = p[1] = 0;
    p[2] = 0.05;
  }
  static void inverse_dynamics(const double (&)[2], const double (&)[2], const double (&)[2],
                               double (&tau)[2]) noexcept {
    tau[0] = tau[1] = 0;
  }
  static void constrained_forward_dynamics(const double (&)[2], const double (&)[2],
                                           const double (&tau)[2], const double (&)[2],
                                           const double (&)[6], double (&)[2],
                                           double (&f)[6]) noexcept {
    f[0] = tau[1];
    f[1] = f[3] = f[5] = 0;
    f[2] = 100;
    f[4] = -tau[0] - 0.05 * tau[1];  // about the frame, so that the slide does not move the centre
  }
};

std::array<double, 2> kept(double ankle, double slide) {
  const double none[2] = {};
  double tau[2] = {ankle, slide};
  FlatFeet<Standing>(none).keep(none, none, tau);
  return {tau[0], tau[1]};
}

// The centre of pressure is at tau / 100 N, and stays a tenth of 0.3 m from the edges.
TEST(FlatFeet, KeepsTheCentreOfPressureWithinTheSole) {
  EXPECT_EQ(kept(16, 0)[0], 16);
  EXPECT_NEAR(kept(50, 0)[0], 17, 1e-12);
  EXPECT_EQ(kept(-6, 0)[0], -6);
  EXPECT_NEAR(kept(-50, 0)[0], -7, 1e-12);
}

// What is cut is all torque alike.
TEST(FlatFeet, KeepsForcesWithinFriction) {
  const double most = 0.5 * 100 * std::sqrt(0.5);
  EXPECT_EQ(kept(5, 0.9 * most)[1], 0.9 * most);
  const auto tau = kept(5, -4 * most);
  EXPECT_NEAR(tau[1], -most, 1e-12 * most);
  EXPECT_NEAR(tau[0], 5.0 / 4, 1e-12);
}

}  // namespace
}  // namespace treeline::drive
