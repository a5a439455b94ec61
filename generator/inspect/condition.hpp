#pragma once

#include <Eigen/Core>

namespace treeline {

/// 1 / smallest eigenvalue after scaling to a unit diagonal; infinite for what is not positive.
double unit_condition(const Eigen::MatrixXd& A);

}  // namespace treeline
