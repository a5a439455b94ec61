#pragma once

#include <vector>

#include "recursion/methods/constrained_forward_dynamics.hpp"
#include "recursion/methods/mass_matrix.hpp"
#include "recursion/methods/passive_joints.hpp"

namespace treeline {

template <class Scalar>
struct SupportedInputs {
  JointRates<Scalar> rates;          ///< qd, qdd_0
  std::span<const Scalar> xdd_cmd;   ///< by row of the tasks, in the order of the tree's points
  std::span<const Scalar> f_wanted;  ///< by row of the constraints
  std::vector<Wrench<Scalar>> applied;
  std::vector<Scalar> shares = {};  ///< to which rows of constraints are held; empty: 1
};

/// Joint forces, zero at passive joints, and the forces of the constraints on the robot.
template <class Scalar>
struct SupportedTorque {
  std::vector<Scalar> tau, f;
};

/// The columns of J that belong to passive joints.
template <class Scalar>
DenseMatrix<Scalar> passive_columns(const Tree<Scalar>& tree,
                                    const std::vector<JointTransform<Scalar>>& X,
                                    const std::vector<TaskPoint<Scalar>>& tasks,
                                    const LambdaChoice& choice, const std::vector<int>& passive,
                                    std::size_t rows) {
  const auto poses = world_poses(tree, X);
  return columns_of(choice.route == LambdaRoute::factors_world && choice.basis.axes_link < 0
                        ? jacobian_world(tree, poses, {}, rows)
                        : jacobian_inward(tree, X, tasks, rows, poses),
                    passive);
}

/// Accelerations that the rows lack at qdd_0: -Jd qd - J qdd_0 of constraints, xdd_cmd - Jd qd - J
/// qdd_0 of tasks. `of_rows` are those of `motions_of_rows`, without gravity.
template <class Scalar>
std::vector<Scalar> supported_errors(const Tree<Scalar>& tree,
                                     const std::vector<JointTransform<Scalar>>& X,
                                     const std::vector<TaskPoint<Scalar>>& tasks,
                                     const std::vector<LinkMotion<Scalar>>& of_rows,
                                     const std::vector<Scalar>& wanted) {
  std::vector<Scalar> errors;
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const TreePoint<Scalar>& point = tree.operational_points[k];
    const auto error =
        asked_acceleration_error(tree, X, point, tasks[k], of_rows[k],
                                 std::span<const Scalar>(wanted).subspan(errors.size()));
    errors.insert(errors.end(), error.begin(), error.end());
  }
  return errors;
}

/// x with J_p^T f added, of the rows from `first` on.
template <class Scalar>
std::vector<Scalar> with_row_forces(const DenseMatrix<Scalar>& J, std::vector<Scalar> x,
                                    const std::vector<Scalar>& f, std::size_t first = 0) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    for (std::size_t i = first; i < f.size(); ++i) x[k] = x[k] + J(i, k) * f[i];
  }
  return x;
}

/// The forces nearest to `wanted`, moments over `kForceLever`, with J_p^T f = `balance`. The less a
/// row is held, the less it carries of both.
template <class Scalar>
std::vector<Scalar> choose_support_forces(const DenseMatrix<Scalar>& J, std::vector<Scalar> weights,
                                          std::vector<Scalar> balance,
                                          const SupportedInputs<Scalar>& inputs,
                                          const PivotRule& rule) {
  std::vector<Scalar> f(inputs.f_wanted.begin(), inputs.f_wanted.end());
  for (std::size_t i = 0; i < inputs.shares.size(); ++i) {
    f[i] = inputs.shares[i] * f[i];
    weights[i] = inputs.shares[i] * weights[i];
  }
  if (f.empty() || balance.empty()) return f;
  for (std::size_t k = 0; k < balance.size(); ++k) {
    for (std::size_t i = 0; i < f.size(); ++i) balance[k] = balance[k] - J(i, k) * f[i];
  }
  const auto y = solve(factor_ldlt(weighted_square(J, weights, f.size()), rule), balance);
  for (std::size_t i = 0; i < f.size(); ++i) {
    Scalar change(0.0);
    for (std::size_t k = 0; k < y.size(); ++k) change = change + J(i, k) * y[k];
    f[i] = f[i] + weights[i] * change;
  }
  return f;
}

