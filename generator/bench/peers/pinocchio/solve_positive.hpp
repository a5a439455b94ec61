#pragma once

#include <Eigen/Cholesky>

namespace treeline::peer::pin {

/// Replaces x by A^-1 x and A by its factor, with Eigen's factorization in double.
template <class Right>
void solve_positive(Eigen::MatrixXd& A, Right& x) {
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(A);
  factor.solveInPlace(x);
}

/// Replaces x by A^-1 x and A by its factor, A = L D L^T. For recorded scalars, on whose sign no
/// branch may depend.
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
