#pragma once

#include <Eigen/Core>

#include "interpreter/task_law.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Properties of a solve whose rows are relaxed near singularities: its condition number, and the
/// largest magnitudes of Lambda at the state and in its neighbourhood, where the relaxation of a
/// row may be steep.
struct LawSizes {
  double condition = 1;
  Eigen::MatrixXd Lambda;  ///< J_D^+ where dependent velocities are eliminated
};

/// Finds these properties at `q`. `law` must be a law on Lambda^-1, not on a Jacobian. `terms` has
/// the sizes of the terms of `Lambda_inverse`, in the rows of the task.
LawSizes find_law_sizes(const Subject<double>& subject, const Eigen::VectorXd& q,
                        const Eigen::MatrixXd& Lambda_inverse, const Eigen::MatrixXd& terms,
                        const interpreter::TaskLaw<double>& law);

/// Finds the properties for any symmetric matrix A, given the sizes of its diagonal's terms.
/// `shares`: to which its first rows are held.
LawSizes find_law_sizes(const Eigen::MatrixXd& A, const Eigen::VectorXd& terms,
                        const interpreter::TaskLaw<double>& law,
                        const Eigen::VectorXd& shares = {});

/// How much more the forces along rows in strict priority, per acceleration that the rows lack, may
/// change by rounding, of size `unit`, than their slope says, in units of `unit`. What a row near
/// its border leaves to those after it is lost in rounding, which may carry these across theirs.
Eigen::MatrixXd find_priority_steps(const interpreter::Points<double>& points,
                                    const Eigen::MatrixXd& Lambda_inverse,
                                    const Eigen::VectorXd& terms, double unit);

}  // namespace treeline
