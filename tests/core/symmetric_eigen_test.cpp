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

}  // namespace
