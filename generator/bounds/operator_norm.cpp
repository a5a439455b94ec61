#include "bounds/operator_norm.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace treeline::bounds {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr int kFew = 16, kMany = 64;

Eigen::MatrixXd value_at(const TrigMatrix& A, int sample, int samples) {
  const double angle = kTurn * sample / samples;
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::MatrixXd at = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(A.rows),
                                             static_cast<Eigen::Index>(A.columns));
  for (const MatrixEntry& entry : A.entries) {
    at(static_cast<Eigen::Index>(entry.row), static_cast<Eigen::Index>(entry.column)) +=
        entry.value.at(c, s);
  }
  return at;
}

/// Products of the rows, or of the columns where they are fewer: its largest eigenvalue is the
/// square of the norm.
Eigen::MatrixXd gram(const Eigen::MatrixXd& A) {
  return A.rows() <= A.cols() ? Eigen::MatrixXd(A * A.transpose())
                              : Eigen::MatrixXd(A.transpose() * A);
}

double largest_eigenvalue(const Eigen::MatrixXd& G) {
  const double largest = G.diagonal().maxCoeff();
  const Eigen::MatrixXd off = G - Eigen::MatrixXd(G.diagonal().asDiagonal());
  const double sum = off.cwiseAbs().rowwise().sum().maxCoeff();  // Gershgorin
  if (sum <= 1e-12 * largest) return largest + sum;
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(G, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

}  // namespace

std::vector<double> column_norms(const TrigMatrix& A) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(A.columns));
  for (int i = 0; i < kFew; ++i) {
    squares = squares.cwiseMax(value_at(A, i, kFew).colwise().squaredNorm().transpose());
  }
  const Eigen::VectorXd norms = squares.cwiseSqrt();
  return {norms.data(), norms.data() + norms.size()};
}

double operator_norm(const TrigMatrix& A, const std::vector<double>& scale) {
  const Eigen::VectorXd inverse =
      Eigen::Map<const Eigen::VectorXd>(scale.data(), static_cast<Eigen::Index>(scale.size()))
          .cwiseInverse();
  const auto gram_at = [&](int sample, int samples) {
    return gram(value_at(A, sample, samples) * inverse.asDiagonal());
  };
  const Eigen::MatrixXd first = gram_at(0, kFew);
  bool same = true;
  for (int i = 1; same && i < kFew; ++i) {
    same = (gram_at(i, kFew) - first).cwiseAbs().maxCoeff() <= 1e-12 * first.cwiseAbs().maxCoeff();
  }
  constexpr double kRounding = 1 + 1e-10;
  if (same) return std::sqrt(largest_eigenvalue(first)) * kRounding;
  double largest = 0;
  for (int i = 0; i < kMany; ++i)
    largest = std::max(largest, largest_eigenvalue(gram_at(i, kMany)));
  return std::sqrt(largest / std::cos(kTurn / 2 * 4 / kMany)) * kRounding;
}

}  // namespace treeline::bounds
