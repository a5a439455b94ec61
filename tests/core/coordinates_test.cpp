// Would catch: a quaternion that turns in the wrong axes or drifts in length, a difference that is
// not the inverse of integration or that takes the long way round, velocities that belong to other
// coordinates behind a joint with a quaternion.
#include "core/coordinates.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace {

using treeline::core::difference;
using treeline::core::integrate;
using treeline::core::QuaternionJoint;

// A hinge, a floating joint, a planar joint (x, y, theta), a ball, a slide.
constexpr QuaternionJoint kJoints[] = {{1, true}, {11, false}};
constexpr int kPositions = 16;
constexpr int kVelocities = 14;

struct Drawn {
  double q[kPositions], qd[kVelocities];
};

Drawn draw(std::mt19937_64& engine, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  Drawn drawn;
  for (double& x : drawn.q) x = number(engine);
  for (double& x : drawn.qd) x = number(engine);
  return drawn;
}

Eigen::Quaterniond rotation(const double* q) {
  return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized();
}

Eigen::Quaterniond turn_by(const double* w, double dt) {
  const Eigen::Vector3d v = dt * Eigen::Vector3d(w[0], w[1], w[2]);
  return Eigen::Quaterniond(Eigen::AngleAxisd(v.norm(), v.normalized()));
}

TEST(Coordinates, TurnByTheExponentialInTheLinksAxes) {
  std::mt19937_64 engine(7);
  for (int k = 0; k < 200; ++k) {
    const Drawn at = draw(engine, k % 2 == 0 ? 2 : 1e-6);
    double next[kPositions];
    integrate(kJoints, at.q, at.qd, 0.3, next);
    for (const auto& [q, w] : {std::pair{4, 4}, std::pair{11, 10}}) {
      const Eigen::Quaterniond expected = rotation(at.q + q) * turn_by(at.qd + w, 0.3);
      EXPECT_LT(rotation(next + q).angularDistance(expected), 4e-15) << "case " << k;
      const double* x = next + q;
      EXPECT_NEAR(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3], 1, 1e-15);
    }
  }
}

TEST(Coordinates, AddWhatHasItsOwnVelocity) {
  std::mt19937_64 engine(8);
  const Drawn at = draw(engine, 2);
  double next[kPositions];
  integrate(kJoints, at.q, at.qd, 0.25, next);
  for (const auto& [q, v] :
       {std::pair{0, 0}, std::pair{8, 7}, std::pair{9, 8}, std::pair{10, 9}, std::pair{15, 13}}) {
    EXPECT_EQ(next[q], at.q[q] + 0.25 * at.qd[v]) << q;
  }
}

// The exact motion of a constant twist, in many small steps of the derivative.
TEST(Coordinates, MoveAFloatingJointToSecondOrder) {
  std::mt19937_64 engine(9);
  const Drawn at = draw(engine, 1);
  const auto error_of_step = [&](double dt) {
    Eigen::Vector3d p(at.q[1], at.q[2], at.q[3]);
    const Eigen::Vector3d v(at.qd[1], at.qd[2], at.qd[3]);
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      p += (rotation(at.q + 4) * turn_by(at.qd + 4, dt * (i + 0.5) / kSteps)) * v * (dt / kSteps);
    }
    double next[kPositions];
    integrate(kJoints, at.q, at.qd, dt, next);
    return (Eigen::Vector3d(next[1], next[2], next[3]) - p).norm();
  };
  const double long_step = error_of_step(0.2);
  const double short_step = error_of_step(0.1);
  EXPECT_GT(long_step, 1e-6);
  EXPECT_NEAR(long_step / short_step, 8, 0.2);  // dt^3 in one step
}

TEST(Coordinates, DifferenceIsTheInverse) {
  std::mt19937_64 engine(10);
  for (int k = 0; k < 200; ++k) {
    const Drawn from = draw(engine, 2);
    const Drawn to = draw(engine, 2);
    double qd[kVelocities];
    double arrived[kPositions];
    difference(kJoints, from.q, to.q, qd);
    integrate(kJoints, from.q, qd, 1.0, arrived);
    for (int i = 0; i < kPositions; ++i) {
      if ((i >= 4 && i < 8) || (i >= 11 && i < 15)) continue;
      EXPECT_NEAR(arrived[i], to.q[i], 4e-15) << i;
    }
    for (const int q : {4, 11}) {
      EXPECT_LT(rotation(arrived + q).angularDistance(rotation(to.q + q)), 8e-15);
    }
    for (const int w : {4, 10}) {
      EXPECT_LE(std::hypot(qd[w], qd[w + 1], qd[w + 2]), 3.1415926535897940);
    }
  }
}

// Both signs and all lengths of a quaternion are one orientation; 0 is none.
TEST(Coordinates, KnowOnlyTheDirectionOfAQuaternion) {
  const double from[4] = {0, 0, 0, 2};
  const double to[4] = {0, 0, -3e-160 * std::sin(0.25), -3e-160 * std::cos(0.25)};
  const double none[4] = {0, 0, 0, 0};
  constexpr QuaternionJoint ball[] = {{0, false}};
  double w[3];
  difference(ball, from, to, w);
  EXPECT_NEAR(w[2], 0.5, 1e-15);
  difference(ball, none, to, w);
  EXPECT_NEAR(w[2], 0.5, 1e-15);
  difference(ball, from, from, w);
  EXPECT_EQ(w[0], 0);
  EXPECT_EQ(w[2], 0);
}

TEST(Coordinates, WithoutQuaternionsAreSums) {
  const double q[2] = {1, 2};
  const double qd[2] = {-4, 8};
  double next[2];
  double back[2];
  integrate(q, qd, 0.5, next);
  EXPECT_EQ(next[0], -1);
  EXPECT_EQ(next[1], 6);
  difference(q, next, back);
  EXPECT_EQ(back[0], -2);
  EXPECT_EQ(back[1], 4);
}

}  // namespace
