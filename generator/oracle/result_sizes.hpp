#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "interpreter/task_shares.hpp"
#include "oracle/group_sizes.hpp"
#include "oracle/reference.hpp"
#include "oracle/symmetric_matrices.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {

/// Scales of the results of all functions at one state, from the sizes of their terms.
class ResultSizes {
 public:
  ResultSizes(const Subject<double>& subject, const State& state);

  /// Properties of the solve with rows that are relaxed by `law`. Nothing for functions without
  /// such a solve.
  [[nodiscard]] std::optional<LawSizes> relaxed(Function function,
                                                const interpreter::TaskLaw<double>& law) const;
  /// Scale of each entry of the function's results, in their order. `result` is the function's
  /// result with the law `law`, `relaxed` the properties of its solve.
  [[nodiscard]] std::vector<double> sizes(
      Function function, const std::vector<double>& result,
      const interpreter::TaskLaw<double>& law = {},
      const std::optional<LawSizes>& relaxed = std::nullopt) const;
  /// Largest change by rounding of size `unit` where it carries rows in the order of priority
  /// across their borders, in ulp of the scale.
  [[nodiscard]] double border_steps(Function function, double unit) const;
  /// Condition numbers of the matrices that the function solves with; 1 where there is none.
  [[nodiscard]] Conditions conditions(Function function,
                                      const std::optional<LawSizes>& relaxed = std::nullopt) const;

 private:
  struct Solved;
  struct Row;
  struct Table;

  [[nodiscard]] const ConstraintSizes& of_constraints(Function function) const;
  [[nodiscard]] Eigen::VectorXd forward_dynamics(const std::vector<double>& qdd) const;
  [[nodiscard]] Eigen::MatrixXd forces_by_velocity() const;
  [[nodiscard]] Eigen::MatrixXd lambda_inverse() const;
  [[nodiscard]] static Eigen::MatrixXd lambda(const Eigen::MatrixXd& Lambda);
  /// Scales of `control_torque`. `Lambda` has the magnitudes of the matrix that turns the task's
  /// accelerations into forces.
  [[nodiscard]] Eigen::VectorXd control_torque(const Eigen::MatrixXd& Lambda) const;
  /// S Lambda S with the shares to which tasks are done.
  [[nodiscard]] Eigen::MatrixXd with_shares(const Eigen::MatrixXd& Lambda) const;
  [[nodiscard]] std::vector<double> damped_control_torque() const;
  /// |M^-1| |J|^T |Lambda|, and with |J| behind it.
  [[nodiscard]] Eigen::MatrixXd dynamically_consistent_inverse(const Eigen::MatrixXd& Lambda) const;
  [[nodiscard]] Eigen::MatrixXd null_space_projector(const Eigen::MatrixXd& Lambda) const;
  /// |Lambda| (|J| |M^-1| sizes of b + sizes of Jd qd).
  [[nodiscard]] Eigen::VectorXd operational_bias_force(const Eigen::MatrixXd& Lambda) const;
  [[nodiscard]] Eigen::VectorXd operational_gravity(const Eigen::MatrixXd& Lambda) const;
  [[nodiscard]] std::vector<double> inverse_dynamics_derivatives() const;
  [[nodiscard]] std::vector<double> forward_dynamics_derivatives() const;

  const Subject<double>& subject_;
  const State& state_;
  TermSizes terms_;
  std::vector<double> at_rest_;  ///< zeros, a joint velocity each
  /// Magnitudes of the entries. The last one is Lambda after tasks of strict priority.
  Eigen::MatrixXd M_inverse_, Lambda_, control_Lambda_;
  Eigen::MatrixXd Lambda_inverse_;  ///< the matrix itself; empty if M has no inverse
  interpreter::TaskShares<double> shares_;
  Eigen::MatrixXd control_inverse_;                         ///< Lambda^-1 with these shares
  std::optional<ObjectSizes> objects_;                      ///< only if the scene has objects
  std::optional<ConstraintSizes> constrained_, supported_;  ///< only where they can be asked for
  std::optional<DampedSizes> damped_;                       ///< only if the scene asks for damping
  double M_condition_ = 1, Lambda_condition_ = 1, control_condition_ = 1;
};

}  // namespace treeline
