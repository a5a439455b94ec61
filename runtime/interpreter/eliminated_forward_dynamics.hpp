#pragma once

#include <vector>

#include "interpreter/constrained_forward_dynamics.hpp"
#include "interpreter/supported_control_torque.hpp"

namespace treeline::interpreter {

/// How dependent velocities follow in a pose: J_D^+ of the rows and dependent velocities that the
/// pivots of a law name, qd_D = J_D^+ (c - J_I qd_I).
template <class Scalar>
struct DependentRates {
  std::vector<int> rows, dependent, independent;
  Matrix<Scalar> J_I;
  Matrix<Scalar> inverse;  ///< J_D^+
};

/// J^+ by projections: column after column of what those before it leave is projected out. Where
/// the law says so, a column's squared length has another inverse, and it yields.
template <class Scalar>
Matrix<Scalar> inverse_by_columns(const Matrix<Scalar>& J, const TaskLaw<Scalar>& law) {
  const Eigen::Index n = J.cols(), rows = J.rows();
  Matrix<Scalar> left = J;                                     // of the columns
  Matrix<Scalar> rest = Matrix<Scalar>::Identity(rows, rows);  // of what is to be solved for
  Matrix<Scalar> shares = Matrix<Scalar>::Zero(n, rows), R = Matrix<Scalar>::Identity(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Vector<Scalar> column = left.col(k);
    const Scalar border =
        law.borders.empty() ? Scalar(0) : law.borders[static_cast<std::size_t>(k)];
    const Vector<Scalar> dual =
        column * bounded_inverse<Scalar>(column.squaredNorm(), border, law.power);
    shares.row(k) = dual.transpose() * rest;
    rest -= column * shares.row(k);
    for (Eigen::Index j = k + 1; j < n; ++j) {
      R(k, j) = dual.dot(left.col(j));
      left.col(j) -= column * R(k, j);
    }
  }
  return R.template triangularView<Eigen::UnitUpper>().solve(shares);
}

template <class Scalar>
DependentRates<Scalar> dependent_rates(const Matrix<Scalar>& J, const TaskLaw<Scalar>& law) {
  DependentRates<Scalar> rates;
  for (const auto& [row, velocity] : law.pivots) {
    rates.rows.push_back(row);
    rates.dependent.push_back(velocity);
  }
  for (int v = 0; v < static_cast<int>(J.cols()); ++v) {
    bool depends = false;
    for (const int velocity : rates.dependent) depends = depends || velocity == v;
    if (!depends) rates.independent.push_back(v);
  }
  rates.J_I = J(rates.rows, rates.independent);
  rates.inverse = inverse_by_columns<Scalar>(J(rates.rows, rates.dependent), law);
  return rates;
}

/// Directions in which the robot may move: a column for each independent velocity.
template <class Scalar>
Matrix<Scalar> permitted_motions(const DependentRates<Scalar>& rates, Eigen::Index nv) {
  const auto n = static_cast<Eigen::Index>(rates.independent.size());
  Matrix<Scalar> P = Matrix<Scalar>::Zero(nv, n);
  P(rates.independent, Eigen::all) = Matrix<Scalar>::Identity(n, n);
  P(rates.dependent, Eigen::all) = -rates.inverse * rates.J_I;
  return P;
}

/// Motion with loops held, where the velocities that the law's pivots name follow the others: qdd =
/// P x + s, P^T M P x = P^T (net - M s), and the forces that the dependent velocities lack, carried
/// to the rows. Where J_D is regular this is the motion of the KKT system.
template <class Scalar>
ConstrainedMotion<Scalar> eliminated_forward_dynamics(
    const Model<Scalar>& model, const ConstrainedState<std::type_identity_t<Scalar>>& at,
    const TaskLaw<Scalar>& law) {
  const Matrix<Scalar> J = loop_jacobian<Scalar>(model, at.loops, at.q);
  const auto rates = dependent_rates<Scalar>(J, law);
  const Matrix<Scalar> P = permitted_motions(rates, J.cols());
  const Vector<Scalar> asked = detail::held_accelerations<Scalar>(model, {}, J, at);
  Vector<Scalar> qdd = Vector<Scalar>::Zero(J.cols());
  qdd(rates.dependent) = rates.inverse * Vector<Scalar>(asked(rates.rows));
  const Matrix<Scalar> M = detail::stepped_mass_matrix(model, at);
  const Vector<Scalar> net = detail::net_forces(model, at);
  const Vector<Scalar> forces = P.transpose() * (net - M * qdd);
  qdd += P * (inverse_of_positive_definite<Scalar>(Matrix<Scalar>(P.transpose() * M * P)) * forces);
  const Vector<Scalar> lacking = M * qdd - net;
  Vector<Scalar> f = Vector<Scalar>::Zero(J.rows());
  f(rates.rows) = rates.inverse.transpose() * Vector<Scalar>(lacking(rates.dependent));
  return {qdd, f};
}

/// Borders of a law behind those of its pivots: of the rows of tasks.
template <class Scalar>
TaskLaw<Scalar> law_behind_pivots(const TaskLaw<Scalar>& law) {
  TaskLaw<Scalar> rest{law.power, {}, {}, {}};
  for (std::size_t k = law.pivots.size(); k < law.borders.size(); ++k) {
    rest.borders.push_back(law.borders[k]);
  }
  return rest;
}

/// Torques of motors alone for a task, where rows of loops hold the robot and every joint without a
/// motor follows: qdd = P x + s nearest to qdd_0 in the metric of M. Rows of tasks are relaxed by
/// the law's borders behind those of its pivots.
template <class Scalar>
SupportedTorque<Scalar> eliminated_control_torque(const Model<Scalar>& model,
                                                  const SupportedTask<Scalar>& task,
                                                  VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                                  const TaskLaw<Scalar>& law) {
  const detail::SupportedRows<Scalar> rows(model, task, q, qd);
  const auto rates = dependent_rates<Scalar>(Matrix<Scalar>(rows.J.topRows(rows.held)), law);
  const Matrix<Scalar> P = permitted_motions(rates, rows.J.cols());
  const auto tasks = rows.J.rows() - rows.held;
  const Matrix<Scalar> J_t = rows.J.bottomRows(tasks);
  const Matrix<Scalar> J_c = J_t * P;
  const Matrix<Scalar> M_s_inverse =
      inverse_of_positive_definite<Scalar>(Matrix<Scalar>(P.transpose() * rows.M * P));
  Vector<Scalar> qdd = Vector<Scalar>::Zero(rows.J.cols());
  qdd(rates.dependent) = rates.inverse * Vector<Scalar>(rows.asked(rates.rows));
  qdd += P * (M_s_inverse * (P.transpose() * (rows.M * (task.qdd_0 - qdd))));
  const Vector<Scalar> missing = rows.asked.tail(tasks) - J_t * qdd;
  const Matrix<Scalar> A = J_c * M_s_inverse * J_c.transpose();
  qdd += P * (M_s_inverse *
              (J_c.transpose() * (bordered_inverse<Scalar>(A, law_behind_pivots(law)) * missing)));
  const Vector<Scalar> gamma = rows.M * qdd + rows.bias;
  SupportedTorque<Scalar> result{Vector<Scalar>::Zero(rows.J.cols()),
                                 Vector<Scalar>::Zero(rows.held)};
  result.tau(rates.independent) = P.transpose() * gamma;
  result.f(rates.rows) = rates.inverse.transpose() * Vector<Scalar>(gamma(rates.dependent));
  return result;
}

}  // namespace treeline::interpreter
