#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "interpreter/loop_instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/group_sizes.hpp"
#include "oracle/interpret.hpp"
#include "oracle/symmetric_matrices.hpp"
#include "recursion/algebra/pivot_rule.hpp"

namespace treeline {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Subject<double> seen_at_constraints(const Subject<double>& subject, bool tasks) {
  Subject<double> seen = subject;
  seen.points = subject.constraints;
  if (!tasks) return seen;
  auto points = subject.points;
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.priority < b.priority; });
  seen.points.insert(seen.points.end(), points.begin(), points.end());
  return seen;
}

/// Whether a plain solve for the tasks, which have no borders then, has no digit left.
bool leaves_no_digit(double condition, const interpreter::TaskLaw<double>& law, Eigen::Index held) {
  const auto first = law.borders.begin() + held;
  const bool plain = first != law.borders.end() &&
                     std::all_of(first, law.borders.end(), [](double b) { return b == 0; });
  const bool single = law.power == inverse_inertia_shape(Real::float32).power;
  return plain && condition > (single ? 0x1p17 : 0x1p46);
}

/// Rows of points, with those of loops after the first `at`.
template <class Rows>
Rows with_loops(const Rows& points, const Rows& loops, Eigen::Index at) {
  Rows all(points.rows() + loops.rows(), points.cols());
  all << points.topRows(at), loops, points.bottomRows(points.rows() - at);
  return all;
}

}  // namespace

ConstraintSizes::ConstraintSizes(const Subject<double>& subject, const State& state,
                                 const MatrixXd& M_inverse, Tasks tasks)
    : subject_(subject),
      state_(state),
      M_inverse_(M_inverse),
      tasks_(tasks),
      seen_(seen_at_constraints(subject, tasks == Tasks::all)),
      terms_(seen_, state.q),
      loops_(loop_sizes(subject, state)),
      anchored_(interpreter::row_count(subject.constraints)),
      held_(anchored_ + interpreter::row_count(subject.loops)),
      shares_(held_shares(subject, state)) {
  rows_ = interpreter::task_shares<double>(seen_.points);
  rows_.s = with_loops<VectorXd>(rows_.s, VectorXd::Ones(held_ - anchored_), anchored_);
  rows_.point.insert(rows_.point.begin() + anchored_, static_cast<std::size_t>(held_ - anchored_),
                     -1);
  J_ = with_loops<MatrixXd>(terms_.jacobian(), loops_.J, anchored_);
  bias_ = with_loops<VectorXd>(terms_.bias(state.qd), loops_.bias, anchored_);
  condition_ = std::numeric_limits<double>::infinity();
  step_forces_ = VectorXd::Zero(M_inverse.rows());
  if (!M_inverse.allFinite() || !std::isfinite(loops_.condition)) return;
  const auto q = vector_of<double>(state.q);
  const std::vector<double>& step = values_of(state, Quantity::step);
  const bool is_stepped = tasks == Tasks::none && !step.empty();
  if (subject.loops.empty() && !is_stepped) {
    Lambda_inverse_ = interpreter::lambda_inverse<double>(subject.model, seen_.points, q);
  } else {
    const MatrixXd J = jacobian_of_rows();
    M_ = interpreter::mass_matrix<double>(subject.model, q);
    if (is_stepped) {
      const auto drives = interpreter::implicit_drives<double>(
          subject.model, q, vector_of<double>(state.qd), step.front());
      M_ += drives.inertia;
      step_forces_ = drives.force.cwiseAbs();
      M_inverse_ = inverse_of_symmetric(M_).cwiseAbs();
    }
    Lambda_inverse_ = J * M_.ldlt().solve(J.transpose());
  }
  condition_ = scaled_condition(Lambda_inverse_, (J_ * M_inverse_ * J_.transpose()).diagonal());
}

