#pragma once

#include <Eigen/Core>

namespace treeline {

/// A = vectors * values.asDiagonal() * vectors^T with orthonormal vectors and ascending values.
struct SymmetricDecomposition {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// What Eigen does for the symmetric matrix A, of which it reads the lower triangle; compiled once,
// since these templates are among the longest.

SymmetricDecomposition decompose_symmetric(const Eigen::MatrixXd& A);

/// Ascending.
Eigen::VectorXd eigenvalues_of_symmetric(const Eigen::MatrixXd& A);

/// By L^T D L with pivots; not finite where A is singular.
Eigen::MatrixXd inverse_of_symmetric(const Eigen::MatrixXd& A);

}  // namespace treeline
