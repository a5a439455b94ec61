#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "description/scene.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/law_sizes.hpp"
#include "oracle/subject.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {

/// The scales of the results of `kObjectFunctions` at one state: Chang tables 7.1 and 7.2 with the
/// magnitude of every term in place of the term.
class ObjectSizes {
 public:
  /// `M_inverse` has the magnitudes of M^-1.
  ObjectSizes(const Subject<double>& subject, const State& state, const Eigen::MatrixXd& M_inverse);

  /// Of the matrix that gives all hands' forces where they yield by `law`: Lambda^-1 and, where the
  /// objects move freely, their mobility. Nothing where there is no such matrix.
  [[nodiscard]] std::optional<LawSizes> yielding(Function function,
                                                 const interpreter::TaskLaw<double>& law) const;
  /// `yielding`: nothing for a bare solve.
  [[nodiscard]] std::vector<double> sizes(Function function,
                                          const std::optional<LawSizes>& yielding) const;
  /// Of Lambda^-1, scaled to a unit diagonal.
  [[nodiscard]] double condition() const { return condition_; }

 private:
  [[nodiscard]] std::vector<double> object_state() const;
  /// With the magnitudes of the matrix that makes forces of the hands' accelerations.
  [[nodiscard]] std::vector<double> control_torque(const Eigen::MatrixXd& Lambda) const;
  [[nodiscard]] std::vector<double> forward_dynamics() const;
  [[nodiscard]] std::vector<double> forward_dynamics(const LawSizes& law) const;
  /// Of the hands' accelerations without objects, less what stabilisation asks for.
  [[nodiscard]] Eigen::VectorXd open_accelerations(const Eigen::VectorXd& qdd) const;
  [[nodiscard]] Eigen::VectorXd open_chain() const;
  /// Of the motion with these forces of the hands, in the order of the function's results.
  [[nodiscard]] std::vector<double> motion(const Eigen::VectorXd& qdd, const Eigen::VectorXd& xdd,
                                           const Eigen::VectorXd& f) const;
  /// The objects' inverse inertias at their origins, six rows an object.
  [[nodiscard]] Eigen::MatrixXd mobility() const;
  /// Of what one object with such accelerations asks of its hands, six rows.
  [[nodiscard]] Eigen::VectorXd object_force(std::size_t object,
                                             const Eigen::VectorXd& accelerations) const;
  /// The same with internal forces, spread over its hands, at their points; six rows a hand.
  [[nodiscard]] Eigen::VectorXd spread(std::size_t object, const Eigen::VectorXd& force,
                                       const Eigen::VectorXd& internal) const;
  /// Forces at the hands' points, at the object's origin, or the other way round.
  [[nodiscard]] Eigen::VectorXd moved(std::size_t object, Eigen::VectorXd forces) const;

  const Subject<double>& subject_;
  const State& state_;
  const Eigen::MatrixXd& M_inverse_;
  Subject<double> seen_;  ///< with the objects' origins in the hands as points
  TermSizes terms_;
  Eigen::MatrixXd J_, Lambda_inverse_, Lambda_, C_;
  Eigen::VectorXd bias_;
  double condition_ = 1;
};

}  // namespace treeline
