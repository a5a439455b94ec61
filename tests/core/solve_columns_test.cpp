// The solve for all columns of matrices, by the header that is emitted, beside Eigen's solve by
// pivoting. Would catch rows that are subtracted in the wrong order or not at all, factors of other
// rows, columns that mix, and numbers of the padding that reach results.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>
#include <vector>

#include "core/emitted_endings.hpp"

namespace treeline {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A random tree: joint i is carried by `parents[i]`, -1: by none.
std::vector<int> random_parents(int n, std::mt19937_64& random) {
  std::vector<int> parents(static_cast<std::size_t>(n), -1);
  for (int i = 1; i < n; ++i) {
    parents[static_cast<std::size_t>(i)] = std::uniform_int_distribution<int>(-1, i - 1)(random);
  }
  return parents;
}

bool carries(const std::vector<int>& parents, int i, int k) {
  while (k > i) k = parents[static_cast<std::size_t>(k)];
  return k == i;
}

/// L of M = L^T D L with entries where joints carry each other, and its tables.
struct Factors {
  Matrix L;
  Eigen::VectorXd D;
  std::vector<double> entries, inverse_D;
  std::vector<std::int16_t> above_ends, above, below_ends, below;
};

Factors random_factors(const std::vector<int>& parents, std::mt19937_64& random) {
  const int n = static_cast<int>(parents.size());
  std::uniform_real_distribution<double> number(-1, 1);
  Factors factors;
  factors.L = Matrix::Identity(n, n);
  factors.D.resize(n);
  Eigen::MatrixXi places(n, n);
  for (int k = 0; k < n; ++k) {
    factors.D(k) = 1.5 + number(random);
    factors.inverse_D.push_back(1 / factors.D(k));
    for (int i = 0; i < k; ++i) {
      if (!carries(parents, i, k)) continue;
      factors.L(k, i) = number(random) / 2;
      places(k, i) = static_cast<int>(factors.entries.size());
      factors.entries.push_back(factors.L(k, i));
      factors.below.push_back(static_cast<std::int16_t>(i));
      factors.below.push_back(static_cast<std::int16_t>(places(k, i)));
    }
    factors.below_ends.push_back(static_cast<std::int16_t>(factors.below.size() / 2));
  }
  for (int i = 0; i < n; ++i) {
    for (int k = n - 1; k > i; --k) {
      if (!carries(parents, i, k)) continue;
      factors.above.push_back(static_cast<std::int16_t>(k));
      factors.above.push_back(static_cast<std::int16_t>(places(k, i)));
    }
    factors.above_ends.push_back(static_cast<std::int16_t>(factors.above.size() / 2));
  }
  return factors;
}

double largest_error(const Matrix& found, const Matrix& expected) {
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

// Sizes around those at which rows fill their stride and sums are of four rows.
class SolveColumns : public testing::TestWithParam<int> {};

TEST_P(SolveColumns, AgreesWithPivoting) {
  const int n = GetParam();
  const auto seed = static_cast<std::uint64_t>(4100 + n);
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  const Factors factors = random_factors(random_parents(n, random), random);
  const Matrix M = factors.L.transpose() * factors.D.asDiagonal() * factors.L;
  Matrix A = Matrix::Random(n, n);
  Matrix B = Matrix::Random(n, n);
  const Eigen::FullPivLU<Matrix> lu(M);
  const Matrix of_A = lu.solve(A);
  const Matrix of_B = lu.solve(B);
  const Matrix of_one = lu.inverse();
  using Solve = core::EmittedEndings<double>;
  Solve solve(n, false);
  std::vector<double> work(static_cast<std::size_t>(n * core::column_stride(n)), 1e300);
  Matrix inverse(n, n);
  solve.tl_solve_columns(factors.above_ends.data(), factors.above.data(), factors.below_ends.data(),
                         factors.below.data(), factors.entries.data(), factors.inverse_D.data(),
                         work.data(), A.data(), B.data(), inverse.data());
  // Errors of both solves: a rounding per operation of a row, times what L^-1 and L^-T enlarge.
  const Matrix growth = factors.L.inverse().cwiseAbs();
  const double bound = 2 * n * 0x1p-52 * growth.sum() * growth.sum();
  ASSERT_LT(bound, 1e-9);
  EXPECT_LT(largest_error(A, of_A), bound);
  EXPECT_LT(largest_error(B, of_B), bound);
  EXPECT_LT(largest_error(inverse, of_one), bound);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SolveColumns, testing::Values(1, 2, 3, 5, 8, 11, 16, 24, 35, 63));

}  // namespace
}  // namespace treeline
