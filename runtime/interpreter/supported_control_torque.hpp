#pragma once

#include <vector>

#include "interpreter/constrained_forward_dynamics.hpp"
#include "interpreter/prioritized_control_torque.hpp"

namespace treeline::interpreter {

/// Tasks of a robot that stands on constraints and has joints without a motor.
template <class Scalar>
struct SupportedTask {
  Points<Scalar> constraints, points;
  std::vector<int> passive;  ///< velocities without a motor
  Vector<Scalar> qdd_0, xdd_cmd;
  Vector<Scalar> f_wanted;  ///< by held row
  Points<Scalar> external_points = {};
  Vector<Scalar> f_ext = {};
  Loops<Scalar> loops = {};    ///< held too: their rows follow those of the constraints
  Vector<Scalar> shares = {};  ///< 0 to 1, to which held rows are held; empty: 1
};

template <class Scalar>
struct SupportedTorque {
  Vector<Scalar> tau;  ///< zero at passive joints
  Vector<Scalar> f;    ///< by held row, on the robot
};

namespace detail {

/// Lever arm at which a moment counts like a force when forces of constraints are chosen, m.
inline constexpr double kForceLever = 0.1;

/// Weights of the rows of forces that are chosen: 1, or the lever squared for a moment.
template <class Scalar>
Vector<Scalar> force_weights(const Points<Scalar>& constraints) {
  std::vector<Scalar> weights;
  for (const auto& point : constraints) {
    for (std::size_t row = 0; row < 6; ++row) {
      if (point.rows[row]) weights.emplace_back(row < 3 ? 1.0 : kForceLever * kForceLever);
    }
  }
  return Eigen::Map<const Vector<Scalar>>(weights.data(),
                                          static_cast<Eigen::Index>(weights.size()));
}

/// Likewise of all held rows of a task, times their shares. A coupling's row counts like a force.
template <class Scalar>
Vector<Scalar> held_weights(const SupportedTask<Scalar>& task) {
  Points<Scalar> points = task.constraints;
  for (const auto& loop : task.loops.frames) points.push_back(loop.second);
  const auto couplings = static_cast<Eigen::Index>(task.loops.couplings.size());
  const auto weights =
      joined<Scalar>(force_weights<Scalar>(points), Vector<Scalar>::Ones(couplings));
  return task.shares.size() == 0 ? weights : Vector<Scalar>(weights.cwiseProduct(task.shares));
}

template <class Scalar>
Eigen::Index held_count(const SupportedTask<Scalar>& task) {
  return row_count<Scalar>(task.constraints) + row_count<Scalar>(task.loops);
}

/// A supported task at a state as matrices. Rows are those of the constraints, then those of the
/// tasks in order of priority.
template <class Scalar>
struct SupportedRows {
  SupportedRows(const Model<Scalar>& model, const SupportedTask<Scalar>& task, VectorArg<Scalar> q,
                VectorArg<Scalar> qd)
      : held(held_count(task)) {
    const Matrix<Scalar> J_s = held_jacobian<Scalar>(model, task.constraints, task.loops, q);
    const Matrix<Scalar> J_t = jacobian<Scalar>(model, task.points, q);
    const Vector<Scalar> of_tasks =
        task.xdd_cmd - bias_acceleration<Scalar>(model, task.points, q, qd);
    const auto order = rows_by_priority<Scalar>(task.points);
    J.resize(held + J_t.rows(), model.nv);
    asked.resize(J.rows());
    J.topRows(held) = J_s;
    if (held > 0) {
      asked.head(held) = -held_bias<Scalar>(model, task.constraints, task.loops, q, qd);
    }
    J.bottomRows(J_t.rows()) = J_t(order, Eigen::all);
    const TaskShares<Scalar> of_tasks_alone = task_shares<Scalar>(task.points);
    tasks.s = joined<Scalar>(Vector<Scalar>::Ones(held), of_tasks_alone.s(order));
    tasks.point.assign(static_cast<std::size_t>(held), -1);
    for (const int row : order) {
      tasks.point.push_back(of_tasks_alone.point[static_cast<std::size_t>(row)]);
    }
    asked.tail(J_t.rows()) = of_tasks(order);
    M = mass_matrix<Scalar>(model, q);
    bias = inverse_dynamics<Scalar>(model, q, qd, Vector<Scalar>::Zero(model.nv),
                                    task.external_points, task.f_ext);
    J_passive = J(Eigen::all, task.passive);
  }

  void leave_out(Eigen::Index row) {
    J.row(row).setZero();
    J_passive.row(row).setZero();
    asked(row) = Scalar(0);
  }

