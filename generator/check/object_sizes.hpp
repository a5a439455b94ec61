#pragma once

#include <Eigen/Core>
#include <vector>

#include "check/draw_state.hpp"
#include "check/subject.hpp"
#include "check/term_sizes.hpp"
#include "description/scene.hpp"

namespace treeline {

/// The scales of the results of `kObjectFunctions` at one state: Chang tables 7.1 and 7.2 with the
/// magnitude of every term in place of the term.
class ObjectSizes {
 public:
  /// `M_inverse` has the magnitudes of M^-1.
  ObjectSizes(const Subject<double>& subject, const State& state, const Eigen::MatrixXd& M_inverse);

  [[nodiscard]] std::vector<double> sizes(Function function) const;
  /// Of Lambda^-1 of all hands together, scaled to a unit diagonal.
  [[nodiscard]] double condition() const { return condition_; }

 private:
  [[nodiscard]] std::vector<double> object_state() const;
  [[nodiscard]] std::vector<double> control_torque() const;
  [[nodiscard]] std::vector<double> forward_dynamics() const;
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
  Eigen::MatrixXd J_, Lambda_, C_;
  Eigen::VectorXd bias_;
  double condition_ = 1;
};

}  // namespace treeline
