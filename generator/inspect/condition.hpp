#pragma once

#include <Eigen/Core>

namespace treeline {

/// Condition number of a symmetric matrix after scaling it to a unit diagonal: 1 / smallest
/// eigenvalue. Infinite if A is not positive definite.
double unit_condition(const Eigen::MatrixXd& A);

}  // namespace treeline
