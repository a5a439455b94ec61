#pragma once

#include <vector>

#include "recursion/methods/eliminated_forward_dynamics.hpp"
#include "recursion/methods/supported_control_torque.hpp"

namespace treeline {

/// J (1, G): what the independent velocities move while the others follow.
template <class Scalar>
DenseMatrix<Scalar> permitted_rows(const DenseMatrix<Scalar>& J, const DenseMatrix<Scalar>& G,
                                   const LoopedVelocities& looped) {
  DenseMatrix<Scalar> rows(J.rows(), looped.independent.size());
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    for (std::size_t i = 0; i < rows.cols(); ++i) {
      rows(r, i) = J(r, looped.independent[i]);
      for (std::size_t d = 0; d < G.rows(); ++d) {
        rows(r, i) = rows(r, i) + J(r, looped.dependent[d]) * G(d, i);
      }
    }
  }
  return rows;
}

/// Rates that dependent velocities lack at qdd_0 to follow the others: G qdd_0I + S c - qdd_0D.
template <class Scalar>
std::vector<Scalar> lacking_at(const JointRates<Scalar>& rates, const LoopRows<Scalar>& loops,
                               const LoopedRates<Scalar>& follow, const LoopedVelocities& looped) {
  std::vector<Scalar> c;
  for (const std::size_t row : looped.rows) c.push_back(-loops.bias[row]);
  std::vector<Scalar> lacking = follow.led_by(c);
  for (std::size_t d = 0; d < lacking.size(); ++d) {
    for (std::size_t i = 0; i < looped.independent.size(); ++i) {
      lacking[d] = lacking[d] + follow.G(d, i) * rates.acceleration(looped.independent[i]);
    }
    lacking[d] = lacking[d] - rates.acceleration(looped.dependent[d]);
  }
  return lacking;
}

/// The columns of A that belong to dependent velocities, times x, subtracted from b.
template <class Scalar>
std::vector<Scalar> less_dependent(std::vector<Scalar> b, const DenseMatrix<Scalar>& A,
                                   const std::vector<Scalar>& x, const LoopedVelocities& looped) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t d = 0; d < x.size(); ++d) b[i] = b[i] - A(i, looped.dependent[d]) * x[d];
  }
  return b;
}

/// The torques of `supported_control_torque` where rows of loops alone hold the robot and determine
/// every passive velocity, with these eliminated. With r_D = G qdd_0I + S c - qdd_0D, what the
/// motion differs from qdd_0 is (1, G) y + (0, r_D), and
///     M_s y = J_c^T f_t - (1, G^T) M r,  J_c M_s^-1 J_c^T f_t = the rest of the task's error,
///     tau_I = (1, G^T) gamma_0 + J_c^T f_t,  f = S^T (gamma_0 + M ((1, G) y + r))_D,
/// gamma_0 = M qdd_0 + b + g - J_ext^T f_ext, J_c = J_t (1, G). `rule` inverts pivots of the tasks,
/// which are those that Lambda^-1 has after the rows of the loops.
template <class Scalar>
SupportedTorque<Scalar> eliminated_control_torque(const Tree<Scalar>& tree,
                                                  const std::vector<JointTransform<Scalar>>& X,
                                                  const SupportedInputs<Scalar>& inputs,
                                                  const LoopedVelocities& looped,
                                                  const PivotRule& rule) {
  const auto motions = outward_motion(tree, X, inputs.rates, -tree.gravity);
  const auto of_rows = motions_of_rows(tree, X, motions, inputs.rates.qd, -tree.gravity);
  const auto poses = world_poses(tree, X);
  const auto tasks = task_points(tree, {}, poses);
  const auto gamma = inverse_dynamics<Scalar>(tree, X, inputs.rates, inputs.applied);
  const auto loops = loop_rows<Scalar>(tree, X, {}, inputs.rates.qd);
  const auto follow = rates_of(loops.J, looped);
  const auto M = mass_matrix(tree, X);
  const auto reduced = reduce_inertia(M, follow.G, looped);
  const auto factor = factor_ltdl(reduced.M_s);
  const auto r = lacking_at(inputs.rates, loops, follow, looped);

  const std::vector<Scalar> wanted(inputs.xdd_cmd.begin(), inputs.xdd_cmd.end());
  const auto J = jacobian_inward(tree, X, tasks, wanted.size(), poses);
  const auto J_c = permitted_rows(J, follow.G, looped);
  auto drive = projected(less_dependent(std::vector<Scalar>(M.rows(), Scalar(0.0)), M, r, looped),
                         follow.G, looped);
  auto errors = less_dependent(supported_errors(tree, X, tasks, of_rows, wanted), J, r, looped);
  const auto freely = solve(factor, drive);
  for (std::size_t row = 0; row < errors.size(); ++row) {
    for (std::size_t i = 0; i < freely.size(); ++i) {
      errors[row] = errors[row] - J_c(row, i) * freely[i];
    }
  }
  const auto f_t = solve(factor_ldlt(inverse_inertia_in_rows(factor, J_c), rule), errors);
  const auto asked = transposed_times(J_c, f_t);
  for (std::size_t i = 0; i < drive.size(); ++i) drive[i] = drive[i] + asked[i];

  SupportedTorque<Scalar> result{std::vector<Scalar>(gamma.size(), Scalar(0.0)),
                                 std::vector<Scalar>(loops.J.rows(), Scalar(0.0))};
  const auto tau = projected(gamma, follow.G, looped);
  for (std::size_t i = 0; i < tau.size(); ++i) {
    result.tau[looped.independent[i]] = tau[i] + asked[i];
  }
  auto minus_r = r;
  for (Scalar& each : minus_r) each = -each;
  const auto inertial = less_dependent(gamma, M, minus_r, looped);
  std::vector<Scalar> carried;
  for (const std::size_t d : looped.dependent) carried.push_back(inertial[d]);
  const auto f = follow.forces_for(plus_product(carried, reduced.N, solve(factor, drive)));
  for (std::size_t k = 0; k < f.size(); ++k) result.f[looped.rows[k]] = f[k];
  return result;
}

}  // namespace treeline