  Eigen::Index held;
  TaskShares<Scalar> tasks;  ///< to which tasks are done; 1 of held rows
  Matrix<Scalar> J, J_passive, M;
  Vector<Scalar> asked;  ///< accelerations of the rows less Jd qd
  Vector<Scalar> bias;   ///< b + g - J_ext^T f_ext
};

/// Torques and forces for accelerations: the forces nearest to those wanted, by `inverse` of
/// J_sp^T W J_sp, carry what no motor can.
template <class Scalar>
SupportedTorque<Scalar> torque_for(const SupportedRows<Scalar>& rows,
                                   const SupportedTask<Scalar>& task, const Vector<Scalar>& qdd,
                                   const Matrix<Scalar>& inverse) {
  const Vector<Scalar> gamma = rows.M * qdd + rows.bias;
  const Matrix<Scalar> J_sp = rows.J_passive.topRows(rows.held);
  SupportedTorque<Scalar> result;
  result.f = task.f_wanted;
  if (task.shares.size() > 0) result.f = result.f.cwiseProduct(task.shares);
  if (rows.held > 0 && !task.passive.empty()) {
    const Vector<Scalar> left = Vector<Scalar>(gamma(task.passive)) - J_sp.transpose() * result.f;
    const Vector<Scalar> change = J_sp * (inverse * left);
    result.f += held_weights<Scalar>(task).cwiseProduct(change);
  }
  result.tau = gamma;
  if (rows.held > 0) result.tau -= rows.J.topRows(rows.held).transpose() * result.f;
  for (const int v : task.passive) result.tau(v) = Scalar(0);
  return result;
}

}  // namespace detail

/// Joint forces of motors alone for a task while constraints hold, by the KKT system as a whole:
/// the qdd nearest to qdd_0 in the metric of M with
///     J_s qdd = -Jd_s qd,  J_t qdd = xdd_cmd - Jd_t qd,  P (M qdd + b + g) = J_sp^T f,
/// P: rows of passive joints. The task must be possible. Of the forces f those nearest to
/// `f_wanted` are taken, moments over 0.1 m, and tau = M qdd + b + g - J_s^T f. Rows with a share
/// of 0 are as if they were not there; what others do in part takes a law.
template <class Scalar>
SupportedTorque<Scalar> supported_control_torque(const Model<Scalar>& model,
                                                 const SupportedTask<Scalar>& task,
                                                 VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  detail::SupportedRows<Scalar> rows(model, task, q, qd);
  for (Eigen::Index i = 0; i < rows.J.rows(); ++i) {
    const bool is_held = i >= task.shares.size() || task.shares(i) != Scalar(0);
    if (!is_held || rows.tasks.s(i) == Scalar(0)) rows.leave_out(i);
  }
  const auto nv = rows.M.rows();
  const auto count = rows.J.rows();
  const auto passive = static_cast<Eigen::Index>(task.passive.size());
  // Unknown: qdd, f, and the multipliers of the rows and of the passive joints' equations.
  const auto size = nv + rows.held + count + passive;
  Matrix<Scalar> A = Matrix<Scalar>::Zero(size, size);
  Vector<Scalar> b(size);
  const Matrix<Scalar> M_passive = rows.M(task.passive, Eigen::all);
  const Matrix<Scalar> J_sp = rows.J_passive.topRows(rows.held);
  A.topLeftCorner(nv, nv) = rows.M;
  A.block(0, nv + rows.held, nv, count) = rows.J.transpose();
  A.block(nv + rows.held, 0, count, nv) = rows.J;
  A.block(0, size - passive, nv, passive) = M_passive.transpose();
  A.block(size - passive, 0, passive, nv) = M_passive;
  A.block(nv, size - passive, rows.held, passive) = -J_sp;
  A.block(size - passive, nv, passive, rows.held) = -J_sp.transpose();
  b << rows.M * task.qdd_0, Vector<Scalar>::Zero(rows.held), rows.asked,
      -Vector<Scalar>(rows.bias(task.passive));
  const Vector<Scalar> qdd = detail::solve_consistent<Scalar>(A, b).head(nv);
  const Vector<Scalar> weights = detail::held_weights<Scalar>(task);
  const Matrix<Scalar> D = J_sp.transpose() * weights.asDiagonal() * J_sp;
  Matrix<Scalar> inverse(passive, passive);
  if (rows.held > 0 && passive > 0) {
    for (Eigen::Index k = 0; k < passive; ++k) {
      // Only what J_sp^T f can be is ever multiplied by this inverse.
      inverse.col(k) = detail::solve_consistent<Scalar>(D, Vector<Scalar>::Unit(passive, k));
    }
  }
  return detail::torque_for(rows, task, qdd, inverse);
}

/// Laws of a supported control torque that relax rows that cannot be moved. The torque then has a
/// value also where the matrices of forces are singular. Constraints and tasks are rows of
/// Lambda^-1, less the mobility that tasks have by passive joints alone,
///     Lambda^-1 = J M^-1 J^T - (0, J_tp K_s^-1 J_tp^T),
///     K_s^-1 = K^-1 - K^-1 J_sp^T (J_sp K^-1 J_sp^T)^-1 J_sp K^-1,  K: block of M of passive
///     joints,
/// where `passive_moves`; else K_s^-1 is zero.
template <class Scalar>
struct SupportLaw {
  TaskLaw<Scalar> rows, locked, forces;
  bool passive_moves = false;
};

/// Parts of a law whose borders are those of all rows, of the constraints with motors locked if
/// passive joints can move then, and of the passive joints if anything is held.
template <class Scalar>
SupportLaw<Scalar> split_law(const TaskLaw<Scalar>& law, const SupportedTask<Scalar>& task) {
  const auto held = static_cast<std::ptrdiff_t>(detail::held_count(task));
  const auto rows = held + static_cast<std::ptrdiff_t>(row_count<Scalar>(task.points));
  const auto passive = static_cast<std::ptrdiff_t>(task.passive.size());
  const auto size = static_cast<std::ptrdiff_t>(law.borders.size());
  const std::ptrdiff_t locked = held > 0 ? size - rows - passive : 0;
  SupportLaw<Scalar> parts;
  parts.passive_moves = passive > 0 && (held == 0 || locked > 0);
  const auto first = law.borders.begin();
  for (auto* part : {&parts.rows, &parts.locked, &parts.forces}) part->power = law.power;
  parts.rows.borders.assign(first, first + rows);
  parts.locked.borders.assign(first + rows, first + rows + locked);
  parts.forces.borders.assign(first + rows + locked, law.borders.end());
  return parts;
}

/// K_s^-1 of `SupportLaw`.
template <class Scalar>
Matrix<Scalar> passive_mobility(const detail::SupportedRows<Scalar>& rows,
                                const SupportedTask<Scalar>& task, const SupportLaw<Scalar>& law) {
  const std::vector<int>& passive = task.passive;
  const Matrix<Scalar> K_inverse =
      inverse_of_positive_definite<Scalar>(Matrix<Scalar>(rows.M(passive, passive)));
  if (rows.held == 0) return K_inverse;
  const Matrix<Scalar> J_sp = rows.J_passive.topRows(rows.held);
  const Matrix<Scalar> carried = K_inverse * J_sp.transpose();
  const Matrix<Scalar> inverse =
      bordered_inverse<Scalar>(Matrix<Scalar>(J_sp * carried), law.locked, task.shares);
  return K_inverse - carried * inverse * carried.transpose();
}

/// Multipliers of all rows for what they lack: constraints held and tasks done to their shares.
template <class Scalar>
Vector<Scalar> forces_of_all_rows(const detail::SupportedRows<Scalar>& rows,
                                  const SupportedTask<Scalar>& task, const Matrix<Scalar>& A,
                                  const Vector<Scalar>& missing, const TaskLaw<Scalar>& law) {
  const Vector<Scalar>& s = rows.tasks.s;
  const Matrix<Scalar> Lambda =
      bordered_inverse<Scalar>(with_shares<Scalar>(A, rows.tasks), law, task.shares);
  return s.cwiseProduct(Lambda * s.cwiseProduct(missing));
}

template <class Scalar>
SupportedTorque<Scalar> supported_control_torque(const Model<Scalar>& model,
                                                 const SupportedTask<Scalar>& task,
                                                 VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                                 const SupportLaw<Scalar>& law) {
  const detail::SupportedRows<Scalar> rows(model, task, q, qd);
  const Matrix<Scalar> M_inverse = inverse_of_positive_definite<Scalar>(rows.M);
  const auto tasks = rows.J.rows() - rows.held;
  const auto passive = static_cast<Eigen::Index>(task.passive.size());
  Matrix<Scalar> A = rows.J * M_inverse * rows.J.transpose();
  Vector<Scalar> missing = rows.asked - rows.J * task.qdd_0;
  Vector<Scalar> qdd = task.qdd_0;
  if (law.passive_moves) {
    const Matrix<Scalar> K_s = passive_mobility(rows, task, law);
    const Matrix<Scalar> J_tp = rows.J_passive.bottomRows(tasks);
    A.bottomRightCorner(tasks, tasks) -= J_tp * K_s * J_tp.transpose();
    const Vector<Scalar> gamma_0 = rows.M * task.qdd_0 + rows.bias;
    const Vector<Scalar> balance = gamma_0(task.passive);
    missing.tail(tasks) += J_tp * (K_s * balance);
    const Vector<Scalar> f = forces_of_all_rows<Scalar>(rows, task, A, missing, law.rows);
    const Vector<Scalar> passive_motion =
        K_s * Vector<Scalar>(balance + J_tp.transpose() * f.tail(tasks));
    qdd += M_inverse * (rows.J.transpose() * f);
    for (Eigen::Index k = 0; k < passive; ++k) {
      qdd(task.passive[static_cast<std::size_t>(k)]) -= passive_motion(k);
    }
  } else {
    const Vector<Scalar> f = forces_of_all_rows<Scalar>(rows, task, A, missing, law.rows);
    qdd += M_inverse * (rows.J.transpose() * f);
  }
  Matrix<Scalar> inverse;
  if (rows.held > 0 && passive > 0) {
    const Matrix<Scalar> J_sp = rows.J_passive.topRows(rows.held);
    const Vector<Scalar> weights = detail::held_weights<Scalar>(task);
    inverse = bordered_inverse<Scalar>(
        Matrix<Scalar>(J_sp.transpose() * weights.asDiagonal() * J_sp), law.forces);
  }
  return detail::torque_for(rows, task, qdd, inverse);
}

}  // namespace treeline::interpreter
