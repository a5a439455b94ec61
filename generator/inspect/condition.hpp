#pragma once

#include <Eigen/Core>

namespace treeline {

/// Decimal digits that a state costs: from `kSingularDigits` on it counts as singular; double has
/// `kMostDigits` to lose.
inline constexpr double kSingularDigits = 5, kMostDigits = 15.7;

inline constexpr int kRangeSteps = 48;  ///< states that are looked at along a joint's range

/// Condition number of a symmetric matrix after scaling it to a unit diagonal: 1 / smallest
/// eigenvalue. Infinite if A is not positive definite.
double unit_condition(const Eigen::MatrixXd& A);

}  // namespace treeline