/// A supported task at a state. Rows are those of the constraints, then those of the tasks.
template <class Scalar>
struct SupportedRows {
  std::vector<TaskPoint<Scalar>> tasks;
  DenseMatrix<Scalar> all;         ///< J of all rows, only where loops are held
  std::vector<Scalar> errors;      ///< what the rows lack at qdd_0
  DenseMatrix<Scalar> Lambda_inv;  ///< J M^-1 J^T
  TaskShares<Scalar> shares;       ///< to which tasks are done
  DenseMatrix<Scalar> J;           ///< columns of passive joints
  std::vector<Scalar> gamma;       ///< M qdd + b + g - J_ext^T f_ext, at qdd_0 at first
  std::vector<Scalar> balance;     ///< gamma of passive joints, which constraints must carry
};

/// Puts what the rows of loops lack behind the first `anchored` rows, and forms J of all rows.
template <class Scalar>
void add_loops(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
               const JointRates<Scalar>& rates, std::size_t anchored, SupportedRows<Scalar>& rows) {
  const auto loops = loop_rows<Scalar>(tree, X, {}, rates.qd);
  std::vector<Scalar> errors;
  for (std::size_t i = 0; i < loops.bias.size(); ++i) {
    Scalar lacks = -loops.bias[i];
    for (std::size_t v = 0; v < loops.J.cols(); ++v) {
      lacks = lacks - loops.J(i, v) * rates.acceleration(v);
    }
    errors.push_back(lacks);
  }
  rows.errors.insert(rows.errors.begin() + static_cast<std::ptrdiff_t>(anchored), errors.begin(),
                     errors.end());
  rows.all = jacobian_with_loops(tree, X, rows.tasks, anchored, loops.J);
}

template <class Scalar>
SupportedRows<Scalar> supported_rows(const Tree<Scalar>& tree,
                                     const std::vector<JointTransform<Scalar>>& X,
                                     const SupportedInputs<Scalar>& inputs,
                                     const std::vector<int>& passive, const LambdaChoice& choice,
                                     std::size_t held) {
  const auto motions = outward_motion(tree, X, inputs.rates, -tree.gravity);
  const std::size_t anchored = held - count_loop_rows(tree);
  std::vector<Scalar> wanted(anchored, Scalar(0.0));
  wanted.insert(wanted.end(), inputs.xdd_cmd.begin(), inputs.xdd_cmd.end());
  SupportedRows<Scalar> rows;
  rows.shares = TaskShares<Scalar>(tree, anchored, held - anchored);
  rows.tasks = task_points(tree, {}, world_poses(tree, X));
  const auto of_rows = motions_of_rows(tree, X, motions, inputs.rates.qd, -tree.gravity);
  rows.errors = supported_errors(tree, X, rows.tasks, of_rows, wanted);
  if (has_loops(tree)) {
    add_loops(tree, X, inputs.rates, anchored, rows);
    rows.Lambda_inv = lambda_inverse_by_factors(tree, X, rows.all);
    rows.J = columns_of(rows.all, passive);
  } else {
    rows.Lambda_inv = lambda_inverse_as_asked(tree, X, choice, wanted.size());
    rows.J = passive_columns(tree, X, rows.tasks, choice, passive, wanted.size());
  }
  auto wrenches = inertial_wrenches(tree, motions);
  for (std::size_t i = 0; i < inputs.applied.size(); ++i) {
    wrenches[i] = wrenches[i] - inputs.applied[i];
  }
  rows.gamma = inward_forces(tree, X, std::move(wrenches));
  add_drive_forces(tree, X, inputs.rates, rows.gamma);
  for (const int v : passive) rows.balance.push_back(rows.gamma[static_cast<std::size_t>(v)]);
  return rows;
}

/// Multipliers of all rows: constraints held to `shares`, tasks done to those of their points.
template <class Scalar>
std::vector<Scalar> forces_of_all_rows(const SupportedRows<Scalar>& rows, const SupportRules& rules,
                                       const std::vector<Scalar>& shares) {
  const TaskShares<Scalar>& of_tasks = rows.shares;
  return of_tasks.times(solve(factor_shared(of_tasks.weakened(rows.Lambda_inv), rules.rows, shares),
                              of_tasks.times(rows.errors)));
}

/// Multipliers of the rows where the constraints can push every passive joint. `rows.balance`
/// becomes that of the motion.
template <class Scalar>
std::vector<Scalar> multipliers_on_supports(SupportedRows<Scalar>& rows, const SupportRules& rules,
                                            const std::vector<Scalar>& shares) {
  auto f = forces_of_all_rows(rows, rules, shares);
  rows.balance = with_row_forces(rows.J, rows.balance, f);
  return f;
}

