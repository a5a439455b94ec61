// Selective damping compared with closed forms and with its own stated bounds. Would catch: a
// change although nothing is heavy, a force proportional to the inverse eigenvalue, a step where
// eigenvalues cross the border or each other, a NaN at rank zero, a dependence on units, and
// rounding that destroys positive definiteness.
#include "core/damped_solve.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "core/ldlt.hpp"

namespace {

using namespace treeline::core;  // NOLINT: the whole header is under test

template <int N>
using Square = Eigen::Matrix<double, N, N, Eigen::RowMajor>;
template <int N>
using Column = Eigen::Matrix<double, N, 1>;

template <int N>
double solve(const Square<N>& A, const Column<N>& mass_limits, Column<N>& x) {
  double entries[N * N];
  double limits[N];
  double b[N];
  Square<N>::Map(entries) = A;
  Column<N>::Map(limits) = mass_limits;
  Column<N>::Map(b) = x;
  const double least_eigenvalue = damped_solve(entries, limits, b);
  x = Column<N>::Map(b);
  return least_eigenvalue;
}

/// S^-1 V diag(eigenvalues) V^T S^-1 with a random V.
Square<6> matrix_of(const Column<6>& eigenvalues, const Column<6>& mass_limits,
                    std::mt19937& engine) {
  std::normal_distribution<double> normal;
  const Square<6> random = Square<6>::NullaryExpr([&] { return normal(engine); });
  const Square<6> V = random.householderQr().householderQ();
  const Column<6> inverse_roots = mass_limits.cwiseSqrt().cwiseInverse();
  const Square<6> B = V * eigenvalues.asDiagonal() * V.transpose();
  return inverse_roots.asDiagonal() * (0.5 * (B + B.transpose())) * inverse_roots.asDiagonal();
}

Column<6> random_column(std::mt19937& engine) {
  std::normal_distribution<double> normal;
  return Column<6>::NullaryExpr([&] { return normal(engine); });
}

const Column<6> kMassLimits = (Column<6>() << 100, 100, 100, 5, 5, 5).finished();

TEST(DampedSolve, WhereNothingIsHeavyTheBitsAreThoseOfLdlt) {
  std::mt19937 engine(1);
  for (int i = 0; i < 100; ++i) {
    Column<6> eigenvalues;
    for (int k = 0; k < 6; ++k) eigenvalues(k) = std::pow(10.0, 0.001 + k * 0.8);
    const Square<6> A = matrix_of(eigenvalues, kMassLimits, engine);
    const Column<6> b = random_column(engine);
    Column<6> x = b;
    EXPECT_GT(solve<6>(A, kMassLimits, x), 1.0);
    double factors[36];
    double exact[6];
    Square<6>::Map(factors) = A;
    Column<6>::Map(exact) = b;
    ASSERT_TRUE(ldlt_factor<6>(factors));
    ldlt_solve(factors, exact);
    EXPECT_EQ(x, Column<6>::Map(exact));
  }
}

// The stated bounds, for eigenvalues from 0 to 1e6, several of them equal or zero.
TEST(DampedSolve, ForceAndEnergyStayWithinTheirBounds) {
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> exponent(-20, 6);
  double largest_force = 0;
  double largest_energy = 0;
  for (int i = 0; i < 3000; ++i) {
    Column<6> eigenvalues;
    for (int k = 0; k < 6; ++k) {
      eigenvalues(k) = i % 3 == 0   ? (k < 3 ? 0.0 : 0.6)
                       : i % 3 == 1 ? std::pow(10.0, exponent(engine))
                                    : 0.2 + 0.001 * (i % 1000);
    }
    const Square<6> A = matrix_of(eigenvalues, kMassLimits, engine);
    const Column<6> b = random_column(engine);
    Column<6> F = b;
    const double least_eigenvalue = solve<6>(A, kMassLimits, F);
    ASSERT_TRUE(F.allFinite());
    EXPECT_NEAR(least_eigenvalue, eigenvalues.minCoeff(), 1e-14 * eigenvalues.maxCoeff());
    const double scale = kMassLimits.cwiseSqrt().cwiseProduct(b).norm();
    largest_force =
        std::max(largest_force, F.cwiseQuotient(kMassLimits.cwiseSqrt()).norm() / scale);
    largest_energy = std::max(largest_energy, F.dot(A * F) / (scale * scale));
  }
  EXPECT_LE(largest_force, kLargestDampedForce * (1 + 1e-9));
  EXPECT_LE(largest_energy, kLargestDampedEnergy * (1 + 1e-9));
  EXPECT_GT(largest_force, 0.95 * kLargestDampedForce);  // tight
  EXPECT_GT(largest_energy, 0.95 * kLargestDampedEnergy);
}

// Only heavy directions deviate: v_k^T S (b - A F) = 0 up to rounding for eigenvalues above 1.
TEST(DampedSolve, WhatIsNotHeavyIsExact) {
  std::mt19937 engine(3);
  const Column<6> eigenvalues = (Column<6>() << 1e4, 300, 20, 1.01, 0.3, 1e-13).finished();
  for (int i = 0; i < 100; ++i) {
    const Square<6> A = matrix_of(eigenvalues, kMassLimits, engine);
    const Column<6> b = random_column(engine);
    Column<6> F = b;
    solve<6>(A, kMassLimits, F);
    const Column<6> roots = kMassLimits.cwiseSqrt();
    const Square<6> B = roots.asDiagonal() * A * roots.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Square<6>> eigen(B);
    const Column<6> missed =
        eigen.eigenvectors().transpose() * roots.cwiseProduct(b - A * F).eval();
    const Column<6> wanted = eigen.eigenvectors().transpose() * roots.cwiseProduct(b);
    for (int k = 0; k < 6; ++k) {  // ascending
      const double s = eigen.eigenvalues()(k);
      const double delta = s < 1 ? std::pow(1 - s, 3) : 0;
      // 1e4 is the norm of the matrix, and the residual's rounding is this many ulp.
      EXPECT_NEAR(missed(k), wanted(k) * delta / (s + delta), 1e-15 * 1e4 * 30 * wanted.norm());
    }
  }
}

// Torque along a path through a singularity of a planar arm, sampled ever more densely: differences
// shrink in proportion to the step, second differences with its square.
TEST(DampedSolve, HasNoStepOnTheWayThroughRankTwo) {
  const auto forces = [](double t) {
    // Two eigenvalues cross each other, the border and zero, while their directions rotate.
    const double c = std::cos(3 * t);
    const double s = std::sin(3 * t);
    const double a = 2 * t * t;
    const double b = (t - 0.4) * (t - 0.4);
    Square<3> V;
    V << c, -s, 0, s, c, 0, 0, 0, 1;
    Column<3> values;
    values << a, b, 4;
    const Square<3> A = V * values.asDiagonal() * V.transpose();
    Column<3> x;
    x << 1, -2, 0.5;
    const Column<3> ones = Column<3>::Ones();
    solve<3>(0.5 * (A + A.transpose()), ones, x);
    return x;
  };
  const auto largest = [&forces](int steps, int order) {
    double most = 0;
    const double h = 2.4 / steps;
    for (int i = 1; i < steps; ++i) {
      const double t = -1.2 + i * h;
      Column<3> change = forces(t + h) - forces(t);
      if (order == 2) change -= forces(t) - forces(t - h);
      most = std::max(most, change.norm() / std::pow(h, order));
    }
    return most;
  };
  EXPECT_LT(largest(16000, 1), 1.1 * largest(1000, 1));
  EXPECT_LT(largest(16000, 2), 1.1 * largest(1000, 2));
}

TEST(DampedSolve, HasNoNumberThatIsNone) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double size : {0.0, tiny, 1e-300, 1e-16, 1.0, 1e10, 1e15, 1e30, 1e100}) {
    const Column<2> direction(std::cos(0.3), std::sin(0.3));
    const Square<2> A = size * direction * direction.transpose();
    Column<2> x(1, 1);
    solve<2>(A, Column<2>(100, 5), x);
    EXPECT_TRUE(x.allFinite()) << size;
  }
}

