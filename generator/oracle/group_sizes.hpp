#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "description/scene.hpp"
#include "interpreter/task_law.hpp"
#include "interpreter/task_shares.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"
#include "oracle/term_sizes.hpp"

namespace treeline {

/// Scales of the results of one of `kContactFunctions`, from the sizes of their terms. `M_inverse`
/// has the magnitudes of M^-1. `result` is what the function returns.
std::vector<double> contact_sizes(Function function, const Subject<double>& subject,
                                  const State& state, const Eigen::MatrixXd& M_inverse,
                                  const std::vector<double>& result);

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

/// Scales of the rows of constraints between links and between joints, see `TermSizes`. Joints that
/// carry both links play no part.
struct LoopSizes {
  Eigen::MatrixXd J;       ///< rows x nv
  Eigen::VectorXd bias;    ///< of Jd qd
  Eigen::VectorXd errors;  ///< of how far they are from closed
  double condition = 1;    ///< of J: infinite where a disc lies flat
};

LoopSizes loop_sizes(const Subject<double>& subject, const State& state);

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
