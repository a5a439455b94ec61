// Would catch: inertial parameters that no body has, for which a mass matrix may have no inverse;
// bodies beyond the ranges that contracts state; links of almost nothing.
#include "bounds/draw_body.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "bounds/rng.hpp"

namespace treeline::bounds {
namespace {

using Parameters = std::array<double, kInertialParameters>;

/// A distribution of matter has these parameters where its pseudo-inertia has no negative
/// eigenvalue (Wensing, Kim & Slotine 2018).
Eigen::Matrix4d pseudo_inertia(const Parameters& p) {
  const double half = (p[4] + p[6] + p[9]) / 2;
  Eigen::Matrix4d pseudo;
  pseudo << half - p[4], -p[5], -p[7], p[1],  //
      -p[5], half - p[6], -p[8], p[2],        //
      -p[7], -p[8], half - p[9], p[3],        //
      p[1], p[2], p[3], p[0];
  return pseudo;
}

Parameters choose(Rng& rng, int index) {
  Parameters choice{};
  for (double& each : choice) each = index % 2 == 0 ? rng.within(1) : rng.chance(0.5) ? 1 : -1;
  return choice;
}

TEST(BodyOf, IsABodyWithinTheRange) {
  Rng rng(4);
  const BodyRange range{3, 0.2};
  for (int index = 0; index < 1000; ++index) {
    const Parameters p = body_of(range, choose(rng, index));
    const double least =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(pseudo_inertia(p)).eigenvalues()(0);
    EXPECT_GE(least, -1e-15);
    EXPECT_GE(p[0], 0);
    EXPECT_LE(p[0], 3);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_LE(std::abs(p[i]), p[0] * 0.2 * (1 + 1e-12));
    // The trace of the second moment is that of matter within reach.
    EXPECT_LE((p[4] + p[6] + p[9]) / 2, p[0] * 0.04 * (1 + 1e-12));
  }
}

TEST(BodyOf, IsSomethingWhereItIsWhole) {
  Rng rng(5);
  for (int index = 0; index < 1000; ++index) {
    const Parameters p = body_of({3, 0.2, true}, choose(rng, index));
    EXPECT_GE(p[0], 0.3 * (1 - 1e-12));
    const Eigen::Matrix4d pseudo = pseudo_inertia(p);
    const Eigen::Matrix3d central =
        pseudo.topLeftCorner<3, 3>() -
        pseudo.topRightCorner<3, 1>() * pseudo.bottomLeftCorner<1, 3>() / p[0];
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(central).eigenvalues()(0);
    EXPECT_GE(least, p[0] * 0.02 * 0.02 * (1 - 1e-9));
  }
}

TEST(BodyOf, ReachesTheLimits) {
  const Parameters far = body_of({3, 0.2}, {1, 1, 1, 1, 0, 0, 0, 0, 0, 0});
  EXPECT_DOUBLE_EQ(far[0], 3);
  EXPECT_NEAR(std::hypot(far[1], far[2], far[3]), 3 * 0.2, 1e-15);
  const Parameters none = body_of({3, 0.2}, {0, 1, 1, 1, 1, 1, 1, 1, 1, 1});
  for (const double entry : none) EXPECT_EQ(entry, 0);
}

}  // namespace
}  // namespace treeline::bounds
