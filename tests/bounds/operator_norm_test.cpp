#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/SVD>
#include <cmath>
#include <utility>

#include "bounds/norm_memo.hpp"
#include "random_mechanism.hpp"

// Norms of matrices that depend on an angle, compared with singular values at many more angles than
// are sampled. Would catch: a bound that is too small, one that is needlessly large, and entries of
// very different sizes, for which eigenvalue solvers have failed.

namespace treeline::bounds {
namespace {

constexpr double kTurn = 6.283185307179586;

Eigen::MatrixXd value_at(const TrigMatrix& A, const std::vector<double>& scale, double angle) {
  Eigen::MatrixXd value = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(A.rows),
                                                static_cast<Eigen::Index>(A.columns));
  for (const MatrixEntry& entry : A.entries) {
    value(static_cast<Eigen::Index>(entry.row), static_cast<Eigen::Index>(entry.column)) +=
        entry.value.at(std::cos(angle), std::sin(angle)) / scale[entry.column];
  }
  return value;
}

double largest_singular_value(const TrigMatrix& A, const std::vector<double>& scale) {
  constexpr int kSamples = 400;
  double largest = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(value_at(A, scale, kTurn * i / kSamples));
    largest = std::max(largest, svd.singularValues()(0));
  }
  return largest;
}

TrigMatrix draw_matrix(tests::Rng& rng, bool graded) {
  TrigMatrix A{
      static_cast<std::size_t>(1 + rng.below(9)), static_cast<std::size_t>(1 + rng.below(9)), {}};
  for (std::size_t row = 0; row < A.rows; ++row) {
    for (std::size_t column = 0; column < A.columns; ++column) {
      if (rng.chance(0.4)) continue;
      MatrixEntry entry{row, column, {}};
      entry.value.angle = 1;
      const double size = graded ? std::pow(10, -rng.below(14)) : 1;
      for (double& c : entry.value.c) c = rng.chance(0.5) ? 0 : size * rng.uniform(-1, 1);
      A.entries.push_back(entry);
    }
  }
  return A;
}

TEST(OperatorNorm, IsJustAboveAllSingularValues) {
  constexpr std::uint64_t kSeed = 5;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  tests::Rng rng(kSeed);
  for (int i = 0; i < 300; ++i) {
    const TrigMatrix A = draw_matrix(rng, i % 2 == 1);
    std::vector<double> scale = column_norms(A);
    for (double& s : scale) s = s > 0 ? s : 1;
    const double expected = largest_singular_value(A, scale);
    const double bound = operator_norm(A, scale);
    EXPECT_GE(bound, expected * (1 - 1e-13)) << i;
    EXPECT_LE(bound, expected * 1.03) << i;  // 1 / cos(pi / 16), and samples beside the maximum
  }
}

// Would catch: a norm that is not a number, so that there is no bound, if terms cancel.
TEST(OperatorNorm, ColumnsOfZerosAddNothing) {
  TrigMatrix A{2, 1, {{0, 0, constant(3)}, {1, 0, constant(4)}}};
  const double alone = operator_norm(A, column_norms(A));
  A.columns = 2;
  A.entries.push_back({0, 1, constant(0)});
  EXPECT_EQ(operator_norm(A, column_norms(A)), alone);
}

// Would catch: norms remembered from another matrix with the same numbers in other places.
TEST(NormMemo, GivesWhatIsComputed) {
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  tests::Rng rng(kSeed);
  NormMemo memo;
  for (int i = 0; i < 100; ++i) {
    TrigMatrix A = draw_matrix(rng, false);
    for (int turn = 0; turn < 2; ++turn) {
      const auto& [columns, scaled] = memo.of(A);
      EXPECT_EQ(columns, column_norms(A)) << i;
      EXPECT_EQ(scaled, operator_norm(A, column_norms(A))) << i;
      std::swap(A.rows, A.columns);
      for (MatrixEntry& entry : A.entries) std::swap(entry.row, entry.column);
    }
  }
}

}  // namespace
}  // namespace treeline::bounds