std::optional<LawSizes> ConstraintSizes::relaxed(const interpreter::TaskLaw<double>& law) const {
  if (Lambda_inverse_.size() == 0) return std::nullopt;
  if (!law.pivots.empty()) {
    const EliminationTerms eliminated = elimination_terms();
    LawSizes found = find_elimination_sizes(eliminated, law);
    if (tasks_ == Tasks::all) found.condition *= condition_of_tasks(eliminated, law, found.Lambda);
    return found;
  }
  VectorXd terms = (J_ * M_inverse_ * J_.transpose()).diagonal();
  if (tasks_ == Tasks::none) return find_law_sizes(Lambda_inverse_, terms, law, shares_);
  const auto task = supported_task(subject_, state_);
  const auto parts = interpreter::split_law<double>(law, task);
  MatrixXd A = Lambda_inverse_;
  double others = 0;
  if (parts.passive_moves) {
    const interpreter::detail::SupportedRows<double> rows(
        subject_.model, task, vector_of<double>(state_.q), vector_of<double>(state_.qd));
    const auto tail = A.rows() - held_;
    const MatrixXd J = passive_columns().bottomRows(tail);
    A.bottomRightCorner(tail, tail) -=
        J * interpreter::passive_mobility(rows, task, parts) * J.transpose();
    const MatrixXd size = passive_sizes();
    terms += (size * passive_mobility() * size.transpose()).diagonal();
    if (held_ > 0) others += locked(parts.locked).condition;
  }
  if (held_ > 0 && !subject_.passive.empty()) others += forces(parts.forces).condition;
  LawSizes found =
      find_law_sizes(interpreter::with_shares<double>(A, rows_), terms, parts.rows, shares_);
  found.Lambda = (rows_.s.asDiagonal() * found.Lambda * rows_.s.asDiagonal()).eval();
  found.condition += others;
  // A plain solve for rows that are given twice divides by zero.
  if (!found.Lambda.allFinite() || leaves_no_digit(found.condition, parts.rows, held_)) {
    found.condition = std::numeric_limits<double>::infinity();
  }
  return found;
}

std::vector<double> ConstraintSizes::sizes(const interpreter::TaskLaw<double>& law,
                                           const std::optional<LawSizes>& relaxed) const {
  if (relaxed && !law.pivots.empty()) {
    return tasks_ == Tasks::none
               ? eliminated_sizes(elimination_terms(), law, relaxed->Lambda)
               : eliminated_torque_sizes(elimination_terms(), law, relaxed->Lambda);
  }
  const MatrixXd Lambda =
      relaxed ? relaxed->Lambda : MatrixXd(inverse_of_symmetric(Lambda_inverse_).cwiseAbs());
  return tasks_ == Tasks::none ? constrained(Lambda) : supported(law, Lambda);
}

/// Sizes of qdd_o + M^-1 J^T f, f = Lambda (J qdd_o + Jd qd + damping J qd + stiffness drift).
std::vector<double> ConstraintSizes::constrained(const MatrixXd& Lambda) const {
  const std::vector<double> none(state_.qd.size(), 0);
  const VectorXd gains = magnitudes(values_of(state_, Quantity::stabilisation));
  const VectorXd free = M_inverse_ * (magnitudes(state_.tau) +
                                      terms_.forces(state_.qd, none, state_.f_ext) + step_forces_);
  VectorXd drift(held_);
  drift << magnitudes(values_of(state_, Quantity::drift)), loops_.errors;
  const VectorXd missing =
      bias_ + J_ * free + gains(0) * (J_ * magnitudes(state_.qd)) + gains(1) * drift;
  const VectorXd f = Lambda * missing;
  std::vector<double> entries = entries_of(VectorXd(free + M_inverse_ * (J_.transpose() * f)));
  append(f, entries);
  return entries;
}

EliminationTerms ConstraintSizes::elimination_terms() const {
  EliminationTerms terms{
      jacobian_of_rows(), J_, M_, terms_.mass_matrix().cwiseMax(M_.cwiseAbs()), {}, bias_, {}};
  if (tasks_ == Tasks::all) {
    terms.forces = terms_.forces(state_.qd, state_.qdd, state_.f_ext);
    terms.qdd_0 = magnitudes(state_.qdd);
    const VectorXd asked = magnitudes(state_.xdd_cmd);
    terms.asked.tail(J_.rows() - held_).array() += asked.size() > 0 ? asked.maxCoeff() : 0;
    return terms;
  }
  const std::vector<double> none(state_.qd.size(), 0);
  const VectorXd gains = magnitudes(values_of(state_, Quantity::stabilisation));
  terms.forces =
      magnitudes(state_.tau) + terms_.forces(state_.qd, none, state_.f_ext) + step_forces_;
  terms.asked += gains(0) * (J_ * magnitudes(state_.qd)) + gains(1) * loops_.errors;
  return terms;
}

