#pragma once

#include <Eigen/Core>

namespace treeline {

/// By how much a solve with the symmetric matrix A may amplify errors in its entries, when that of
/// entry ij is relative to sqrt(d_i d_j): 1 / smallest eigenvalue of D^-1/2 A D^-1/2. With d the
/// diagonal of A this is, but for a factor of at most n, the condition that bounds the error of an
/// LDL^T solve (Demmel; Higham, Accuracy and Stability of Numerical Algorithms, theorem 10.6); with
/// d the sizes of the terms that the diagonal is a sum of, entries that are but rounding errors
/// count as zero. It does not depend on the units of the coordinates. At least 1 when no d_i is
/// less than A_ii; infinite when A is not positive definite in double.
double scaled_condition(const Eigen::MatrixXd& A, const Eigen::VectorXd& d);

}  // namespace treeline
