#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "interpreter/task_law.hpp"
#include "interpreter/task_shares.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/elimination_sizes.hpp"
#include "oracle/law_sizes.hpp"
#include "oracle/loop_sizes.hpp"
#include "oracle/subject.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {

/// Scales of the results of functions about constraints at one state: their equations with the
/// magnitude of every term in place of the term.
class ConstraintSizes {
 public:
  /// Tasks whose rows there are beside those of the constraints: none for constrained forward
  /// dynamics, all operational points for a supported control torque.
  enum class Tasks { none, all };

  /// `M_inverse` has the magnitudes of M^-1.
  ConstraintSizes(const Subject<double>& subject, const State& state,
                  const Eigen::MatrixXd& M_inverse, Tasks tasks);

  /// Properties of the solve with rows that are relaxed by `law`; its condition is that of all
  /// solves together. Nothing without a law, or if M has no inverse.
  [[nodiscard]] std::optional<LawSizes> relaxed(const interpreter::TaskLaw<double>& law) const;
  /// Scale of each entry of the function's results, in their order.
  [[nodiscard]] std::vector<double> sizes(const interpreter::TaskLaw<double>& law,
                                          const std::optional<LawSizes>& relaxed) const;
  /// Scales of J of all rows, and of how far loops are from closed.
  [[nodiscard]] const Eigen::MatrixXd& jacobian() const { return J_; }
  [[nodiscard]] const Eigen::VectorXd& loop_errors() const { return loops_.errors; }
  /// Condition of the rows of loops: infinite where they have no value.
  [[nodiscard]] double loop_condition() const { return loops_.condition; }
  /// Condition number of Lambda^-1, scaled to a unit diagonal.
  [[nodiscard]] double condition() const { return condition_; }

 private:
  [[nodiscard]] std::vector<double> constrained(const Eigen::MatrixXd& Lambda) const;
  /// Terms of the motion with dependent velocities eliminated.
  [[nodiscard]] EliminationTerms elimination_terms() const;
  [[nodiscard]] std::vector<double> supported(const interpreter::TaskLaw<double>& law,
                                              const Eigen::MatrixXd& Lambda) const;
  /// Sizes of K^-1, the inverse inertia of passive joints.
  [[nodiscard]] Eigen::MatrixXd passive_mobility() const;
  /// Properties of the solve for the constraints' forces on passive joints.
  [[nodiscard]] LawSizes forces(const interpreter::TaskLaw<double>& law) const;
  /// Properties of the solve for the constraints with motors locked.
  [[nodiscard]] LawSizes locked(const interpreter::TaskLaw<double>& law) const;
  /// J of all rows: constraints to the world, loops, then tasks.
  [[nodiscard]] Eigen::MatrixXd jacobian_of_rows() const;
  /// The columns of J that belong to passive joints, and their sizes.
  [[nodiscard]] Eigen::MatrixXd passive_columns() const;
  [[nodiscard]] Eigen::MatrixXd passive_sizes() const;

  const Subject<double>& subject_;
  const State& state_;
  Eigen::MatrixXd
      M_inverse_;  ///< with friction and springs at the end of the step, if there is one
  Eigen::VectorXd step_forces_;  ///< of springs, by the motion in that step
  Tasks tasks_;
  Subject<double> seen_;  ///< with points: the constraints, then the tasks by priority
  TermSizes terms_;
  LoopSizes loops_;
  Eigen::Index anchored_ = 0, held_ = 0;  ///< rows held to the world, and all that are held
  Eigen::VectorXd shares_;                ///< to which they are held; empty: 1
  interpreter::TaskShares<double> rows_;  ///< to which tasks are done; 1 of held rows
  Eigen::MatrixXd J_, Lambda_inverse_;
  Eigen::MatrixXd M_;  ///< of the step, if there is one; empty without loops and step
  Eigen::VectorXd bias_;
  double condition_ = 1;
};

}  // namespace treeline