/// Sizes of gamma + J_s^T f, gamma = M qdd + b + g - J_ext^T f_ext, and of f. Like the torques of a
/// task, each has at least a thousandth of the largest.
std::vector<double> ConstraintSizes::supported(const interpreter::TaskLaw<double>& law,
                                               const MatrixXd& Lambda) const {
  const auto parts = interpreter::split_law<double>(law, supported_task(subject_, state_));
  const auto& passive = subject_.passive;
  const MatrixXd J_p = passive_sizes();
  const auto tail = J_.rows() - held_;
  VectorXd gamma = terms_.forces(state_.qd, state_.qdd, state_.f_ext);
  VectorXd rows = bias_ + J_ * magnitudes(state_.qdd);
  VectorXd asked = magnitudes(state_.xdd_cmd);
  rows.tail(tail).array() += asked.size() > 0 ? asked.maxCoeff() : 0;
  VectorXd passive_motion = VectorXd::Zero(static_cast<Eigen::Index>(passive.size()));
  if (parts.passive_moves) {
    passive_motion = passive_mobility() * VectorXd(gamma(passive));
    rows.tail(tail) += J_p.bottomRows(tail) * passive_motion;
  }
  const VectorXd f_rows = Lambda * rows;
  gamma += J_.transpose() * f_rows;
  if (parts.passive_moves) {
    passive_motion += passive_mobility() * (J_p.transpose() * f_rows);
    gamma += terms_.mass_matrix()(Eigen::all, passive) * passive_motion;
  }
  VectorXd f = magnitudes(values_of(state_, Quantity::f_wanted));
  if (held_ > 0) {
    const MatrixXd J_sp = J_p.topRows(held_);
    if (!passive.empty()) {
      const VectorXd balance = VectorXd(gamma(passive)) + J_sp.transpose() * f;
      const VectorXd weights =
          interpreter::detail::held_weights<double>(supported_task(subject_, state_));
      f += weights.cwiseProduct(J_sp * (forces(parts.forces).Lambda * balance));
    }
    gamma += J_.topRows(held_).transpose() * f;
  }
  std::vector<double> entries = entries_of(VectorXd(gamma.cwiseMax(0x1p-10 * gamma.maxCoeff())));
  if (held_ > 0) append(VectorXd(f.cwiseMax(0x1p-10 * f.maxCoeff())), entries);
  return entries;
}

MatrixXd ConstraintSizes::passive_mobility() const {
  const MatrixXd M = interpreter::mass_matrix<double>(subject_.model, vector_of<double>(state_.q));
  return inverse_of_symmetric(M(subject_.passive, subject_.passive)).cwiseAbs();
}

LawSizes ConstraintSizes::forces(const interpreter::TaskLaw<double>& law) const {
  const VectorXd weights =
      interpreter::detail::held_weights<double>(supported_task(subject_, state_));
  const MatrixXd J = passive_columns().topRows(held_);
  const MatrixXd size = passive_sizes().topRows(held_);
  return find_law_sizes(J.transpose() * weights.asDiagonal() * J,
                        (size.transpose() * weights.asDiagonal() * size).diagonal(), law);
}

LawSizes ConstraintSizes::locked(const interpreter::TaskLaw<double>& law) const {
  const MatrixXd M = interpreter::mass_matrix<double>(subject_.model, vector_of<double>(state_.q));
  const MatrixXd K_inverse = inverse_of_symmetric(M(subject_.passive, subject_.passive));
  const MatrixXd J = passive_columns().topRows(held_);
  const MatrixXd size = passive_sizes().topRows(held_);
  return find_law_sizes(J * K_inverse * J.transpose(),
                        (size * K_inverse.cwiseAbs() * size.transpose()).diagonal(), law, shares_);
}

MatrixXd ConstraintSizes::jacobian_of_rows() const {
  const auto q = vector_of<double>(state_.q);
  return with_loops<MatrixXd>(interpreter::jacobian<double>(subject_.model, seen_.points, q),
                              interpreter::loop_jacobian<double>(subject_.model, subject_.loops, q),
                              anchored_);
}

MatrixXd ConstraintSizes::passive_columns() const {
  return jacobian_of_rows()(Eigen::all, subject_.passive);
}

MatrixXd ConstraintSizes::passive_sizes() const {
  return J_(Eigen::all, subject_.passive);
}

}  // namespace treeline
