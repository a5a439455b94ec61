// Factor and solve against Eigen's independent LLT, over random positive definite matrices of
// widely differing scales. Would catch a wrong index, a use of the upper triangle, a pivot test
// that lets an indefinite or NaN matrix through.
#include "core/ldlt.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>

namespace {

using treeline::core::ldlt_factor;
using treeline::core::ldlt_solve;

template <int N>
void expect_solves(std::mt19937_64& random) {
  using Matrix = Eigen::Matrix<double, N, N, Eigen::RowMajor>;
  using Vector = Eigen::Matrix<double, N, 1>;
  std::normal_distribution<double> normal;
  for (int round = 0; round < 50; ++round) {
    const Matrix factor = Matrix::NullaryExpr([&] { return normal(random); });
    const Vector scale = Vector::NullaryExpr([&] { return std::exp2(normal(random)); });
    const Matrix A = scale.asDiagonal() *
                     (factor * factor.transpose() + 0.1 * Matrix::Identity()).eval() *
                     scale.asDiagonal();
    const Vector b = Vector::NullaryExpr([&] { return normal(random); });
    double packed[N * N];
    double x[N];
    Matrix::Map(packed) = A;
    // The upper triangle must not matter.
    Matrix::Map(packed).template triangularView<Eigen::StrictlyUpper>().setConstant(
        std::numeric_limits<double>::quiet_NaN());
    Vector::Map(x) = b;
    ASSERT_TRUE(ldlt_factor<N>(packed));
    ldlt_solve(packed, x);
    const Vector expected = A.llt().solve(b);
    const Vector singular = A.jacobiSvd().singularValues();
    // Backward stable solves differ by condition times a few roundings per row.
    const double tolerance = 1e-15 * N * singular[0] / singular[N - 1] * expected.norm();
    EXPECT_LE((Vector::Map(x) - expected).norm(), tolerance) << "N " << N << " round " << round;
  }
}

TEST(Ldlt, SolvesLikeEigen) {
  std::mt19937_64 random(7);
  expect_solves<1>(random);
  expect_solves<2>(random);
  expect_solves<6>(random);
  expect_solves<12>(random);
}

TEST(Ldlt, ClosedForm) {
  // A = [4 2; 2 3] = L D L^T with L21 = 1/2, D = (4, 2); A x = (10, 9) has x = (1.5, 2).
  double A[4] = {4, 0, 2, 3};
  double x[2] = {10, 9};
  ASSERT_TRUE(ldlt_factor<2>(A));
  EXPECT_EQ(A[0], 4);
  EXPECT_EQ(A[2], 0.5);
  EXPECT_EQ(A[3], 2);
  ldlt_solve(A, x);
  EXPECT_EQ(x[0], 1.5);
  EXPECT_EQ(x[1], 2.0);
}

TEST(Ldlt, SaysWhenNotPositiveDefinite) {
  float indefinite[4] = {1, 0, 2, 1};
  EXPECT_FALSE(ldlt_factor<2>(indefinite));
  float singular[4] = {1, 0, 1, 1};
  EXPECT_FALSE(ldlt_factor<2>(singular));
  float not_a_number[4] = {1, 0, std::numeric_limits<float>::quiet_NaN(), 1};
  EXPECT_FALSE(ldlt_factor<2>(not_a_number));
}

}  // namespace
