#pragma once

#include <Eigen/Core>

namespace treeline {

/// Condition number of a solve with the symmetric matrix A: the factor by which the solve may
/// amplify errors of its entries if the error of entry ij is relative to sqrt(d_i d_j). It is 1 /
/// smallest eigenvalue of D^-1/2 A D^-1/2. If d is the diagonal of A, this is within a factor of n
/// the condition number that bounds the error of an LDL^T solve (Demmel; Higham, Accuracy and
/// Stability of Numerical Algorithms, theorem 10.6). If d has the sizes of the terms whose sum is
/// the diagonal, entries that are only rounding errors count as zero. The result does not depend on
/// the units of the coordinates. It is at least 1 if no d_i is less than A_ii, and infinite if A is
/// not positive definite in double.
double scaled_condition(const Eigen::MatrixXd& A, const Eigen::VectorXd& d);

}  // namespace treeline
