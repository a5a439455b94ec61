// Lost directions of planar arms and of a wrist whose singularities are known in closed form. Would
// catch: a wrong direction or type, a sign that follows the arbitrary sign of eigenvectors, a force
// in a lost direction, and an infinite result at the singularity itself.
#include "core/singularity.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace {

using namespace treeline::core;  // NOLINT: the whole header is under test

/// Jacobian of a planar arm with two links of length 1: elbow lock at q2 = 0, lost direction along
/// the arm.
void elbow_jacobian(const double (&q)[2], double (&J)[4]) {
  const double s1 = std::sin(q[0]);
  const double c1 = std::cos(q[0]);
  const double s12 = std::sin(q[0] + q[1]);
  const double c12 = std::cos(q[0] + q[1]);
  J[0] = -s1 - s12;
  J[1] = -s12;
  J[2] = c1 + c12;
  J[3] = c12;
}

/// Jacobian of a z-y-z wrist, angular velocity in world axes: lock at q2 = 0.
void wrist_jacobian(const double (&q)[3], double (&J)[9]) {
  const double s1 = std::sin(q[0]);
  const double c1 = std::cos(q[0]);
  const double s2 = std::sin(q[1]);
  const double c2 = std::cos(q[1]);
  const double columns[3][3] = {{0, 0, 1}, {-s1, c1, 0}, {c1 * s2, s1 * s2, c2}};
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 3; ++i) {
      J[3 * row + i] = columns[i][row];
    }
  }
}

template <int rows, int nv, class Function>
LostDirection<rows, double> look(const Function& jacobian, const double (&q)[nv],
                                 const double (&reference)[nv],
                                 SingularDirections<rows, nv, double>& found) {
  double J[rows * nv];
  double ahead[rows * nv];
  double behind[rows * nv];
  double n[nv];
  jacobian(q, J);
  found = singular_directions<rows, nv>(J, SingularRegion<double>{});
  lost_motion(found, rows - 1, reference, n);
  double there[nv];
  const double step = 1e-5;
  for (int i = 0; i < nv; ++i) {
    there[i] = q[i] + step * n[i];
  }
  jacobian(there, ahead);
  for (int i = 0; i < nv; ++i) {
    there[i] = q[i] - step * n[i];
  }
  jacobian(there, behind);
  double dJ[rows * nv];
  for (int i = 0; i < rows * nv; ++i) {
    dJ[i] = (ahead[i] - behind[i]) / (2 * step);
  }
  return lost_direction(found, rows - 1, J, dJ, n);
}

TEST(Singularity, ElbowLockMovesAlongTheArm) {
  const double q[2] = {0.6, 0.0};
  SingularDirections<2, 2, double> found;
  const auto lost = look<2>(elbow_jacobian, q, {0.0, 1.0}, found);
  EXPECT_NEAR(found.values[0], std::sqrt(5.0), 1e-14);
  EXPECT_NEAR(found.values[1], 0.0, 1e-7);
  EXPECT_EQ(found.shares[0], 1.0);
  EXPECT_EQ(found.shares[1], 0.0);
  const double* u = found.directions + 2;
  EXPECT_NEAR(std::fabs(u[0] * std::cos(0.6) + u[1] * std::sin(0.6)), 1.0, 1e-14);
  // n = (-1, 2) / sqrt(5); q2 = 2 s / sqrt(5), reach 2 cos(q2 / 2) = 2 - s^2 / 5: curvature 2 / 5.
  EXPECT_NEAR(std::fabs(lost.curvature), 0.4, 1e-9);
  EXPECT_EQ(singularity_type(lost), SingularityType::moves_along);
}

