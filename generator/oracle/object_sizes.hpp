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

/// Scales of the results of `kObjectFunctions` at one state: the equations of Chang tables 7.1 and
/// 7.2 with the magnitude of every term in place of the term.
class ObjectSizes {
 public:
  /// `M_inverse` has the magnitudes of M^-1.
  ObjectSizes(const Subject<double>& subject, const State& state, const Eigen::MatrixXd& M_inverse);

  /// Properties of the solve for all hands' forces, with rows relaxed by `law`. Its matrix is
  /// Lambda^-1, plus the mobility of objects that move freely. Nothing if there is no such matrix.
  [[nodiscard]] std::optional<LawSizes> relaxed(Function function,
                                                const interpreter::TaskLaw<double>& law) const;
  /// Scale of each entry of the function's results, in their order. Without `relaxed` for a plain
  /// solve.
  [[nodiscard]] std::vector<double> sizes(Function function,
                                          const std::optional<LawSizes>& relaxed) const;
  /// Condition number of Lambda^-1, scaled to a unit diagonal.
  [[nodiscard]] double condition() const { return condition_; }

 private:
  [[nodiscard]] std::vector<double> object_state() const;
  /// Scales of `object_control_torque`. `Lambda` has the magnitudes of the matrix that turns the
  /// hands' accelerations into forces.
  [[nodiscard]] std::vector<double> control_torque(const Eigen::MatrixXd& Lambda) const;
  [[nodiscard]] std::vector<double> forward_dynamics() const;
  [[nodiscard]] std::vector<double> forward_dynamics(const LawSizes& law) const;
  /// Sizes of the hands' accelerations without objects, minus those that stabilisation commands.
  [[nodiscard]] Eigen::VectorXd open_accelerations(const Eigen::VectorXd& qdd) const;
  [[nodiscard]] Eigen::VectorXd open_chain() const;
  /// Sizes of the motion under these forces of the hands, in the order of the function's results.
  [[nodiscard]] std::vector<double> motion(const Eigen::VectorXd& qdd, const Eigen::VectorXd& xdd,
                                           const Eigen::VectorXd& f) const;
  /// Inverse inertias of the objects at their origins, six rows per object.
  [[nodiscard]] Eigen::MatrixXd mobility() const;
  /// Sizes of the forces that one object with these accelerations needs from its hands, six rows.
  [[nodiscard]] Eigen::VectorXd object_force(std::size_t object,
                                             const Eigen::VectorXd& accelerations) const;
  /// Sizes of such forces and of internal forces, distributed over the object's hands, at the
  /// hands' points; six rows per hand.
  [[nodiscard]] Eigen::VectorXd spread(std::size_t object, const Eigen::VectorXd& force,
                                       const Eigen::VectorXd& internal) const;
  /// Sizes of forces moved from the hands' points to the object's origin, or the other way round.
  [[nodiscard]] Eigen::VectorXd moved(std::size_t object, Eigen::VectorXd forces) const;

  const Subject<double>& subject_;
  const State& state_;
  const Eigen::MatrixXd& M_inverse_;
  Subject<double> seen_;  ///< with the origins of the objects, fixed to the hands, as points
  TermSizes terms_;
  Eigen::MatrixXd J_, Lambda_inverse_, Lambda_, C_;
  Eigen::VectorXd bias_;
  double condition_ = 1;
};

}  // namespace treeline
