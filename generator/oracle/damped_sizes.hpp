#pragma once

#include <Eigen/Core>

#include "oracle/subject.hpp"

namespace treeline {

/// What the results of `damped_control_torque` at one state are measured by.
struct DampedSizes {
  Eigen::MatrixXd Lambda;  ///< magnitudes of (Lambda^-1 + Delta)^-1
  double ease = 0;         ///< of the terms that the least ease is a difference of
  /// By how much errors of Lambda^-1's terms are amplified: their norm over the least of
  /// s + delta(s), all scaled by the heaviest motions. For d(A + Delta)^-1 =
  /// -(A + Delta)^-1 d(A + Delta) (A + Delta)^-1, and d Delta is at most three times dA in norm,
  /// delta being no steeper. No singularity makes it large, only directions that are light beside
  /// the heaviest.
  double condition = 1;
};

/// `terms`: the sizes of Lambda^-1's terms.
DampedSizes find_damped_sizes(const Eigen::MatrixXd& Lambda_inverse, const Eigen::MatrixXd& terms,
                              const interpreter::Damping<double>& damping);

}  // namespace treeline
