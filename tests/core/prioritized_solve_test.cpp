// Strict priority for random Jacobians in the metric of a random inertia, with conflicting rows.
// Would catch: a lower row that affects a higher one, a row that is relaxed without need, a force
// that grows without bound near a conflict, and a jump at the border.
#include "core/prioritized_solve.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace {

using namespace treeline::core;  // NOLINT: the whole header is under test

constexpr int kRows = 6;
constexpr double kTolerance = 1e-4;
using Matrix = Eigen::Matrix<double, kRows, kRows, Eigen::RowMajor>;
using Vector = Eigen::Matrix<double, kRows, 1>;
using Jacobian = Eigen::Matrix<double, kRows, 9, Eigen::RowMajor>;

Jacobian random_rows(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Jacobian::NullaryExpr([&] { return normal(random); });
}

Vector random_command(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Vector::NullaryExpr([&] { return 10 * normal(random); });
}

/// Joint accelerations M^-1 J^T F, with the metric inside J: J J^T stands for J M^-1 J^T.
Vector achieved(const Jacobian& J, const Vector& b) {
  double A[kRows * kRows];
  double x[kRows];
  Matrix::Map(A) = J * J.transpose();
  Vector::Map(x) = b;
  prioritized_solve<kRows>(A, kTolerance, x);
  return J * (J.transpose() * Vector::Map(x));
}

TEST(PrioritizedSolve, AchievesEveryRowWithoutConflict) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 200; ++round) {
    const Jacobian J = random_rows(random);
    const Vector b = random_command(random);
    const Matrix A = J * J.transpose();
    const double condition = A.norm() * A.inverse().norm();
    EXPECT_LE((achieved(J, b) - b).norm(), 1e-15 * 10 * condition * b.norm());
  }
}

// Row 4 repeats rows 0 and 2 with another command: only this row is relaxed.
TEST(PrioritizedSolve, OnlyTheConflictingRowYields) {
  std::mt19937_64 random(2);
  for (int round = 0; round < 200; ++round) {
    Jacobian J = random_rows(random);
    J.row(4) = 0.7 * J.row(0) - 2.0 * J.row(2);
    const Vector b = random_command(random);
    const Vector a = achieved(J, b);
    for (const int row : {0, 1, 2, 3, 5}) {
      EXPECT_NEAR(a[row], b[row], 1e-9) << "row " << row << " round " << round;
    }
    // What the rows above leave of it.
    EXPECT_NEAR(a[4], 0.7 * b[0] - 2.0 * b[2], 1e-9);
  }
}

// The claim itself: whatever the degree of conflict of the lower rows, the higher rows are not
// affected.
TEST(PrioritizedSolve, HigherRowsAreUnaffectedByLowerOnes) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int round = 0; round < 500; ++round) {
    Jacobian J = random_rows(random);
    const double distance = std::pow(10.0, -8.0 * (round % 50) / 50.0);
    const Jacobian away = random_rows(random);
    J.row(3) = J.row(0) + distance * away.row(3);
    J.row(5) = J.row(1) - J.row(2) + distance * away.row(5);
    Vector b = random_command(random);
    const Vector a = achieved(J, b);
    for (int row = 0; row < 3; ++row) {
      EXPECT_NEAR(a[row], b[row], 1e-9 * (1 + b.norm())) << "distance " << distance;
    }
    b.tail<3>() = random_command(random).tail<3>() * 1e3;
    const Vector other = achieved(J, b);
    for (int row = 0; row < 3; ++row) {
      EXPECT_NEAR(other[row], a[row], 1e-7) << "distance " << distance;
    }
  }
}

// Through a conflict in small steps: the torque is bounded by 1 / sqrt(tolerance), and its steps
// are as small as the path's.
TEST(PrioritizedSolve, IsBoundedAndSmoothThroughAConflict) {
  std::mt19937_64 random(4);
  Jacobian J = random_rows(random);
  const Jacobian away = random_rows(random);
  const Vector b = random_command(random);
  Eigen::Matrix<double, 9, 1> before = Eigen::Matrix<double, 9, 1>::Zero();
  double largest = 0.0;
  double largest_step = 0.0;
  const int steps = 20000;
  for (int step = 0; step <= steps; ++step) {
    const double distance = 0.1 * (2.0 * step / steps - 1.0);
    J.row(5) = J.row(0) + J.row(1) + distance * away.row(5);
    double A[kRows * kRows];
    double x[kRows];
    Matrix::Map(A) = J * J.transpose();
    Vector::Map(x) = b;
    prioritized_solve<kRows>(A, kTolerance, x);
    const Eigen::Matrix<double, 9, 1> torque = J.transpose() * Vector::Map(x);
    ASSERT_TRUE(torque.allFinite());
    largest = std::max(largest, torque.norm());
    if (step > 0) {
      largest_step = std::max(largest_step, (torque - before).norm());
    }
    before = torque;
  }
  EXPECT_LE(largest, 10.0 * b.norm() / std::sqrt(kTolerance));
  // A step of 1e-5 in 1e-2, the width of the region, changes the torque by this share of its bound.
  EXPECT_LE(largest_step, 1e-2 * largest);
}

TEST(PrioritizedSolve, ZeroRowsAndAnEmptyMatrixGiveNoForce) {
  double A[4] = {0, 0, 0, 2};
  double x[2] = {5, 6};
  prioritized_solve<2>(A, 1e-4, x);
  EXPECT_EQ(x[0], 0.0);
  EXPECT_EQ(x[1], 3.0);
  double none[4] = {};
  double y[2] = {1, 1};
  prioritized_solve<2>(none, 1e-4, y);
  EXPECT_EQ(y[0], 0.0);
  EXPECT_EQ(y[1], 0.0);
}

TEST(SharedFactor, LeavesRowsOutByTheirShare) {
  const double A[4] = {4, 2, 2, 3};
  // Pivots 4 and 2; between them (A + diag(0, 2 (1 - w) / w)) F = b.
  const double shares[2] = {1.0, 0.25};
  double x[2] = {10, 9};
  selective_solve(shared_factor<2>(A, shares), x);
  EXPECT_NEAR(4 * x[0] + 2 * x[1], 10.0, 1e-14);
  EXPECT_NEAR(2 * x[0] + (3 + 2 * 3.0) * x[1], 9.0, 1e-14);
  const double none[2] = {1.0, 0.0};
  double y[2] = {10, 9};
  selective_solve(shared_factor<2>(A, none), y);
  EXPECT_EQ(y[0], 2.5);
  EXPECT_EQ(y[1], 0.0);
}

}  // namespace
