#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "recursion/algebra/dense_matrix.hpp"

namespace treeline {

/// Least squares with a matrix A whose columns are made orthogonal one after the other (modified
/// Gram-Schmidt without square roots): A = Q R, R unit upper triangular. The pivots are the squared
/// lengths of Q's columns: no differences, so that digits are lost by the condition of A, not by
/// its square as by LDL^T of A^T A, and no pivot vanishes unless A loses rank. Where `invert` gives
/// another inverse than 1 / square, A^+ is the linear map that these steps make with it.
template <class Scalar>
class OrthogonalColumns {
 public:
  template <class Invert>
  OrthogonalColumns(DenseMatrix<Scalar> A, const Invert& invert)
      : Q_(std::move(A)), R_(Q_.cols(), Q_.cols()) {
    for (std::size_t k = 0; k < Q_.cols(); ++k) {
      inverse_.push_back(invert(k, dot_columns(k, k)));
      for (std::size_t j = k + 1; j < Q_.cols(); ++j) {
        R_(k, j) = dot_columns(k, j) * inverse_[k];
        for (std::size_t i = 0; i < Q_.rows(); ++i) Q_(i, j) = Q_(i, j) - Q_(i, k) * R_(k, j);
      }
    }
  }

  /// A^+ b.
  [[nodiscard]] std::vector<Scalar> solve(std::vector<Scalar> b) const {
    std::vector<Scalar> x;
    for (std::size_t k = 0; k < Q_.cols(); ++k) {
      x.push_back(dot_column(k, b) * inverse_[k]);
      for (std::size_t i = 0; i < b.size(); ++i) b[i] = b[i] - Q_(i, k) * x[k];
    }
    for (std::size_t k = x.size(); k-- > 0;) {
      for (std::size_t j = k + 1; j < x.size(); ++j) x[k] = x[k] - R_(k, j) * x[j];
    }
    return x;
  }

  /// (A^+)^T x, step by step what `solve` does, transposed. It does not rely on columns of Q being
  /// orthogonal to the last digit.
  [[nodiscard]] std::vector<Scalar> solve_transposed(std::vector<Scalar> x) const {
    for (std::size_t k = 0; k < x.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) x[k] = x[k] - R_(j, k) * x[j];
    }
    std::vector<Scalar> f(Q_.rows(), Scalar(0.0));
    for (std::size_t k = x.size(); k-- > 0;) {
      const Scalar share = (x[k] - dot_column(k, f)) * inverse_[k];
      for (std::size_t i = 0; i < f.size(); ++i) f[i] = f[i] + Q_(i, k) * share;
    }
    return f;
  }

 private:
  [[nodiscard]] Scalar dot_columns(std::size_t k, std::size_t j) const {
    Scalar sum(0.0);
    for (std::size_t i = 0; i < Q_.rows(); ++i) sum = sum + Q_(i, k) * Q_(i, j);
    return sum;
  }
  [[nodiscard]] Scalar dot_column(std::size_t k, const std::vector<Scalar>& b) const {
    Scalar sum(0.0);
    for (std::size_t i = 0; i < Q_.rows(); ++i) sum = sum + Q_(i, k) * b[i];
    return sum;
  }

  DenseMatrix<Scalar> Q_, R_;
  std::vector<Scalar> inverse_;
};

}  // namespace treeline