// Other units of kg and m scale all results by their own factor. Powers of two are exact.
TEST(DampedSolve, DoesNotDependOnUnits) {
  std::mt19937 engine(5);
  const Column<6> eigenvalues = (Column<6>() << 50, 9, 2, 0.5, 0.1, 0).finished();
  const Square<6> A = matrix_of(eigenvalues, kMassLimits, engine);
  const Column<6> b = random_column(engine);
  Column<6> F = b;
  solve<6>(A, kMassLimits, F);
  const Column<6> unit = (Column<6>() << 16, 16, 16, 1, 1, 1).finished();  // of length
  const double mass = 64;
  Column<6> scaled = b.cwiseProduct(unit);
  solve<6>(unit.asDiagonal() * A * unit.asDiagonal() / mass,
           mass * kMassLimits.cwiseQuotient(unit.cwiseProduct(unit)), scaled);
  EXPECT_LT((scaled.cwiseProduct(unit) / mass - F).norm(), 1e-12 * F.norm());
}

TEST(DampedSolve, ServesFloat) {
  const float A[4] = {2.0F, 2.0F, 2.0F, 2.0F};
  const float mass_limits[2] = {10.0F, 10.0F};
  float x[2] = {1.0F, -1.0F};
  damped_solve(A, mass_limits, x);
  EXPECT_NEAR(x[0], 10.0F, 1e-4F);  // eigenvalue 0 along (1, -1): F = mass_limits b
  EXPECT_NEAR(x[1], -10.0F, 1e-4F);
}

// Float gives the result of double up to the digits that the condition number leaves.
TEST(DampedSolve, InFloatIsThatOfDouble) {
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> exponent(-6, 2);
  for (int i = 0; i < 300; ++i) {
    Column<6> eigenvalues;
    for (int k = 0; k < 6; ++k)
      eigenvalues(k) = i % 5 == 0 && k < 2 ? 0 : std::pow(10, exponent(engine));
    const Square<6> A = matrix_of(eigenvalues, kMassLimits, engine);
    const Column<6> b = random_column(engine);
    float entries[36];
    float mass_limits[6];
    float x[6];
    Eigen::Matrix<float, 6, 6, Eigen::RowMajor>::Map(entries) = A.cast<float>();
    Eigen::Matrix<float, 6, 1>::Map(mass_limits) = kMassLimits.cast<float>();
    Eigen::Matrix<float, 6, 1>::Map(x) = b.cast<float>();
    const float least_eigenvalue = damped_solve(entries, mass_limits, x);
    Column<6> exact = b;
    const double exact_least = solve<6>(A, kMassLimits, exact);
    const double largest = std::max(1.0, eigenvalues.maxCoeff());
    EXPECT_NEAR(static_cast<double>(least_eigenvalue), exact_least, 1e-6 * largest);
    // S^-1 F, for which no direction has an eigenvalue below 0.615, so only errors of A by some
    // roundings of the largest eigenvalue matter.
    const Column<6> roots = kMassLimits.cwiseSqrt();
    const Column<6> error = Eigen::Matrix<float, 6, 1>::Map(x).cast<double>() - exact;
    EXPECT_LE(error.cwiseQuotient(roots).norm(), 1e-5 * largest * b.cwiseProduct(roots).norm());
  }
}

}  // namespace
