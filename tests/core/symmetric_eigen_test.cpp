// Eigenvalues and eigenvectors compared with Eigen's tridiagonal QR, for random matrices, repeated
// and zero values, and lost ranks. Would catch: a wrong rotation, too few sweeps, a division by a
// vanishing entry, and vectors that are not orthonormal.
#include "core/symmetric_eigen.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

// Matrices of run-time size, because products of fixed size took a minute to compile.
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Compares eigenvalues and eigenvectors of `A` up to a multiple of `epsilon`, the distance from 1
/// to the next number.
void expect_decomposition(const Square& A, const std::vector<double>& entries_of_values,
                          const std::vector<double>& entries_of_vectors, double epsilon) {
  const Eigen::Index N = A.rows();
  const Square V = Square::Map(entries_of_vectors.data(), N, N);
  const Eigen::VectorXd values = Eigen::VectorXd::Map(entries_of_values.data(), N);
  // The rotations of N sweeps round a few times each; N^2 roundings are more than enough.
  const double tolerance = 5 * epsilon * static_cast<double>(N * N);
  const double size = A.norm();
  EXPECT_LE((V * V.transpose() - Square::Identity(N, N)).norm(), tolerance);
  EXPECT_LE((V.transpose() * values.asDiagonal() * V - A).norm(), tolerance * size);
  const Eigen::SelfAdjointEigenSolver<Square> expected(A);
  EXPECT_LE((values - expected.eigenvalues().reverse()).norm(), tolerance * size);
}

/// Checks the decomposition in `Real`, of the matrix rounded to `Real`.
template <int N, class Real>
void expect_decomposes_in(const Square& A) {
  Real packed[N * N];
  std::transform(A.data(), A.data() + N * N, packed, [](double x) { return static_cast<Real>(x); });
  Square rounded(N, N);
  std::copy(packed, packed + N * N, rounded.data());
  const auto eigen = treeline::core::symmetric_eigen<N>(packed);
  expect_decomposition(rounded, {eigen.values, eigen.values + N},
                       {eigen.vectors, eigen.vectors + N * N},
                       static_cast<double>(std::numeric_limits<Real>::epsilon()));
}

template <int N>
void expect_decomposes(const Square& A) {
  expect_decomposes_in<N, double>(A);
  expect_decomposes_in<N, float>(A);  // in fewer sweeps
}

/// Three diagonals that come apart: repeated entries, couplings down to far below a rounding.
/// Sweeps whose shift serves one block only, or that lose it at a gap, do not end on these.
template <int N>
void expect_decomposes_blocks(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform;
  for (int round = 0; round < 300; ++round) {
    Square A = Square::Zero(N, N);
    for (int i = 0; i < N; ++i) {
      A(i, i) = std::round(4 * uniform(random) - 2);
      if (i == 0) continue;
      const double size = round % 2 == 0 ? 17 * (uniform(random) < 0.3) : 8;
      A(i, i - 1) = A(i - 1, i) = std::pow(10, -size * uniform(random));
    }
    expect_decomposes<N>(A);
  }
}

template <int N>
void expect_decomposes_all(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  const Square one = Square::Identity(N, N);
  for (int round = 0; round < 40; ++round) {
    const Square X = Square::NullaryExpr(N, N, draw);
    expect_decomposes<N>(X + X.transpose());
    const Eigen::VectorXd scale =
        Eigen::VectorXd::NullaryExpr(N, [&] { return std::exp2(4 * draw()); });
    expect_decomposes<N>(scale.asDiagonal() * (X * X.transpose()) * scale.asDiagonal());
    const Eigen::VectorXd x = X.col(0);
    expect_decomposes<N>(x * x.transpose());
    expect_decomposes<N>(one + x * x.transpose());
  }
  expect_decomposes<N>(Square::Zero(N, N));
  expect_decomposes<N>(one);
  expect_decomposes<N>(Square::Ones(N, N));
}

TEST(SymmetricEigen, DecomposesLikeEigen) {
  std::mt19937_64 random(11);
  expect_decomposes_all<1>(random);
  expect_decomposes_all<2>(random);
  expect_decomposes_all<3>(random);
  expect_decomposes_all<4>(random);
  expect_decomposes_all<6>(random);
  expect_decomposes_all<12>(random);
  expect_decomposes_all<24>(random);
}

TEST(SymmetricEigen, DecomposesWhatComesApart) {
  std::mt19937_64 random(12);
  expect_decomposes_blocks<3>(random);
  expect_decomposes_blocks<4>(random);
  expect_decomposes_blocks<6>(random);
  expect_decomposes_blocks<12>(random);
  expect_decomposes_blocks<24>(random);
}

}  // namespace
