#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "oracle/damped_sizes.hpp"
#include "oracle/law_sizes.hpp"
#include "oracle/object_sizes.hpp"
#include "oracle/reference.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {

/// The scales of all functions' results at one state, out of the sizes of their terms.
class ResultSizes {
 public:
  ResultSizes(const Subject<double>& subject, const State& state);

  /// Of the solve with rows that yield by `law`; nothing for functions without one.
  [[nodiscard]] std::optional<LawSizes> yielding(Function function,
                                                 const interpreter::TaskLaw<double>& law) const;
  /// Of each entry of the function's results, in their order. `result` is what it is, by `law`,
  /// and `yielding` what the law's solve has.
  [[nodiscard]] std::vector<double> sizes(
      Function function, const std::vector<double>& result,
      const interpreter::TaskLaw<double>& law = {},
      const std::optional<LawSizes>& yielding = std::nullopt) const;
  /// Of the matrix that the function solves with; 1 for none.
  [[nodiscard]] double condition(Function function,
                                 const std::optional<LawSizes>& yielding = std::nullopt) const;

 private:
  [[nodiscard]] Eigen::VectorXd forward_dynamics(const std::vector<double>& qdd) const;
  [[nodiscard]] Eigen::MatrixXd lambda_inverse() const;
  [[nodiscard]] static Eigen::MatrixXd lambda(const Eigen::MatrixXd& Lambda);
  /// With the magnitudes of the matrix that makes forces of the task's accelerations.
  [[nodiscard]] Eigen::VectorXd control_torque(const Eigen::MatrixXd& Lambda) const;
  [[nodiscard]] std::vector<double> damped_control_torque() const;
  [[nodiscard]] std::vector<double> inverse_dynamics_derivatives() const;
  [[nodiscard]] std::vector<double> forward_dynamics_derivatives() const;

  const Subject<double>& subject_;
  const State& state_;
  TermSizes terms_;
  /// Magnitudes of the entries; the last is Lambda as tasks in strict priority leave it.
  Eigen::MatrixXd M_inverse_, Lambda_, control_Lambda_;
  Eigen::MatrixXd Lambda_inverse_;      ///< itself; empty where M has no inverse
  std::optional<ObjectSizes> objects_;  ///< where the scene has any
  std::optional<DampedSizes> damped_;   ///< where the scene asks for it
  double M_condition_ = 1, Lambda_condition_ = 1, control_condition_ = 1;
};

}  // namespace treeline
