#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "bounds/trig_polynomial.hpp"

namespace treeline::bounds {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr int kFew = 16, kMany = 64;
constexpr double kRounding = 1 + 1e-10;

/// A matrix on the stack. It has at most as many rows and columns as a 3x3 matrix has entries.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostRows, kMostRows>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostRows, 1>;

struct Direction {
  double cosine = 1, sine = 0;
};

/// Cosines and sines of kMany evenly spaced angles.
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

/// Products of the rows, or of the columns if they are fewer. The largest eigenvalue of this matrix
/// is the square of A's norm.
Matrix gram(const Matrix& A) {
  if (A.rows() > A.cols()) return A.transpose().lazyProduct(A);
  Matrix G(A.rows(), A.rows());
  for (Eigen::Index j = 0; j < A.rows(); ++j) {
    for (Eigen::Index i = j; i < A.rows(); ++i) {
      double sum = 0;
      for (Eigen::Index k = 0; k < A.cols(); ++k) sum += A(i, k) * A(j, k);
      G(i, j) = G(j, i) = sum;
    }
  }
  return G;
}

/// Whether all eigenvalues of G are below `most`. In that case most 1 - G has a factorization L D
/// L^T with positive D.
bool is_below(const Matrix& G, double most) {
  Matrix L = -G;
  L.diagonal().array() += most;
  for (Eigen::Index j = 0; j < L.rows(); ++j) {
    if (!(L(j, j) > 0)) return false;
    const double inverse = 1 / L(j, j);
    for (Eigen::Index i = j + 1; i < L.rows(); ++i) {
      const double factor = L(i, j) * inverse;
      if (factor == 0) continue;
      for (Eigen::Index k = i; k < L.rows(); ++k) L(k, i) -= factor * L(k, j);
    }
  }
  return true;
}

/// Estimates the largest eigenvalue from below by the Rayleigh quotient of a column of G^32.
double estimate_largest(const Matrix& G) {
  constexpr int kSquarings = 5;
  Matrix power = G / G.trace();
  for (int i = 0; i < kSquarings; ++i) {
    power = power.lazyProduct(power).eval();
    power /= power.trace();
  }
  Eigen::Index column = 0;
  power.diagonal().maxCoeff(&column);
  const Vector v = power.col(column);
  return v.dot(G.lazyProduct(v)) / v.squaredNorm();
}

/// Whether all polynomials are of first degree. The products of rows and columns then are of second
/// degree, so five angles determine them.
bool is_of_first_degree(const TrigMatrix& A) {
  return std::all_of(A.entries.begin(), A.entries.end(), [](const MatrixEntry& entry) {
    return entry.value.c[3] == 0 && entry.value.c[4] == 0;
  });
}

constexpr double kNearly = 1 + 1e-12;  // covered by `kRounding`

/// Largest eigenvalue of G, at most 1e-12 of it too large, never too small. An iterative solver
/// does not always converge if entries differ much in size; a factorization does not have this
/// problem.
double largest_eigenvalue(const Matrix& G) {
  const double largest = G.diagonal().maxCoeff();
  const double sum =
      (G.cwiseAbs().rowwise().sum() - G.diagonal().cwiseAbs()).maxCoeff();  // Gershgorin
  if (sum <= 1e-12 * largest) return largest + sum;
  double low = std::max(largest, estimate_largest(G));
  if (is_below(G, kNearly * low)) return low;
  double high = kNearly * (largest + sum);
  constexpr int kMost = 60;  // finite entries need half as many
  for (int i = 0; i < kMost && high > low * (1 + 1e-10); ++i) {
    const double middle = (low + high) / 2;
    (is_below(G, middle) ? high : low) = middle;
  }
  return high;
}

/// Largest eigenvalue of all matrices, up to a relative error that `kRounding` covers. Eigenvalues
/// are computed only for the matrix with the largest entries, and for those whose factorization
/// does not show that theirs are smaller.
double largest_eigenvalue(const std::vector<Matrix>& all) {
  const auto first = std::max_element(all.begin(), all.end(), [](const Matrix& a, const Matrix& b) {
    return a.squaredNorm() < b.squaredNorm();
  });
  double largest = largest_eigenvalue(*first);
  for (const Matrix& G : all) {
    if (G.squaredNorm() < largest * largest) continue;  // the Frobenius norm is an upper bound
    if (!is_below(G, kNearly * largest)) largest = std::max(largest, largest_eigenvalue(G));
  }
  return largest;
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
          .unaryExpr([](double x) { return x > 0 ? 1 / x : 0; });
  const auto gram_at = [&](int sample, int samples) {
    const Matrix scaled = value_at(A, sample, samples) * inverse.asDiagonal();
    return gram(scaled);
  };
  const Matrix first = gram_at(0, kFew);
  const int step = is_of_first_degree(A) ? 2 : 1;
  const double nearly = 1e-12 * first.cwiseAbs().maxCoeff();
  bool same = true;
  for (int i = step; same && i < kFew; i += step) {
    same = (gram_at(i, kFew) - first).cwiseAbs().maxCoeff() <= nearly;
  }
  if (same) return std::sqrt(largest_eigenvalue(first)) * kRounding;
  std::vector<Matrix> grams;
  grams.reserve(kMany);
  for (int i = 0; i < kMany; ++i) grams.push_back(gram_at(i, kMany));
  return std::sqrt(largest_eigenvalue(grams) / std::cos(kTurn / 2 * 4 / kMany)) * kRounding;
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

TurnRounding::TurnRounding(std::size_t rows, std::size_t columns)
    : columns_(columns), products_{rows, columns, {}}, taken_(rows * columns) {}

bool TurnRounding::add(std::size_t row, std::size_t column, const TrigPolynomial& t, double weight,
                       double sine_error) {
  if (taken_[row * columns_ + column]) return false;
  taken_[row * columns_ + column] = true;
  MatrixEntry entry{row, column, t};
  for (double& x : entry.value.c) x *= weight;
  products_.entries.push_back(entry);
  sine_errors_.push_back(weight * sine_error);
  return true;
}

double TurnRounding::bound(const std::vector<double>& scale, double computed, double unit) const {
  if (products_.entries.empty()) return 0;
  double sines = 0;
  for (std::size_t i = 0; i < sine_errors_.size(); ++i) {
    sines = std::hypot(sines, sine_errors_[i] / scale[products_.entries[i].column]);
  }
  // Computed sines |t| + u e_t and rounded products are both less than 1 + 2u times as large.
  return (frobenius_norm(products_, scale) + sines) * computed * (1 + 4 * unit);
}

}  // namespace treeline::bounds
