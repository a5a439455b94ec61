// Factor and solve compared with Eigen's independent LLT for random positive definite matrices of
// very different scales. Would catch: a wrong index, a use of the upper triangle, and a pivot test
// that accepts an indefinite or NaN matrix.
#include "core/ldlt.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

using treeline::core::ldlt_factor;
using treeline::core::ldlt_solve;

// Matrices of run-time size, because products of fixed size took long to compile.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

struct System {
  Matrix A;
  Vector b;
};

System draw_system(std::mt19937_64& random, int rows) {
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  const Matrix factor = Matrix::NullaryExpr(rows, rows, draw);
  const Vector scale = Vector::NullaryExpr(rows, [&] { return std::exp2(draw()); });
  const Matrix plain = factor * factor.transpose() + 0.1 * Matrix::Identity(rows, rows);
  return {scale.asDiagonal() * plain * scale.asDiagonal(), Vector::NullaryExpr(rows, draw)};
}

void expect_solution(const System& system, const std::vector<double>& x) {
  const auto rows = static_cast<Eigen::Index>(x.size());
  const Vector expected = system.A.llt().solve(system.b);
  const Vector singular = system.A.jacobiSvd().singularValues();
  // Backward stable solves differ by the condition number times a few roundings per row.
  const double condition = singular[0] / singular[rows - 1];
  const double tolerance = 1e-15 * static_cast<double>(rows) * condition * expected.norm();
  EXPECT_LE((Vector::Map(x.data(), rows) - expected).norm(), tolerance) << "rows " << rows;
}

template <int N>
void expect_solves(std::mt19937_64& random) {
  for (int round = 0; round < 50; ++round) {
    const System system = draw_system(random, N);
    double packed[N * N];
    double x[N];
    for (int i = 0; i < N; ++i) {
      x[i] = system.b(i);
      for (int j = 0; j < N; ++j) {
        // The upper triangle must not matter.
        packed[N * i + j] = j > i ? std::numeric_limits<double>::quiet_NaN() : system.A(i, j);
      }
    }
    ASSERT_TRUE(ldlt_factor<N>(packed));
    ldlt_solve(packed, x);
    SCOPED_TRACE(round);
    expect_solution(system, {x, x + N});
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
