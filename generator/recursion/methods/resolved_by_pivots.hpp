#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "recursion/methods/resolved_acceleration.hpp"
#include "recursion/methods/task_law.hpp"

namespace treeline {

/// Block of J with three rows and three columns.
template <class Scalar>
DenseMatrix<Scalar> block_of(const DenseMatrix<Scalar>& J, std::size_t row, std::size_t column) {
  DenseMatrix<Scalar> block(3, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      block(i, j) = J(row + i, column + j);
    }
  }
  return block;
}

/// J at the wrist's centre in the axes of `link`.
template <class Scalar>
DenseMatrix<Scalar> wrist_jacobian(const Tree<Scalar>& tree,
                                   const std::vector<JointTransform<Scalar>>& X, int link) {
  return jacobian_world(tree, poses_seen_from(tree, X, link), {false, true, link}, 6);
}

/// Solves A x = v by elimination in the order of `pivots`, whose reciprocals `invert` gives. An
/// unknown with an equation of its own is substituted into the others as soon as it is known. So
/// the others account for its true value, even if it is relaxed.
template <class Scalar, class Invert>
std::vector<Scalar> eliminate(DenseMatrix<Scalar> A, std::vector<Scalar> v,
                              const std::vector<Pivot>& pivots, const Invert& invert) {
  const std::size_t n = pivots.size();
  const Scalar zero(0.0);
  std::vector<Scalar> inverse(n), x(n);
  std::vector<bool> known(n, false);
  for (std::size_t k = 0; k < n; ++k) {
    const auto [r, c] = pivots[k];
    inverse[k] = invert(k, A(r, c));
    bool alone = true;
    for (std::size_t l = k + 1; l < n; ++l) {
      alone = alone && A(r, pivots[l].column) == zero;
    }
    known[k] = alone;
    if (alone) x[c] = inverse[k] * v[r];
    for (std::size_t l = k + 1; l < n; ++l) {
      const std::size_t i = pivots[l].row;
      if (A(i, c) == zero) continue;
      if (alone) {
        v[i] = v[i] - A(i, c) * x[c];
        continue;
      }
      const Scalar factor = A(i, c) * inverse[k];
      v[i] = v[i] - factor * v[r];
      for (std::size_t m = k + 1; m < n; ++m) {
        const std::size_t j = pivots[m].column;
        A(i, j) = A(i, j) - factor * A(r, j);
      }
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    if (known[k]) continue;
    const auto [r, c] = pivots[k];
    Scalar rest = v[r];
    for (std::size_t l = k + 1; l < n; ++l) {
      rest = rest - A(r, pivots[l].column) * x[pivots[l].column];
    }
    x[c] = inverse[k] * rest;
  }
  return x;
}

/// Accelerations of an arm's first three joints for the acceleration v of its wrist. The linear
/// rows of J come first, in the axes of `law.basis`; only the first joint moves row `lone_row`. In
/// the plane of the other two rows, the component across the third joint's column gives the second
/// joint, and the component along it gives the third. So no pivot is a difference that could vanish
/// at a pose where the arm is not singular, and the law does not depend on the axes.
template <class Scalar>
std::vector<Scalar> solve_arm(const DenseMatrix<Scalar>& J, std::vector<Scalar> v,
                              const TaskLaw& law) {
  const auto [lone, a, b] = law.arm.rows();
  const Scalar first = law.rule(0, J(lone, 0)) * v[lone];
  const Scalar va = v[a] - J(a, 0) * first;
  const Scalar vb = v[b] - J(b, 0) * first;
  const Scalar across = J(a, 1) * J(b, 2) - J(b, 1) * J(a, 2);
  const Scalar second = law.rule(2, across) * (va * J(b, 2) - vb * J(a, 2));
  const Scalar along = (va - J(a, 1) * second) * J(a, 2) + (vb - J(b, 1) * second) * J(b, 2);
  return {first, second, along * Scalar(law.arm.inverse_square)};
}

/// Control torque as in `control_torque_by_resolved_acceleration`, with pivots that may be relaxed:
/// `solve_arm` first, then the wrist's joints in the axes of `law.angular_axes_link`, in which
/// their columns are mostly constant, in the order of the law's last three pivots. At the overhead,
/// elbow and wrist singularities one pivot vanishes and one direction is relaxed.
template <class Scalar>
std::vector<Scalar> control_torque_by_pivots(const Tree<Scalar>& tree,
                                             const std::vector<JointTransform<Scalar>>& X,
                                             const ControlInputs<Scalar>& inputs,
                                             const TaskLaw& law) {
  const TaskBasis& basis = law.basis;
  const TreePoint<Scalar>& point = tree.operational_points.front();
  const auto motions = outward_motion(tree, X, {inputs.rates.qd, {}}, -tree.gravity);
  const auto of_rows = motions_of_rows(tree, X, motions, inputs.rates.qd, -tree.gravity);
  const auto poses = poses_seen_from(tree, X, basis.axes_link);
  const auto error = acceleration_error(tree, X, point, task_point(point, basis, poses), basis,
                                        of_rows.front(), inputs.xdd_cmd);
  const auto J = jacobian_world(tree, poses, basis, 6);
  const auto arm = solve_arm(J, {error[0], error[1], error[2]}, law);
  Vector3<Scalar> rest{error[3], error[4], error[5]};
  for (std::size_t j = 0; j < 3; ++j) {
    rest = rest - Vector3<Scalar>{J(3, j), J(4, j), J(5, j)} * arm[j];
  }
  for (int i = basis.axes_link + 1; i <= law.angular_axes_link; ++i) {
    rest = X[static_cast<std::size_t>(i)].to_child(rest);
  }
  const std::vector<Pivot> last(law.pivots.begin() + 3, law.pivots.end());
  const auto wrist = eliminate(
      block_of(wrist_jacobian(tree, X, law.angular_axes_link), 3, 3), {rest.x, rest.y, rest.z},
      last, [&law](std::size_t k, const Scalar& c) { return law.rule(k + 3, c); });
  const auto qdd = shared_with_posture(
      point, {arm[0], arm[1], arm[2], wrist[0], wrist[1], wrist[2]}, inputs.rates);
  return inverse_dynamics<Scalar>(tree, X, {inputs.rates.qd, qdd}, inputs.applied);
}

}  // namespace treeline
