// The solve for all columns of matrices, by the header that is emitted, beside Eigen's solve by
// pivoting. Would catch rows that are subtracted in the wrong order or not at all, factors of other
// rows, columns that mix, numbers of the padding that reach results, and branches that are taken
// for others.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <random>
#include <tuple>
#include <variant>
#include <vector>

#include "core/emitted_endings.hpp"
#include "recursion/routes/tree_paths.hpp"

namespace treeline {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A random tree, numbered depth first: joint i is carried by `parents[i]`, -1: by none. A tree
/// that is not has another numbering.
std::vector<int> random_parents(int n, bool depth_first, std::mt19937_64& random) {
  std::vector<int> parents;
  for (int i = 0; i < n; ++i) {
    int parent = i - 1;
    if (!depth_first) parent = std::uniform_int_distribution<int>(-1, i - 1)(random);
    while (depth_first && parent >= 0 && random() % 4 == 0) {
      parent = parents[static_cast<std::size_t>(parent)];
    }
    parents.push_back(parent);
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
  int row_length = 0;
  std::vector<double> rows, inverse_D;
  std::vector<Table> tables;

  [[nodiscard]] const std::int16_t* table(std::size_t at) const {
    return std::get<std::vector<std::int16_t>>(tables[at].values).data();
  }
};

Factors random_factors(const std::vector<int>& parents, std::mt19937_64& random) {
  const int n = static_cast<int>(parents.size());
  std::uniform_real_distribution<double> number(-1, 1);
  Factors factors;
  factors.L = Matrix::Identity(n, n);
  factors.D.resize(n);
  const TreePaths paths(n, [&](int k, int i) { return carries(parents, i, k); });
  factors.row_length = paths.row_length();
  for (int k = 0; k < n; ++k) {
    factors.D(k) = 1.5 + number(random);
    factors.inverse_D.push_back(1 / factors.D(k));
    for (int i = 0; i < k; ++i) {
      if (carries(parents, i, k)) factors.L(k, i) = number(random) / 8;
    }
    for (const int i : paths.path_of(k)) factors.rows.push_back(factors.L(k, i));
    factors.rows.resize(static_cast<std::size_t>((k + 1) * factors.row_length), 1e300);
  }
  const auto related = [&](int i, int j) {
    return carries(parents, std::min(i, j), std::max(i, j));
  };
  paths.append_to(factors.tables, related);
  return factors;
}

/// A random matrix with entries where joints carry each other.
Matrix random_entries(const std::vector<int>& parents) {
  const int n = static_cast<int>(parents.size());
  Matrix entries = Matrix::Random(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (!carries(parents, std::min(i, j), std::max(i, j))) entries(i, j) = 0;
    }
  }
  return entries;
}

/// The columns of two matrices in strips of eight of each, with large numbers elsewhere.
std::vector<double> list_strips(const Matrix& A, const Matrix& B) {
  const Eigen::Index n = A.rows();
  std::vector<double> strips(static_cast<std::size_t>(24 * n * ((n + 7) / 8)), 1e300);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto at = static_cast<std::size_t>((j / 8 * n + i) * 24 + j % 8);
      strips[at] = A(i, j);
      strips[at + 8] = B(i, j);
    }
  }
  return strips;
}

double largest_error(const Matrix& found, const Matrix& expected) {
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

// Sizes around those at which columns fill their strips.
class SolveColumns : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(SolveColumns, AgreesWithPivoting) {
  const auto [n, depth_first] = GetParam();
  const auto seed = static_cast<std::uint64_t>(4100 + n);
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  const std::vector<int> parents = random_parents(n, depth_first, random);
  const Factors factors = random_factors(parents, random);
  const Matrix M = factors.L.transpose() * factors.D.asDiagonal() * factors.L;
  Matrix A = random_entries(parents);
  Matrix B = random_entries(parents);
  const Eigen::FullPivLU<Matrix> lu(M);
  const Matrix of_A = lu.solve(A);
  const Matrix of_B = lu.solve(B);
  const Matrix of_one = lu.inverse();
  using Solve = core::EmittedEndings<double>;
  Solve solve(n, factors.row_length, false);
  std::vector<double> strips = list_strips(A, B);
  std::vector<double> path(static_cast<std::size_t>(24 * factors.row_length));
  Matrix inverse(n, n);
  solve.tl_solve_columns(factors.table(0), factors.table(1), factors.table(2), factors.table(3),
                         factors.rows.data(), factors.inverse_D.data(), strips.data(), path.data(),
                         A.data(), B.data(), inverse.data());
  // Errors of both solves: a rounding per operation of a row, times what L^-1 and L^-T enlarge.
  const Matrix growth = factors.L.inverse().cwiseAbs();
  const double bound = 2 * n * 0x1p-52 * growth.sum() * growth.sum();
  ASSERT_LT(bound, 1e-9);
  EXPECT_LT(largest_error(A, of_A), bound);
  EXPECT_LT(largest_error(B, of_B), bound);
  EXPECT_LT(largest_error(inverse, of_one), bound);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SolveColumns,
                         testing::Combine(testing::Values(1, 2, 3, 5, 8, 11, 16, 24, 35, 63),
                                          testing::Bool()));

}  // namespace
}  // namespace treeline
