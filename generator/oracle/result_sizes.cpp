#include "oracle/result_sizes.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <span>

#include "description/noise.hpp"
#include "functions/function_table.hpp"
#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/group_sizes.hpp"
#include "oracle/symmetric_matrices.hpp"

namespace treeline {
namespace {

std::vector<double> joined(std::initializer_list<Eigen::MatrixXd> matrices) {
  std::vector<double> entries;
  for (const Eigen::MatrixXd& matrix : matrices) {
    append(matrix, entries);
  }
  return entries;
}

/// Lambda^-1 plus the relaxation of rows in strict priority: c (1 - w) / w for each row.
Eigen::MatrixXd with_relaxed_rows(const interpreter::Points<double>& points,
                                  const Eigen::MatrixXd& A) {
  const Eigen::VectorXd borders = interpreter::relaxation_borders<double>(points, A.diagonal());
  Eigen::MatrixXd left = A;
  Eigen::MatrixXd relaxed = A;
  for (const int row : interpreter::rows_by_priority(points)) {
    const double c = std::max(left(row, row), 1e-9 * borders(row));
    const double inverse = interpreter::relaxed_inverse<double>(c, borders(row));
    if (borders(row) > 0) relaxed(row, row) += 1 / inverse - c;
    const Eigen::VectorXd column = left.col(row);
    left -= column * (inverse * column.transpose());
  }
  return relaxed;
}

}  // namespace

ResultSizes::ResultSizes(const Subject<double>& subject, const State& state)
    : subject_(subject), state_(state), terms_(subject, state.q), at_rest_(state.qd.size(), 0) {
  const Eigen::VectorXd q = vector_of<double>(state.q);
  const Eigen::MatrixXd M = interpreter::mass_matrix<double>(subject.model, q);
  M_condition_ = scaled_condition(M, terms_.mass_matrix().diagonal());
  M_inverse_ = inverse_of_symmetric(M).cwiseAbs();
  if (!subject.chain.objects.empty()) objects_.emplace(subject_, state_, M_inverse_);
  if (subject.holds_rows()) {
    constrained_.emplace(subject_, state_, M_inverse_, ConstraintSizes::Tasks::none);
  }
  if (subject.holds_rows() || (!subject.points.empty() && !subject.passive.empty())) {
    supported_.emplace(subject_, state_, M_inverse_, ConstraintSizes::Tasks::all);
  }
  if (subject.points.empty() || M_condition_ > std::numeric_limits<double>::max()) {
    Lambda_condition_ = std::numeric_limits<double>::infinity();
    control_condition_ = Lambda_condition_;
    return;
  }
  const Eigen::MatrixXd Lambda_inverse =
      interpreter::lambda_inverse<double>(subject.model, subject.points, q);
  Lambda_inverse_ = Lambda_inverse;
  Lambda_condition_ = scaled_condition(Lambda_inverse, lambda_inverse().diagonal());
  Lambda_ = inverse_of_symmetric(Lambda_inverse).cwiseAbs();
  if (subject.damping.effective_mass_limits.size() > 0) {
    damped_ = find_damped_sizes(Lambda_inverse, lambda_inverse(), subject.damping);
  }
  shares_ = interpreter::task_shares<double>(subject.points);
  control_inverse_ = interpreter::with_shares<double>(Lambda_inverse, shares_);
  Eigen::MatrixXd relaxed = control_inverse_;
  if (interpreter::has_priorities(subject.points)) {
    relaxed = with_relaxed_rows(subject.points, control_inverse_);
  }
  const Eigen::VectorXd scale =
      lambda_inverse().diagonal() + (relaxed - control_inverse_).diagonal();
  control_condition_ = scaled_condition(relaxed, scale);
  control_Lambda_ = with_shares(inverse_of_symmetric(relaxed).cwiseAbs());
}

double ResultSizes::border_steps(Function function, double unit) const {
  if (function != Function::control_torque || Lambda_inverse_.size() == 0 ||
      !interpreter::has_priorities(subject_.points)) {
    return 0;
  }
  const Eigen::VectorXd sizes = control_torque(control_Lambda_);
  const Eigen::MatrixXd of_forces =
      find_priority_steps(subject_.points, control_inverse_, lambda_inverse().diagonal(), unit);
  const Eigen::VectorXd steps = control_torque(control_Lambda_ + of_forces) - sizes;
  double largest = 0;
  for (Eigen::Index i = 0; i < sizes.size(); ++i) {
    if (sizes(i) > 0) largest = std::max(largest, steps(i) / sizes(i));
  }
  return largest;
}

std::optional<LawSizes> ResultSizes::relaxed(Function function,
                                             const interpreter::TaskLaw<double>& law) const {
  if (law.borders.empty()) return std::nullopt;
  if (needs_objects(function)) return objects_->relaxed(function, law);
  if (needs_constraints(function)) return of_constraints(function).relaxed(law);
  if (!has_lambda(function) || Lambda_inverse_.size() == 0) return std::nullopt;
  if (function == Function::control_torque && interpreter::has_priorities(subject_.points)) {
    return std::nullopt;
  }
  const bool controls = function == Function::control_torque;
  LawSizes found =
      find_law_sizes(subject_, vector_of<double>(state_.q),
                     controls ? control_inverse_ : Lambda_inverse_, lambda_inverse(), law);
  if (controls) found.Lambda = with_shares(found.Lambda);
  return found;
}

Eigen::MatrixXd ResultSizes::with_shares(const Eigen::MatrixXd& Lambda) const {
  return shares_.s.asDiagonal() * Lambda * shares_.s.asDiagonal();
}

Conditions ResultSizes::conditions(Function function,
                                   const std::optional<LawSizes>& relaxed) const {
  if (function == Function::constraint_jacobian) return {constrained_->loop_condition()};
  const Solve solve = solve_of(function);
  if (needs_objects(function) && solve != Solve::none) {
    return {M_condition_, relaxed ? relaxed->condition : objects_->condition()};
  }
  if (needs_constraints(function) && solve != Solve::none) {
    const ConstraintSizes& constraints = of_constraints(function);
    return {std::max(M_condition_, constraints.loop_condition()),
            relaxed ? relaxed->condition : constraints.condition()};
  }
  if (relaxed) return {M_condition_, relaxed->condition};
  switch (solve) {
    case Solve::mass_matrix:
      return {M_condition_};
    case Solve::lambda_inverse:
      return {M_condition_,
              function == Function::control_torque ? control_condition_ : Lambda_condition_};
    case Solve::damped:
      return {M_condition_, damped_ ? damped_->condition : 1};
    case Solve::none:
      break;
  }
  return {};
}

/// Data that the solve of a function adds to the terms: its result, the law that relaxes rows, the
/// properties of the relaxed solve, and |Lambda| with that law.
struct ResultSizes::Solved {
  const std::vector<double>& result;
  const interpreter::TaskLaw<double>& law;
  const std::optional<LawSizes>& relaxed;
  const Eigen::MatrixXd& Lambda;
};

/// Scales of the results of one function.
struct ResultSizes::Row {
  Function function;
  std::vector<double> (*sizes)(const ResultSizes& of, const Solved& in);
};

/// All functions but those about objects, contacts and links, which have sizes of their own.
struct ResultSizes::Table {
  using Of = const ResultSizes&;
  using In = const Solved&;
  static constexpr Row kOfRobot[] = {
      {Function::inverse_dynamics,
       [](Of of, In) {
         return entries_of(of.terms_.forces(of.state_.qd, of.state_.qdd, of.state_.f_ext));
       }},
      {Function::gravity,
       [](Of of, In) { return entries_of(of.terms_.forces(of.at_rest_, of.at_rest_, {})); }},
      {Function::nonlinear_effects,
       [](Of of, In) { return entries_of(of.terms_.forces(of.state_.qd, of.at_rest_, {})); }},
      {Function::mass_matrix, [](Of of, In) { return entries_of(of.terms_.mass_matrix()); }},
      {Function::forward_dynamics,
       [](Of of, In in) { return entries_of(of.forward_dynamics(in.result)); }},
      {Function::center_of_mass, [](Of of, In) { return entries_of(of.terms_.center_of_mass()); }},
      {Function::center_of_mass_jacobian,
       [](Of of, In) { return entries_of(of.terms_.center_of_mass_jacobian()); }},
      {Function::inverse_dynamics_derivatives,
       [](Of of, In) { return of.inverse_dynamics_derivatives(); }},
      {Function::forward_dynamics_derivatives,
       [](Of of, In) { return of.forward_dynamics_derivatives(); }},
      {Function::coriolis_matrix,
       [](Of of, In) { return entries_of(of.terms_.forces_by_velocity(of.state_.qd) / 2); }},
      {Function::kinetic_energy,
       [](Of of, In) { return std::vector<double>{of.terms_.kinetic_energy(of.state_.qd)}; }},
      {Function::kinetic_energy_derivatives,
       [](Of of, In) {
         return joined({of.terms_.kinetic_energy_by_displacement(of.state_.qd),
                        of.terms_.mass_matrix() * magnitudes(of.state_.qd)});
       }},
      {Function::potential_energy,
       [](Of of, In) { return std::vector<double>{of.terms_.potential_energy()}; }},
      {Function::inverse_dynamics_regressor,
       [](Of of, In) {
         return entries_of(of.terms_.inverse_dynamics_regressor(of.state_.qd, of.state_.qdd));
       }},
      {Function::energy_regressor,
       [](Of of, In) { return entries_of(of.terms_.energy_regressor(of.state_.qd)); }},
      {Function::centroidal_momentum_matrix,
       [](Of of, In) { return entries_of(of.terms_.centroidal_momentum_matrix()); }},
      {Function::centroidal_momentum,
       [](Of of, In) { return entries_of(of.terms_.centroidal_momentum(of.state_.qd)); }},
      {Function::centroidal_bias,
       [](Of of, In) { return entries_of(of.terms_.centroidal_bias(of.state_.qd)); }},
      {Function::center_of_mass_bias_acceleration,
       [](Of of, In) {
         return entries_of(of.terms_.centroidal_bias(of.state_.qd).head(3) /
                           interpreter::total_mass(of.subject_.model));
       }},
      {Function::centroidal_momentum_derivatives,
       [](Of of, In) {
         return joined({of.terms_.centroidal_momentum_by_displacement(of.state_.qd),
                        of.terms_.centroidal_momentum_matrix()});
       }},
      {Function::centroidal_momentum_rate_derivatives,
       [](Of of, In) {
         return joined({of.terms_.centroidal_rate_by_displacement(of.state_.qd, of.state_.qdd),
                        of.terms_.centroidal_rate_by_velocity(of.state_.qd),
                        of.terms_.centroidal_momentum_matrix()});
       }},
      {Function::subtree_masses_and_centers,
       [](Of of, In) { return entries_of(of.terms_.subtrees()); }},
  };
  static constexpr Row kOfTask[] = {
      {Function::forward_kinematics, [](Of of, In) { return entries_of(of.terms_.poses()); }},
      {Function::jacobian, [](Of of, In) { return entries_of(of.terms_.jacobian()); }},
      {Function::bias_acceleration,
       [](Of of, In) { return entries_of(of.terms_.bias(of.state_.qd)); }},
      {Function::lambda_inverse, [](Of of, In) { return entries_of(of.lambda_inverse()); }},
      {Function::lambda, [](Of of, In in) { return entries_of(of.lambda(in.Lambda)); }},
      {Function::control_torque,
       [](Of of, In in) {
         return entries_of(of.control_torque(in.relaxed ? in.relaxed->Lambda : of.control_Lambda_));
       }},
      {Function::point_velocity,
       [](Of of, In) { return entries_of(of.terms_.point_velocities(of.state_.qd)); }},
      {Function::point_acceleration,
       [](Of of, In) {
         return entries_of(of.terms_.point_accelerations(of.state_.qd, of.state_.qdd));
       }},
      {Function::point_velocity_derivatives,
       [](Of of, In) {
         return joined({of.terms_.point_velocities_by_displacement(of.state_.qd),
                        of.terms_.point_jacobian()});
       }},
      {Function::point_acceleration_derivatives,
       [](Of of, In) {
         return joined({of.terms_.point_accelerations_by_displacement(of.state_.qd, of.state_.qdd),
                        of.terms_.point_accelerations_by_velocity(of.state_.qd),
                        of.terms_.point_jacobian()});
       }},
      {Function::dynamically_consistent_inverse,
       [](Of of, In in) { return entries_of(of.dynamically_consistent_inverse(in.Lambda)); }},
      {Function::null_space_projector,
       [](Of of, In in) { return entries_of(of.null_space_projector(in.Lambda)); }},
      {Function::operational_bias_force,
       [](Of of, In in) { return entries_of(of.operational_bias_force(in.Lambda)); }},
      {Function::operational_gravity,
       [](Of of, In in) { return entries_of(of.operational_gravity(in.Lambda)); }},
      {Function::damped_control_torque, [](Of of, In) { return of.damped_control_torque(); }},
      {Function::constraint_jacobian,
       [](Of of, In) { return entries_of(of.constrained_->jacobian()); }},
      {Function::constraint_errors,
       [](Of of, In) { return entries_of(of.constrained_->loop_errors()); }},
      {Function::constrained_forward_dynamics,
       [](Of of, In in) {
         return of.of_constraints(Function::constrained_forward_dynamics).sizes(in.law, in.relaxed);
       }},
      {Function::supported_control_torque,
       [](Of of, In in) {
         return of.of_constraints(Function::supported_control_torque).sizes(in.law, in.relaxed);
       }},
  };
};

std::vector<double> ResultSizes::sizes(Function function, const std::vector<double>& result,
                                       const interpreter::TaskLaw<double>& law,
                                       const std::optional<LawSizes>& relaxed) const {
  constexpr std::span<const Row> of_robot(Table::kOfRobot), of_task(Table::kOfTask);
  static_assert(covers<is_about<FunctionGroup::robot, FunctionGroup::center_of_mass,
                                FunctionGroup::derivatives>>(of_robot));
  static_assert(covers<is_about<FunctionGroup::points, FunctionGroup::constraints>>(of_task));
  if (needs_objects(function)) return objects_->sizes(function, relaxed);
  const Row* row = find_row(of_robot, function);
  if (row == nullptr) row = find_row(of_task, function);
  if (row == nullptr) {
    return contact_sizes(function, subject_, state_, M_inverse_, result);
  }
  return row->sizes(*this, {result, law, relaxed, relaxed ? relaxed->Lambda : Lambda_});
}

const ConstraintSizes& ResultSizes::of_constraints(Function function) const {
  return function == Function::supported_control_torque ? *supported_ : *constrained_;
}

/// M^-1| (|tau| + sizes of inverse dynamics at the resulting qdd). Where drives are
/// implicit, with M + step D + step^2 K in place of M.
Eigen::VectorXd ResultSizes::forward_dynamics(const std::vector<double>& qdd) const {
  Eigen::VectorXd forces =
      vector_of<double>(state_.tau).cwiseAbs() + terms_.forces(state_.qd, qdd, state_.f_ext);
  const std::vector<double>& step = values_of(state_, Quantity::step);
  if (step.empty()) return M_inverse_ * forces;
  const Eigen::VectorXd q = vector_of<double>(state_.q);
  const auto drives = interpreter::implicit_drives<double>(
      subject_.model, q, vector_of<double>(state_.qd), step.front());
  forces += drives.inertia * vector_of<double>(qdd).cwiseAbs() + drives.force.cwiseAbs();
  const Eigen::MatrixXd M = interpreter::mass_matrix<double>(subject_.model, q) + drives.inertia;
  return inverse_of_symmetric(M).cwiseAbs() * forces;
}

/// Sizes of the joint forces' derivatives by velocity, with those of friction.
Eigen::MatrixXd ResultSizes::forces_by_velocity() const {
  Eigen::MatrixXd sizes = terms_.forces_by_velocity(state_.qd);
  sizes.diagonal() += terms_.friction_slopes();
  return sizes;
}

/// |J| |M^-1| |J|^T. An entry of M^-1 that is only noise of the files, such as the coupling of
/// turns and translations of a body balanced but for 1e-16, has the scale of sqrt(|M^-1|_ii
/// |M^-1|_jj).
Eigen::MatrixXd ResultSizes::lambda_inverse() const {
  constexpr double kNoise = 64 * kResolution;  // as in TermSizes
  const Eigen::MatrixXd J = terms_.jacobian();
  const Eigen::VectorXd d = M_inverse_.diagonal().cwiseSqrt();
  const Eigen::MatrixXd most = d * d.transpose();
  const Eigen::MatrixXd W = M_inverse_.binaryExpr(most, [](double entry, double largest) {
    return entry > 0 && entry <= kNoise * largest ? largest : entry;
  });
  return J * W * J.transpose();
}

/// sqrt(Lambda_ii Lambda_jj), which no entry exceeds.
Eigen::MatrixXd ResultSizes::lambda(const Eigen::MatrixXd& Lambda) {
  const Eigen::VectorXd d = Lambda.diagonal().cwiseSqrt();
  return d * d.transpose();
}

/// Sizes of inverse dynamics at qdd_0, plus |J|^T |Lambda| (|xdd_cmd| + |Jd qd| + |J| |qdd_0|). The
/// forces of the task also pass through joints that they do not move, and leave their rounding
/// errors there. So each torque's scale is at least a thousandth of the largest.
Eigen::VectorXd ResultSizes::control_torque(const Eigen::MatrixXd& Lambda) const {
  const Eigen::MatrixXd J = terms_.jacobian();
  const Eigen::VectorXd rows = vector_of<double>(state_.xdd_cmd).cwiseAbs() +
                               terms_.bias(state_.qd) +
                               J * vector_of<double>(state_.qdd).cwiseAbs();
  const Eigen::VectorXd sizes =
      terms_.forces(state_.qd, state_.qdd, state_.f_ext) + J.transpose() * (Lambda * rows);
  return sizes.cwiseMax(0x1p-10 * sizes.maxCoeff());
}

std::vector<double> ResultSizes::damped_control_torque() const {
  std::vector<double> entries = entries_of(control_torque(damped_->Lambda));
  entries.push_back(damped_->least_eigenvalue);
  return entries;
}

Eigen::MatrixXd ResultSizes::dynamically_consistent_inverse(const Eigen::MatrixXd& Lambda) const {
  return M_inverse_ * terms_.jacobian().transpose() * lambda(Lambda);
}

Eigen::MatrixXd ResultSizes::null_space_projector(const Eigen::MatrixXd& Lambda) const {
  return Eigen::MatrixXd::Identity(M_inverse_.rows(), M_inverse_.cols()) +
         dynamically_consistent_inverse(Lambda) * terms_.jacobian();
}

Eigen::VectorXd ResultSizes::operational_bias_force(const Eigen::MatrixXd& Lambda) const {
  Subject<double> weightless = subject_;
  weightless.model = interpreter::without_gravity<double>(weightless.model);
  const Eigen::VectorXd b = TermSizes(weightless, state_.q).forces(state_.qd, at_rest_, {});
  return lambda(Lambda) * (terms_.jacobian() * (M_inverse_ * b) + terms_.bias(state_.qd));
}

Eigen::VectorXd ResultSizes::operational_gravity(const Eigen::MatrixXd& Lambda) const {
  return lambda(Lambda) *
         (terms_.jacobian() * (M_inverse_ * terms_.forces(at_rest_, at_rest_, {})));
}

std::vector<double> ResultSizes::inverse_dynamics_derivatives() const {
  return joined({terms_.forces_by_displacement(state_.qd, state_.qdd, state_.f_ext),
                 forces_by_velocity(), terms_.mass_matrix()});
}

/// W times the sizes of inverse dynamics at a qdd of the size of its terms. W_ij = sqrt(|M^-1|_ii
/// |M^-1|_jj), which no entry of M^-1 exceeds; an entry that cancels would say nothing about its
/// terms.
std::vector<double> ResultSizes::forward_dynamics_derivatives() const {
  const Eigen::VectorXd at = interpreter::forward_dynamics<double>(
      subject_.model, vector_of<double>(state_.q), vector_of<double>(state_.qd),
      vector_of<double>(state_.tau), subject_.external, vector_of<double>(state_.f_ext));
  const std::vector<double> qdd = entries_of(forward_dynamics(entries_of(at)));
  const Eigen::VectorXd d = M_inverse_.diagonal().cwiseSqrt();
  const Eigen::MatrixXd W = d * d.transpose();
  return joined({W * terms_.forces_by_displacement(state_.qd, qdd, state_.f_ext),
                 W * forces_by_velocity(), W});
}

}  // namespace treeline
