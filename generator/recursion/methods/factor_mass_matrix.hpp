#pragma once

#include <vector>

#include "recursion/algebra/dense_matrix.hpp"

namespace treeline {

/// Factorization M = L^T D L with unit lower triangular L, from the last velocity to the first, so
/// that L has no more nonzeros than M if M belongs to a tree (Featherstone, RBDA section 6.5).
/// Structural zeros stay zero without special treatment.
template <class Scalar>
struct LtdlFactor {
  DenseMatrix<Scalar> L;
  std::vector<Scalar> inverse_D;
};

template <class Scalar>
LtdlFactor<Scalar> factor_ltdl(DenseMatrix<Scalar> M) {
  const std::size_t n = M.rows();
  LtdlFactor<Scalar> factor{DenseMatrix<Scalar>(n, n), std::vector<Scalar>(n)};
  for (std::size_t k = n; k-- > 0;) {
    factor.inverse_D[k] = Scalar(1.0) / M(k, k);
    for (std::size_t i = 0; i < k; ++i) {
      factor.L(k, i) = M(k, i) * factor.inverse_D[k];
    }
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        M(i, j) = M(i, j) - factor.L(k, i) * M(k, j);
      }
    }
  }
  return factor;
}

/// Solves M x = b.
template <class Scalar>
std::vector<Scalar> solve(const LtdlFactor<Scalar>& factor, std::vector<Scalar> x) {
  const std::size_t n = x.size();
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t i = 0; i < k; ++i) {
      x[i] = x[i] - factor.L(k, i) * x[k];
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = x[k] * factor.inverse_D[k];
    for (std::size_t i = 0; i < k; ++i) {
      x[k] = x[k] - factor.L(k, i) * x[i];
    }
  }
  return x;
}

/// J M^-1 J^T = sum over velocities of y_k y_k^T / D_k with Y = J L^-1; symmetric.
template <class Scalar>
DenseMatrix<Scalar> inverse_inertia_in_rows(const LtdlFactor<Scalar>& factor,
                                            DenseMatrix<Scalar> Y) {
  const std::size_t rows = Y.rows();
  DenseMatrix<Scalar> Lambda_inv(rows, rows);
  for (std::size_t k = Y.cols(); k-- > 0;) {
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t i = 0; i < k; ++i) {
        Y(r, i) = Y(r, i) - factor.L(k, i) * Y(r, k);
      }
      const Scalar scaled = Y(r, k) * factor.inverse_D[k];
      for (std::size_t s = 0; s <= r; ++s) {
        Lambda_inv(r, s) = Lambda_inv(r, s) + scaled * Y(s, k);
      }
    }
  }
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t s = 0; s < r; ++s) {
      Lambda_inv(s, r) = Lambda_inv(r, s);
    }
  }
  return Lambda_inv;
}

}  // namespace treeline