/// Multipliers of the rows where passive joints can move by themselves. `rows.gamma` and
/// `rows.balance` gain the part of the motion that is no force of a row.
template <class Scalar>
std::vector<Scalar> multipliers_with_passive_motion(SupportedRows<Scalar>& rows,
                                                    const DenseMatrix<Scalar>& M,
                                                    const std::vector<int>& passive,
                                                    const SupportRules& rules,
                                                    const std::vector<Scalar>& shares) {
  const PassiveMotion<Scalar> motion(block_of_velocities(M, passive), rows.J, rules, shares);
  motion.subtract_from(rows.Lambda_inv);
  const auto passive_motion = motion.solve_for(rows.balance);
  for (std::size_t i = rules.held; i < rows.errors.size(); ++i) {
    for (std::size_t k = 0; k < passive_motion.size(); ++k) {
      rows.errors[i] = rows.errors[i] + rows.J(i, k) * passive_motion[k];
    }
  }
  auto f = forces_of_all_rows(rows, rules, shares);
  const auto change = motion.solve_for(with_row_forces(rows.J, rows.balance, f, rules.held));
  rows.balance = with_row_forces(rows.J, rows.balance, f);
  const auto columns = columns_of(M, passive);
  for (std::size_t k = 0; k < change.size(); ++k) {
    for (std::size_t i = 0; i < rows.gamma.size(); ++i) {
      rows.gamma[i] = rows.gamma[i] - columns(i, k) * change[k];
    }
    for (std::size_t i = 0; i < passive.size(); ++i) {
      rows.balance[i] =
          rows.balance[i] - columns(static_cast<std::size_t>(passive[i]), k) * change[k];
    }
  }
  return f;
}

/// Joint forces of motors alone for a task while constraints hold their rows. The points of `tree`
/// are the constraints, then the tasks in order of priority. With gamma = M qdd + b + g - J_ext^T
/// f_ext, qdd is the one nearest to qdd_0 in the metric of M with
///     J_s qdd + Jd_s qd = 0,  J_t qdd + Jd_t qd = xdd_cmd,  gamma_p = J_sp^T f for some f,
/// p: passive joints. Its multipliers solve one system, in which tasks have lost the mobility that
/// passive joints alone give them:
///     Lambda^-1 = J M^-1 J^T - (0, J_tp K_s^-1 J_tp^T),  K_s^-1: see `PassiveMotion`.
/// Where the constraints can push every passive joint (two feet and a floating base), K_s^-1 is
/// zero. Of the forces f with gamma_p = J_sp^T f those nearest to `f_wanted` are taken, and tau =
/// gamma - J_s^T f. Rows that are held in part have compliances in both systems, see
/// `SharedPivots`, and carry a part of the forces; then passive joints must be able to move.
/// (Sentis & Khatib 2005; Righetti et al. 2011.)
template <class Scalar>
SupportedTorque<Scalar> supported_control_torque(const Tree<Scalar>& tree,
                                                 const std::vector<JointTransform<Scalar>>& X,
                                                 const SupportedInputs<Scalar>& inputs,
                                                 const std::vector<int>& passive,
                                                 const LambdaChoice& choice,
                                                 const SupportRules& rules) {
  auto rows = supported_rows(tree, X, inputs, passive, choice, rules.held);
  auto f = rules.passive_moves ? multipliers_with_passive_motion(rows, mass_matrix(tree, X),
                                                                 passive, rules, inputs.shares)
                               : multipliers_on_supports(rows, rules, inputs.shares);
  SupportedTorque<Scalar> result;
  const std::size_t anchored = rules.held - count_loop_rows(tree);
  result.f = choose_support_forces(rows.J, held_weights(tree, anchored), rows.balance, inputs,
                                   rules.forces);
  for (std::size_t i = 0; i < rules.held; ++i) f[i] = f[i] - result.f[i];
  result.tau =
      has_loops(tree) ? transposed_times(rows.all, f) : forces_of_rows(tree, X, rows.tasks, f);
  for (std::size_t i = 0; i < rows.gamma.size(); ++i) result.tau[i] = result.tau[i] + rows.gamma[i];
  for (const int v : passive) result.tau[static_cast<std::size_t>(v)] = Scalar(0.0);
  return result;
}

}  // namespace treeline
