#pragma once

#include <utility>
#include <vector>

#include "recursion/algebra/align_lanes.hpp"
#include "recursion/algebra/dense_matrix.hpp"

namespace treeline {

/// Factorization A = L D L^T of a symmetric positive definite matrix, L unit lower triangular.
template <class Scalar>
struct LdltFactor {
  DenseMatrix<Scalar> L;
  std::vector<Scalar> inverse_D;
};

/// Assigns lanes to the columns from `first` on, below the diagonal: one lane per row.
template <class Scalar>
void align_lower_columns(DenseMatrix<Scalar>& A, std::size_t first) {
  for (std::size_t j = first; j < A.cols(); ++j) {
    std::vector<Scalar> lanes(A.rows(), Scalar(0.0));
    for (std::size_t i = j; i < A.rows(); ++i) {
      lanes[i] = A(i, j);
    }
    align_lanes(lanes);
    for (std::size_t i = j; i < A.rows(); ++i) {
      A(i, j) = lanes[i];
    }
  }
}

/// Factors A. If `invert` gives another inverse than 1 / D_k for pivot k, the result is the factor
/// of the matrix that has those pivots.
template <class Scalar, class Invert>
LdltFactor<Scalar> factor_ldlt(DenseMatrix<Scalar> A, const Invert& invert) {
  const std::size_t n = A.rows();
  LdltFactor<Scalar> factor{DenseMatrix<Scalar>(n, n), std::vector<Scalar>(n)};
  for (std::size_t k = 0; k < n; ++k) {
    align_lower_columns(A, k);
    factor.inverse_D[k] = invert(k, A(k, k));
    for (std::size_t i = k + 1; i < n; ++i) {
      factor.L(i, k) = A(i, k) * factor.inverse_D[k];
      for (std::size_t j = k + 1; j <= i; ++j) {
        A(i, j) = A(i, j) - factor.L(i, k) * A(j, k);
      }
    }
    align_lower_columns(factor.L, k);
  }
  return factor;
}

template <class Scalar>
LdltFactor<Scalar> factor_ldlt(DenseMatrix<Scalar> A) {
  return factor_ldlt(std::move(A), [](std::size_t, const Scalar& D) { return Scalar(1.0) / D; });
}

/// Solves L x = b.
template <class Scalar>
std::vector<Scalar> solve_lower(const LdltFactor<Scalar>& factor, std::vector<Scalar> b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      b[i] = b[i] - factor.L(i, k) * b[k];
    }
  }
  return b;
}

/// Computes L^-T D^-1 x.
template <class Scalar>
std::vector<Scalar> solve_upper(const LdltFactor<Scalar>& factor, std::vector<Scalar> x) {
  for (std::size_t i = x.size(); i-- > 0;) {
    x[i] = x[i] * factor.inverse_D[i];
    for (std::size_t k = i + 1; k < x.size(); ++k) {
      x[i] = x[i] - factor.L(k, i) * x[k];
    }
  }
  return x;
}

/// Solves A x = b.
template <class Scalar>
std::vector<Scalar> solve(const LdltFactor<Scalar>& factor, const std::vector<Scalar>& b) {
  return solve_upper(factor, solve_lower(factor, b));
}

/// A^-1 = L^-T D^-1 L^-1, symmetric.
template <class Scalar>
DenseMatrix<Scalar> inverse(const LdltFactor<Scalar>& factor) {
  const std::size_t n = factor.inverse_D.size();
  DenseMatrix<Scalar> W(n, n);  // L^-1, column by column
  for (std::size_t j = 0; j < n; ++j) {
    W(j, j) = Scalar(1.0);
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t k = j; k < i; ++k) {
        W(i, j) = W(i, j) - factor.L(i, k) * W(k, j);
      }
    }
  }
  DenseMatrix<Scalar> result(n, n);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i <= k; ++i) {
      const Scalar scaled = W(k, i) * factor.inverse_D[k];
      for (std::size_t j = 0; j <= i; ++j) {
        result(i, j) = result(i, j) + scaled * W(k, j);
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      result(j, i) = result(i, j);
    }
  }
  return result;
}

}  // namespace treeline
