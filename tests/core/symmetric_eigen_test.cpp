// Eigenvalues and vectors against Eigen's tridiagonal QR, over random matrices, repeated and zero
// values and lost ranks. Would catch a wrong rotation, too few sweeps, a division by a vanishing
// entry, vectors that are not orthonormal.
#include "core/symmetric_eigen.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace {

template <int N>
using Square = Eigen::Matrix<double, N, N, Eigen::RowMajor>;

template <int N>
void expect_decomposes(const Square<N>& A) {
  double packed[N * N];
  Square<N>::Map(packed) = A;
  const auto eigen = treeline::core::symmetric_eigen<N>(packed);
  const Square<N> V = Square<N>::Map(eigen.vectors);
  const Eigen::Matrix<double, N, 1> values = Eigen::Matrix<double, N, 1>::Map(eigen.values);
  // Each of N sweeps' rotations rounds a few times: N^2 roundings bound it amply.
  const double tolerance = 1e-15 * N * N;
  const double size = A.norm();
  EXPECT_LE((V * V.transpose() - Square<N>::Identity()).norm(), tolerance);
  EXPECT_LE((V.transpose() * values.asDiagonal() * V - A).norm(), tolerance * size);
  const Eigen::SelfAdjointEigenSolver<Square<N>> expected(A);
  EXPECT_LE((values - expected.eigenvalues().reverse()).norm(), tolerance * size);
}

template <int N>
void expect_decomposes_all(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (int round = 0; round < 40; ++round) {
    const Square<N> X = Square<N>::NullaryExpr([&] { return normal(random); });
    expect_decomposes<N>(X + X.transpose());
    const Eigen::Matrix<double, N, 1> scale =
        Eigen::Matrix<double, N, 1>::NullaryExpr([&] { return std::exp2(4 * normal(random)); });
    expect_decomposes<N>(scale.asDiagonal() * X * X.transpose() * scale.asDiagonal());
    const Eigen::Matrix<double, N, 1> x = X.col(0);
    expect_decomposes<N>(x * x.transpose());
    expect_decomposes<N>(Square<N>::Identity() + x * x.transpose());
  }
  expect_decomposes<N>(Square<N>::Zero());
  expect_decomposes<N>(Square<N>::Identity());
  expect_decomposes<N>(Square<N>::Ones());
}

TEST(SymmetricEigen, DecomposesLikeEigen) {
  std::mt19937_64 random(11);
  expect_decomposes_all<1>(random);
  expect_decomposes_all<2>(random);
  expect_decomposes_all<3>(random);
  expect_decomposes_all<6>(random);
  expect_decomposes_all<12>(random);
  expect_decomposes_all<24>(random);
}

}  // namespace
