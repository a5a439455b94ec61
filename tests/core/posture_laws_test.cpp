// Posture laws compared with closed forms. Would catch: a wrong sign (a law that destabilizes), an
// avoidance that jumps or grows without bound, and a balance law that moves the centre of mass
// elsewhere.
#include "core/posture_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace treeline::core;  // NOLINT: the whole header is under test

TEST(PostureLaws, PotentialsDescend) {
  const double q[2] = {0.3, -0.2};
  // V = 2 x^2 + x y: exact for central differences.
  const auto potential = [](const double(&x)[2]) { return 2 * x[0] * x[0] + x[0] * x[1]; };
  const auto gradient = [](const double(&x)[2], double(&slope)[2]) {
    slope[0] = 4 * x[0] + x[1];
    slope[1] = x[0];
  };
  double by_gradient[2] = {1.0, 2.0};
  double by_differences[2] = {1.0, 2.0};
  add_potential(gradient, q, by_gradient);
  add_potential_by_differences(potential, 1e-3, q, by_differences);
  EXPECT_DOUBLE_EQ(by_gradient[0], 1.0 - 1.0);
  EXPECT_DOUBLE_EQ(by_gradient[1], 2.0 - 0.3);
  EXPECT_NEAR(by_differences[0], by_gradient[0], 1e-12);
  EXPECT_NEAR(by_differences[1], by_gradient[1], 1e-12);
}

TEST(PostureLaws, DampingOpposesMotion) {
  const double qd[2] = {3.0, -1.0};
  double qdd[2] = {0.5, 0.5};
  add_damping(2.0, qd, qdd);
  EXPECT_DOUBLE_EQ(qdd[0], -5.5);
  EXPECT_DOUBLE_EQ(qdd[1], 2.5);
}

double avoidance(double q, double qd) {
  const double lower[1] = {-1.0};
  const double upper[1] = {std::numeric_limits<double>::infinity()};
  double qdd[1] = {};
  add_limit_avoidance(lower, upper, 0.2, 50.0, 4.0, {q}, {qd}, qdd);
  return qdd[0];
}

TEST(PostureLaws, LimitAvoidanceIsSmoothAndBounded) {
  EXPECT_EQ(avoidance(0.0, 3.0), 0.0);
  EXPECT_EQ(avoidance(-0.79, 3.0), 0.0);
  EXPECT_DOUBLE_EQ(avoidance(-0.9, 0.0), 25.0);
  EXPECT_DOUBLE_EQ(avoidance(-1.0, 1.0), 50.0 - 4.0);
  EXPECT_DOUBLE_EQ(avoidance(-7.0, 0.0), 50.0);
  double before = avoidance(-1.3, 0.0);
  for (double q = -1.3; q < -0.7; q += 1e-4) {
    const double now = avoidance(q, 0.0);
    EXPECT_LE(now, before + 1e-12);
    // Slope of the smooth step: 1.5 strength / margin.
    EXPECT_LE(before - now, 1.5 * 50.0 / 0.2 * 1e-4 * 1.001);
    before = now;
  }
}

TEST(PostureLaws, NearestPointOfASquare) {
  const double square[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
  double nearest[2];
  nearest_in_polygon(square, {0.3, -0.9}, nearest);
  EXPECT_EQ(nearest[0], 0.3);
  EXPECT_EQ(nearest[1], -0.9);
  nearest_in_polygon(square, {3.0, 0.25}, nearest);
  EXPECT_EQ(nearest[0], 1.0);
  EXPECT_EQ(nearest[1], 0.25);
  nearest_in_polygon(square, {-4.0, 9.0}, nearest);
  EXPECT_EQ(nearest[0], -1.0);
  EXPECT_EQ(nearest[1], 1.0);
}

TEST(PostureLaws, BalanceAcceleratesTheCentreOfMassAsAsked) {
  const double J[6] = {0.5, 0.2, -0.1, 0.0, 0.4, 0.3};
  const double com[2] = {0.05, -0.02};
  const double goal[2] = {0.0, 0.0};
  const double qd[3] = {0.1, 0.2, -0.3};
  double qdd[3] = {};
  add_balance({100.0, 20.0}, goal, com, J, 1e-6, qd, qdd);
  for (int row = 0; row < 2; ++row) {
    double speed = 0.0;
    double acceleration = 0.0;
    for (int i = 0; i < 3; ++i) {
      speed += J[3 * row + i] * qd[i];
      acceleration += J[3 * row + i] * qdd[i];
    }
    EXPECT_NEAR(acceleration, -100.0 * com[row] - 20.0 * speed, 1e-9);
  }
  // Joints that cannot move it get no command, and no NaN.
  const double none[6] = {};
  double still[3] = {};
  add_balance({100.0, 20.0}, goal, com, none, 1e-3, qd, still);
  for (const double acceleration : still) {
    EXPECT_EQ(acceleration, 0.0);
  }
}

}  // namespace
