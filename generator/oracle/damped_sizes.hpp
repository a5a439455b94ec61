#pragma once

#include <Eigen/Core>

#include "oracle/subject.hpp"

namespace treeline {

/// Scales by which the errors of `damped_control_torque` are measured at one state.
struct DampedSizes {
  Eigen::MatrixXd Lambda;  ///< magnitudes of (Lambda^-1 + Delta)^-1
  double least_eigenvalue =
      0;  ///< size of the terms from which the smallest eigenvalue is computed
  /// Factor by which errors of Lambda^-1's terms are amplified: their norm divided by the smallest
  /// s + delta(s), both scaled by the limits of effective mass. Here s are the eigenvalues of the
  /// scaled Lambda^-1 and delta is the damping. The factor follows from d(A + Delta)^-1 = -(A +
  /// Delta)^-1 d(A + Delta) (A + Delta)^-1, where the norm of d Delta is at most three times that
  /// of dA because of delta's slope. Singularities do not make it large; only directions with a
  /// much smaller mass than the limit do.
  double condition = 1;
};

/// Finds these scales from Lambda^-1. `terms` has the sizes of the terms of Lambda^-1.
DampedSizes find_damped_sizes(const Eigen::MatrixXd& Lambda_inverse, const Eigen::MatrixXd& terms,
                              const interpreter::Damping<double>& damping);

}  // namespace treeline
