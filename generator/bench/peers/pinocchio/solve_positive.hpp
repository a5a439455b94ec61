#pragma once

#include <Eigen/Cholesky>

namespace treeline::peer::pin {

/// x = A^-1 x, in A's place its factor. With Eigen's factorisation in double.
template <class Right>
void solve_positive(Eigen::MatrixXd& A, Right& x) {
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(A);
  factor.solveInPlace(x);
}

/// For a scalar that is recorded, whose sign no branch may depend on: A = L D L^T.
template <class Scalar, class Right>
void solve_positive(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& A, Right& x) {
  const Eigen::Index n = A.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    const Scalar reciprocal = Scalar(1) / A(k, k);
    for (Eigen::Index i = k + 1; i < n; ++i) {
      const Scalar factor = A(i, k) * reciprocal;
      for (Eigen::Index j = k + 1; j <= i; ++j) A(i, j) -= factor * A(j, k);
    }
    for (Eigen::Index i = k + 1; i < n; ++i) A(i, k) *= reciprocal;
    A(k, k) = reciprocal;
  }
  for (Eigen::Index column = 0; column < x.cols(); ++column) {
    for (Eigen::Index k = 0; k < n; ++k) {
      for (Eigen::Index i = k + 1; i < n; ++i) x(i, column) -= A(i, k) * x(k, column);
    }
    for (Eigen::Index k = n; k-- > 0;) {
      x(k, column) *= A(k, k);
      for (Eigen::Index i = k + 1; i < n; ++i) x(k, column) -= A(i, k) * x(i, column);
    }
  }
}

}  // namespace treeline::peer::pin
