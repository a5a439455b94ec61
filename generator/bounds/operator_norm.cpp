#include "bounds/operator_norm.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace treeline::bounds {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr int kFew = 16, kMany = 64;
constexpr double kRounding = 1 + 1e-10;

/// On the stack: rows and columns are those of a 3x3 matrix at most.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostRows, kMostRows>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows, 1>;

struct Direction {
  double cosine = 1, sine = 0;
};

/// The angles of kMany samples, evenly spread.
const std::array<Direction, kMany>& directions() {
  static const std::array<Direction, kMany> all = [] {
    std::array<Direction, kMany> made;
    for (int i = 0; i < kMany; ++i) {
      const double angle = kTurn * i / kMany;
      made[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    return made;
  }();
  return all;
}

Matrix value_at(const TrigMatrix& A, int sample, int samples) {
  const Direction at = directions()[static_cast<std::size_t>(sample * (kMany / samples))];
  Matrix value =
      Matrix::Zero(static_cast<Eigen::Index>(A.rows), static_cast<Eigen::Index>(A.columns));
  for (const MatrixEntry& entry : A.entries) {
    value(static_cast<Eigen::Index>(entry.row), static_cast<Eigen::Index>(entry.column)) +=
        entry.value.at(at.cosine, at.sine);
  }
  return value;
}

/// Products of the rows, or of the columns where they are fewer: its largest eigenvalue is the
/// square of the norm.
Matrix gram(const Matrix& A) {
  if (A.rows() <= A.cols()) return A.lazyProduct(A.transpose());
  return A.transpose().lazyProduct(A);
}

double largest_eigenvalue(const Matrix& G) {
  const double largest = G.diagonal().maxCoeff();
  const double sum =
      (G.cwiseAbs().rowwise().sum() - G.diagonal().cwiseAbs()).maxCoeff();  // Gershgorin
  if (sum <= 1e-12 * largest) return largest + sum;
  return Eigen::SelfAdjointEigenSolver<Matrix>(G, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace

std::vector<double> column_norms(const TrigMatrix& A) {
  Vector squares = Vector::Zero(static_cast<Eigen::Index>(A.columns));
  for (int i = 0; i < kFew; ++i) {
    squares = squares.cwiseMax(value_at(A, i, kFew).colwise().squaredNorm().transpose());
  }
  const Vector norms = squares.cwiseSqrt();
  return {norms.data(), norms.data() + norms.size()};
}

double operator_norm(const TrigMatrix& A, const std::vector<double>& scale) {
  const Vector inverse =
      Eigen::Map<const Eigen::VectorXd>(scale.data(), static_cast<Eigen::Index>(scale.size()))
          .cwiseInverse();
  const auto gram_at = [&](int sample, int samples) {
    const Matrix scaled = value_at(A, sample, samples) * inverse.asDiagonal();
    return gram(scaled);
  };
  const Matrix first = gram_at(0, kFew);
  bool same = true;
  for (int i = 1; same && i < kFew; ++i) {
    same = (gram_at(i, kFew) - first).cwiseAbs().maxCoeff() <= 1e-12 * first.cwiseAbs().maxCoeff();
  }
  if (same) return std::sqrt(largest_eigenvalue(first)) * kRounding;
  double largest = 0;
  for (int i = 0; i < kMany; ++i)
    largest = std::max(largest, largest_eigenvalue(gram_at(i, kMany)));
  return std::sqrt(largest / std::cos(kTurn / 2 * 4 / kMany)) * kRounding;
}

double frobenius_norm(const TrigMatrix& A, const std::vector<double>& scale) {
  double least = 0, largest = 0;
  for (int i = 0; i < kFew; ++i) {
    const Direction at = directions()[static_cast<std::size_t>(i * (kMany / kFew))];
    double sum = 0;
    for (const MatrixEntry& entry : A.entries) {
      const double value = entry.value.at(at.cosine, at.sine) / scale[entry.column];
      sum += value * value;
    }
    least = i == 0 ? sum : std::min(least, sum);
    largest = std::max(largest, sum);
  }
  if (largest - least <= 1e-12 * largest) return std::sqrt(largest) * kRounding;
  return std::sqrt(largest / std::cos(kTurn / 2 * 4 / kFew)) * kRounding;
}

}  // namespace treeline::bounds
