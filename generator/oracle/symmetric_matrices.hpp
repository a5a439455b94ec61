#pragma once

#include <Eigen/Core>
#include <algorithm>

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

/// Condition number of a solve with the symmetric matrix A: the factor by which the solve may
/// amplify errors of its entries if the error of entry ij is relative to sqrt(d_i d_j). It is 1 /
/// smallest eigenvalue of D^-1/2 A D^-1/2. If d is the diagonal of A, this is within a factor of n
/// the condition number that bounds the error of an LDL^T solve (Demmel; Higham, Accuracy and
/// Stability of Numerical Algorithms, theorem 10.6). If d has the sizes of the terms whose sum is
/// the diagonal, entries that are only rounding errors count as zero. The result does not depend on
/// the units of the coordinates. It is at least 1 if no d_i is less than A_ii, and infinite if A is
/// not positive definite in double.
double scaled_condition(const Eigen::MatrixXd& A, const Eigen::VectorXd& d);

/// Condition numbers of two solves, where the matrix of the second is made of the first one's
/// result, as Lambda^-1 is of M^-1.
struct Conditions {
  double first = 1, second = 1;

  /// How near to singular the worse of the matrices is.
  [[nodiscard]] double largest() const { return std::max(first, second); }
  /// By which rounding errors may grow: the first solve leaves up to `first` roundings in each
  /// entry of the second matrix, and the second solve multiplies these by up to `second`, unless
  /// all are errors of one M near the given one, as by L^T D L but not by inertia propagation.
  [[nodiscard]] double amplification() const { return first * second; }
};

}  // namespace treeline
