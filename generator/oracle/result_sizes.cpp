#include "oracle/result_sizes.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>

#include "description/noise.hpp"
#include "interpreter/instances.hpp"
#include "oracle/condition.hpp"
#include "oracle/contact_sizes.hpp"
#include "oracle/entries.hpp"

namespace treeline {
namespace {

std::vector<double> joined(std::initializer_list<Eigen::MatrixXd> matrices) {
  std::vector<double> entries;
  for (const Eigen::MatrixXd& matrix : matrices) {
    append(matrix, entries);
  }
  return entries;
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& A) {
  return A.ldlt().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
}

/// Lambda^-1 plus the relaxation of rows in strict priority: c (1 - w) / w for each row.
Eigen::MatrixXd with_yields(const interpreter::Points<double>& points, const Eigen::MatrixXd& A) {
  const Eigen::VectorXd borders = interpreter::yield_borders<double>(points, A.diagonal());
  Eigen::MatrixXd left = A;
  Eigen::MatrixXd yielded = A;
  for (const int row : interpreter::rows_by_priority(points)) {
    const double c = std::max(left(row, row), 1e-9 * borders(row));
    const double inverse = interpreter::yielding_inverse<double>(c, borders(row));
    if (borders(row) > 0) yielded(row, row) += 1 / inverse - c;
    const Eigen::VectorXd column = left.col(row);
    left -= column * (inverse * column.transpose());
  }
  return yielded;
}

}  // namespace

ResultSizes::ResultSizes(const Subject<double>& subject, const State& state)
    : subject_(subject), state_(state), terms_(subject, state.q) {
  const Eigen::VectorXd q = vector_of<double>(state.q);
  const Eigen::MatrixXd M = interpreter::mass_matrix<double>(subject.model, q);
  M_condition_ = scaled_condition(M, terms_.mass_matrix().diagonal());
  M_inverse_ = inverse(M).cwiseAbs();
  if (!subject.chain.objects.empty()) objects_.emplace(subject_, state_, M_inverse_);
  if (subject.holds_rows()) {
    constrained_.emplace(subject_, state_, M_inverse_, ConstraintSizes::Tasks::none);
  }
  if (subject.points.empty() ? subject.holds_rows() && !subject.passive.empty()
                             : subject.holds_rows() || !subject.passive.empty()) {
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
  Lambda_ = inverse(Lambda_inverse).cwiseAbs();
  if (subject.damping.heaviest.size() > 0) {
    damped_ = find_damped_sizes(Lambda_inverse, lambda_inverse(), subject.damping);
  }
  control_condition_ = Lambda_condition_;
  control_Lambda_ = Lambda_;
  if (!interpreter::has_priorities(subject.points)) return;
  const Eigen::MatrixXd yielded = with_yields(subject.points, Lambda_inverse);
  const Eigen::VectorXd scale = lambda_inverse().diagonal() + (yielded - Lambda_inverse).diagonal();
  control_condition_ = scaled_condition(yielded, scale);
  control_Lambda_ = inverse(yielded).cwiseAbs();
}

std::optional<LawSizes> ResultSizes::yielding(Function function,
                                              const interpreter::TaskLaw<double>& law) const {
  if (law.borders.empty()) return std::nullopt;
  if (needs_objects(function)) return objects_->yielding(function, law);
  if (needs_constraints(function)) return of_constraints(function).yielding(law);
  if (!has_lambda(function) || Lambda_inverse_.size() == 0) return std::nullopt;
  if (function == Function::control_torque && interpreter::has_priorities(subject_.points)) {
    return std::nullopt;
  }
  return find_law_sizes(subject_, vector_of<double>(state_.q), Lambda_inverse_, lambda_inverse(),
                        law);
}

double ResultSizes::condition(Function function, const std::optional<LawSizes>& yielding) const {
  const bool about_hands = needs_objects(function) && solve_of(function) != Solve::none;
  if (about_hands) {
    return std::max(yielding ? yielding->condition : objects_->condition(), M_condition_);
  }
  if (needs_constraints(function) && solve_of(function) != Solve::none) {
    const double own = yielding ? yielding->condition : of_constraints(function).condition();
    return std::max(own, M_condition_);
  }
  if (yielding) return std::max(yielding->condition, M_condition_);
  switch (solve_of(function)) {
    case Solve::mass_matrix:
      return M_condition_;
    case Solve::lambda_inverse:
      return std::max(function == Function::control_torque ? control_condition_ : Lambda_condition_,
                      M_condition_);
    case Solve::damped:
      return damped_ ? std::max(damped_->condition, M_condition_) : M_condition_;
    case Solve::none:
      break;
  }
  return 1;
}

std::vector<double> ResultSizes::sizes(Function function, const std::vector<double>& result,
                                       const interpreter::TaskLaw<double>& law,
                                       const std::optional<LawSizes>& yielding) const {
  const std::vector<double> none(state_.qd.size(), 0);
  const Eigen::MatrixXd& Lambda = yielding ? yielding->Lambda : Lambda_;
  switch (function) {
    case Function::forward_kinematics:
      return entries_of(terms_.poses());
    case Function::jacobian:
      return entries_of(terms_.jacobian());
    case Function::bias_acceleration:
      return entries_of(terms_.bias(state_.qd));
    case Function::inverse_dynamics:
      return entries_of(terms_.forces(state_.qd, state_.qdd, state_.f_ext));
    case Function::gravity:
      return entries_of(terms_.forces(none, none, {}));
    case Function::nonlinear_effects:
      return entries_of(terms_.forces(state_.qd, none, {}));
    case Function::mass_matrix:
      return entries_of(terms_.mass_matrix());
    case Function::forward_dynamics:
      return entries_of(forward_dynamics(result));
    case Function::lambda_inverse:
      return entries_of(lambda_inverse());
    case Function::lambda:
      return entries_of(lambda(Lambda));
    case Function::control_torque:
      return entries_of(control_torque(yielding ? yielding->Lambda : control_Lambda_));
    case Function::center_of_mass:
      return entries_of(terms_.center_of_mass());
    case Function::center_of_mass_jacobian:
      return entries_of(terms_.center_of_mass_jacobian());
    case Function::inverse_dynamics_derivatives:
      return inverse_dynamics_derivatives();
    case Function::forward_dynamics_derivatives:
      return forward_dynamics_derivatives();
    case Function::coriolis_matrix:
      return entries_of(terms_.forces_by_velocity(state_.qd) / 2);
    case Function::kinetic_energy:
      return {terms_.kinetic_energy(state_.qd)};
    case Function::kinetic_energy_derivatives:
      return joined({terms_.kinetic_energy_by_displacement(state_.qd),
                     terms_.mass_matrix() * magnitudes(state_.qd)});
    case Function::potential_energy:
      return {terms_.potential_energy()};
    case Function::inverse_dynamics_regressor:
      return entries_of(terms_.inverse_dynamics_regressor(state_.qd, state_.qdd));
    case Function::energy_regressor:
      return entries_of(terms_.energy_regressor(state_.qd));
    case Function::centroidal_momentum_matrix:
      return entries_of(terms_.centroidal_momentum_matrix());
    case Function::centroidal_momentum:
      return entries_of(terms_.centroidal_momentum(state_.qd));
    case Function::centroidal_bias:
      return entries_of(terms_.centroidal_bias(state_.qd));
    case Function::center_of_mass_bias_acceleration:
      return entries_of(terms_.centroidal_bias(state_.qd).head(3) /
                        interpreter::total_mass(subject_.model));
    case Function::centroidal_momentum_derivatives:
      return joined({terms_.centroidal_momentum_by_displacement(state_.qd),
                     terms_.centroidal_momentum_matrix()});
    case Function::centroidal_momentum_rate_derivatives:
      return joined({terms_.centroidal_rate_by_displacement(state_.qd, state_.qdd),
                     terms_.centroidal_rate_by_velocity(state_.qd),
                     terms_.centroidal_momentum_matrix()});
    case Function::subtree_masses_and_centers:
      return entries_of(terms_.subtrees());
    case Function::point_velocity:
      return entries_of(terms_.point_velocities(state_.qd));
    case Function::point_acceleration:
      return entries_of(terms_.point_accelerations(state_.qd, state_.qdd));
    case Function::point_velocity_derivatives:
      return joined({terms_.point_velocities_by_displacement(state_.qd), terms_.point_jacobian()});
    case Function::point_acceleration_derivatives:
      return joined({terms_.point_accelerations_by_displacement(state_.qd, state_.qdd),
                     terms_.point_accelerations_by_velocity(state_.qd), terms_.point_jacobian()});
    case Function::dynamically_consistent_inverse:
      return entries_of(dynamically_consistent_inverse(Lambda));
    case Function::null_space_projector:
      return entries_of(null_space_projector(Lambda));
    case Function::operational_bias_force:
      return entries_of(operational_bias_force(Lambda));
    case Function::operational_gravity:
      return entries_of(operational_gravity(Lambda));
    case Function::damped_control_torque:
      return damped_control_torque();
    case Function::object_state:
    case Function::object_control_torque:
    case Function::object_forward_dynamics:
      return objects_->sizes(function, yielding);
    case Function::constraint_jacobian:
      return entries_of(constrained_->jacobian());
    case Function::constraint_errors:
      return entries_of(constrained_->loop_errors());
    case Function::constrained_forward_dynamics:
    case Function::supported_control_torque:
      return of_constraints(function).sizes(law, yielding);
    case Function::contact_motion:
    case Function::contact_inverse_inertia:
    case Function::effective_mass:
    case Function::impulse_response:
    case Function::link_inverse_inertias:
      return contact_sizes(function, subject_, state_, M_inverse_, result, law);
  }
  throw std::logic_error("a function outside of its enumeration");
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
  return inverse(M).cwiseAbs() * forces;
}

/// Those of velocities and of friction.
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
  entries.push_back(damped_->ease);
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
  const std::vector<double> none(state_.qd.size(), 0);
  const Eigen::VectorXd b = TermSizes(weightless, state_.q).forces(state_.qd, none, {});
  return lambda(Lambda) * (terms_.jacobian() * (M_inverse_ * b) + terms_.bias(state_.qd));
}

Eigen::VectorXd ResultSizes::operational_gravity(const Eigen::MatrixXd& Lambda) const {
  const std::vector<double> none(state_.qd.size(), 0);
  return lambda(Lambda) * (terms_.jacobian() * (M_inverse_ * terms_.forces(none, none, {})));
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
