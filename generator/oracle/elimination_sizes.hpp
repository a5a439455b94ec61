#pragma once

#include <Eigen/Core>
#include <vector>

#include "interpreter/task_law.hpp"
#include "oracle/law_sizes.hpp"

namespace treeline {

/// Terms from which a motion with dependent velocities eliminated is computed. Sizes are those of
/// the terms of each entry.
struct EliminationTerms {
  Eigen::MatrixXd J, J_sizes;  ///< of the rows of loops, then of tasks
  Eigen::MatrixXd M, M_sizes;
  Eigen::VectorXd forces;  ///< sizes of net joint forces, or of those needed at qdd_0
  Eigen::VectorXd asked;   ///< sizes of the accelerations that rows ask for
  Eigen::VectorXd qdd_0;   ///< sizes, for torques
};

/// Condition of an elimination, that of J_D^+ times that of the inertia that is left, and the sizes
/// of J_D^+, see `interpreter::DependentRates`. The condition of J_D^+ is found by trial: its
/// change when J changes at random by a few roundings. A dependent velocity that yields has the
/// size that it has where it does not.
LawSizes find_elimination_sizes(const EliminationTerms& terms,
                                const interpreter::TaskLaw<double>& law);

/// Scales of qdd and f; `inverse` has the sizes of J_D^+.
std::vector<double> eliminated_sizes(const EliminationTerms& terms,
                                     const interpreter::TaskLaw<double>& law,
                                     const Eigen::MatrixXd& inverse);

/// Condition of the solve for tasks of a robot with dependent velocities eliminated.
double condition_of_tasks(const EliminationTerms& terms, const interpreter::TaskLaw<double>& law,
                          const Eigen::MatrixXd& inverse);

/// Scales of tau and f. Like the torques of a task, each has at least a thousandth of the largest.
std::vector<double> eliminated_torque_sizes(const EliminationTerms& terms,
                                            const interpreter::TaskLaw<double>& law,
                                            const Eigen::MatrixXd& inverse);

}  // namespace treeline