TEST(Singularity, WristLockOnlyTurns) {
  const double q[3] = {0.3, 0.0, -0.8};
  SingularDirections<3, 3, double> found;
  const auto lost = look<3>(wrist_jacobian, q, {1.0, 0.0, 0.0}, found);
  EXPECT_NEAR(found.values[2], 0.0, 1e-7);
  // Lost: rotation about x of the frame rotated by q1. n = (1, 0, -1) / sqrt(2) rotates it with q1.
  const double* u = found.directions + 6;
  EXPECT_NEAR(std::fabs(u[0] * std::cos(0.3) + u[1] * std::sin(0.3)), 1.0, 1e-14);
  EXPECT_NEAR(lost.curvature, 0.0, 1e-9);
  EXPECT_NEAR(Eigen::Vector3d::Map(lost.turn).norm(), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(lost.turn[2], 0.0, 1e-9);
  EXPECT_EQ(singularity_type(lost), SingularityType::turns);
}

// s, which the law measures from the singularity, does not depend on the signs in the decomposition
// of u and n, and grows with q2 if the reference does.
TEST(Singularity, MotionIsMeasuredFromTheSingularity) {
  for (double bend = -0.05; bend <= 0.05; bend += 0.01) {
    SingularDirections<2, 2, double> found;
    const auto lost = look<2>(elbow_jacobian, {1.0, bend}, {0.0, 1.0}, found);
    const double s = lost.sigma * lost.curvature / (lost.curvature * lost.curvature);
    EXPECT_NEAR(s, bend * std::sqrt(5.0) / 2.0, 1e-4);
  }
}

TEST(Singularity, DriveAlongGoesToTheWantedSide) {
  const NullMotionGains<double> gains{100.0, 20.0, 10.0};
  LostDirection<2, double> lost;
  lost.curvature = -0.4;
  lost.sigma = -0.4 * 0.1;  // s = 0.1, behind the singular place by 0.002
  EXPECT_NEAR(drive_along(gains, lost, 0.0, 1.0, 0.0), 0.0, 1e-3);
  EXPECT_NEAR(drive_along(gains, lost, 0.0, -1.0, 0.0), 100.0 * -0.2, 1e-3);
  // Beyond reach: the law goes to the singularity. Farther inside: more s.
  EXPECT_NEAR(drive_along(gains, lost, 1.0, 1.0, 0.0), 100.0 * -0.1, 1e-3);
  EXPECT_NEAR(drive_along(gains, lost, -0.006, 1.0, 0.0), 100.0 * 0.1, 2e-3);
  // The speed is limited and damped.
  EXPECT_NEAR(drive_along(gains, lost, -1e6, 1.0, 10.0), 0.0, 1e-9);
}

TEST(Singularity, TurnAwayEndsAcrossTheWantedMotion) {
  // u = (cos a, sin a), rotated by s itself; the error is along x.
  const NullMotionGains<double> gains;
  for (double start = 0.0; start < 6.3; start += 0.1) {
    double angle = start;
    double speed = 0.0;
    for (int step = 0; step < 20000; ++step) {
      const double u[2] = {std::cos(angle), std::sin(angle)};
      LostDirection<2, double> lost;
      lost.turn[0] = -u[1];
      lost.turn[1] = u[0];
      const double acceleration = turn_away(gains, u, lost, {0.3, 0.0}, 0.01, speed);
      ASSERT_TRUE(std::isfinite(acceleration));
      speed += 1e-3 * acceleration;
      angle += 1e-3 * speed;
    }
    EXPECT_LE(std::fabs(std::cos(angle)), 0.02) << "from " << start;
    EXPECT_LE(std::fabs(angle - start), M_PI / 2 + 0.1) << "from " << start;
  }
}

// Exactly at the lock: the regular direction is accelerated as commanded, the lost one gets no
// force.
TEST(Singularity, RegularForceSparesTheLostDirection) {
  const double q[2] = {0.6, 0.0};
  double J[4];
  elbow_jacobian(q, J);
  const auto found = singular_directions<2, 2>(J, SingularRegion<double>{});
  const Eigen::Matrix2d Jm = Eigen::Matrix<double, 2, 2, Eigen::RowMajor>::Map(J);
  const Eigen::Matrix2d M_inv = (Eigen::Matrix2d() << 2.0, -0.5, -0.5, 3.0).finished();
  double Lambda_inv[4];
  Eigen::Matrix<double, 2, 2, Eigen::RowMajor>::Map(Lambda_inv) = Jm * M_inv * Jm.transpose();
  const double missing[2] = {1.0, 5.0};
  double F[2];
  regular_task_force(found, {1.0, 1.0}, Lambda_inv, missing, F);
  const Eigen::Vector2d acceleration = Jm * M_inv * Jm.transpose() * Eigen::Vector2d::Map(F);
  const Eigen::Vector2d along(std::cos(0.6), std::sin(0.6));
  const Eigen::Vector2d across(-along[1], along[0]);
  EXPECT_NEAR(along.dot(Eigen::Vector2d::Map(F)), 0.0, 1e-13);
  EXPECT_NEAR(across.dot(acceleration), across.dot(Eigen::Vector2d::Map(missing)), 1e-12);
}

// Outside the region it is the force by Lambda, up to rounding.
TEST(Singularity, RegularForceIsLambdaFarAway) {
  double J[4];
  elbow_jacobian({0.6, 1.2}, J);
  const auto found = singular_directions<2, 2>(J, SingularRegion<double>{});
  const double Lambda_inv[4] = {3.0, 0.7, 0.7, 2.0};
  double F[2];
  regular_task_force(found, {0.4, 1.0}, Lambda_inv, {1.0, 5.0}, F);
  EXPECT_NEAR(3.0 * F[0] + 0.7 * F[1], 1.0, 1e-13);
  EXPECT_NEAR(0.7 * F[0] + 2.0 * F[1], 5.0, 1e-13);
}

}  // namespace
