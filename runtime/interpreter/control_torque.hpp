#pragma once

#include "interpreter/lambda_inverse.hpp"
#include "interpreter/point_accelerations.hpp"
#include "interpreter/prioritized_control_torque.hpp"
#include "interpreter/task_law.hpp"

namespace treeline::interpreter {

/// F = Lambda (xdd_cmd - Jd qd - J qdd_0): forces at the points, in their rows, that change the
/// accelerations due to the posture into the commanded ones (Chang eq. 6.3). Tasks that are done in
/// part: see `with_shares`.
template <class Scalar>
Vector<Scalar> task_force(const Model<Scalar>& model, PointsArg<Scalar> points, VectorArg<Scalar> q,
                          VectorArg<Scalar> qd, VectorArg<Scalar> qdd_0,
                          VectorArg<Scalar> xdd_cmd) {
  const Vector<Scalar> missing = xdd_cmd - point_accelerations<Scalar>(model, points, q, qd, qdd_0);
  const TaskShares<Scalar> shares = task_shares<Scalar>(points);
  const Matrix<Scalar> A = with_shares<Scalar>(lambda_inverse<Scalar>(model, points, q), shares);
  return shares.s.cwiseProduct(A.ldlt().solve(Vector<Scalar>(shares.s.cwiseProduct(missing))));
}

/// F = Lambda (xdd_cmd - Jd qd - J qdd_0), where `law` relaxes rows that cannot be moved. Lambda is
/// that of the law's own rows.
template <class Scalar>
Vector<Scalar> task_force(const Model<Scalar>& model, PointsArg<Scalar> points, VectorArg<Scalar> q,
                          VectorArg<Scalar> qd, VectorArg<Scalar> qdd_0, VectorArg<Scalar> xdd_cmd,
                          const TaskLaw<Scalar>& law) {
  const Vector<Scalar> missing = xdd_cmd - point_accelerations<Scalar>(model, points, q, qd, qdd_0);
  const Matrix<Scalar> T = law_rows<Scalar>(model, points, q, law);
  const TaskShares<Scalar> shares = task_shares<Scalar>(points);
  const Matrix<Scalar> A =
      with_shares<Scalar>(T * lambda_inverse<Scalar>(model, points, q) * T.transpose(), shares);
  const Vector<Scalar> lacking = T * shares.s.cwiseProduct(missing);
  return shares.s.cwiseProduct(T.transpose() * (bordered_inverse<Scalar>(A, law) * lacking));
}

/// tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext (Chang table 6.1), without a joint-space matrix: F
/// enters the inward recursion as a force at the points. `qdd_0` is the posture's acceleration; the
/// part that the task does not determine acts in the null space. For points that differ in priority
/// see `prioritized_control_torque`.
template <class Scalar>
Vector<Scalar> control_torque(const Model<Scalar>& model, PointsArg<Scalar> points,
                              VectorArg<Scalar> q, VectorArg<Scalar> qd, VectorArg<Scalar> qdd_0,
                              VectorArg<Scalar> xdd_cmd, PointsArg<Scalar> external_points,
                              VectorArg<Scalar> f_ext) {
  if (has_priorities(points)) {
    return prioritized_control_torque<Scalar>(model, points, q, qd, qdd_0, xdd_cmd, external_points,
                                              f_ext);
  }
  const Vector<Scalar> F = task_force<Scalar>(model, points, q, qd, qdd_0, xdd_cmd);
  const auto k = kinematics<Scalar>(model, q, qd);
  PerBody<Vector6<Scalar>> external(model.size(), Vector6<Scalar>::Zero());
  add_point_forces<Scalar>(model, external_points, k, f_ext, external);
  add_point_forces<Scalar>(model, points, k, -F, external);
  return detail::newton_euler<Scalar>(model, k, qdd_0, external) +
         joint_forces<Scalar>(model, q, qd);
}

/// Control torque with the task law `law`. If the law has pivots, tau = M qdd + b + g - J_ext^T
/// f_ext where qdd solves J qdd = xdd_cmd - Jd qd, which leaves no null space for the posture; but
/// for what a task done to the share s leaves, 1 - s^2 of qdd_0.
template <class Scalar>
Vector<Scalar> control_torque(const Model<Scalar>& model, PointsArg<Scalar> points,
                              VectorArg<Scalar> q, VectorArg<Scalar> qd, VectorArg<Scalar> qdd_0,
                              VectorArg<Scalar> xdd_cmd, PointsArg<Scalar> external_points,
                              VectorArg<Scalar> f_ext, const TaskLaw<Scalar>& law) {
  if (has_priorities(points)) {
    return prioritized_control_torque<Scalar>(model, points, q, qd, qdd_0, xdd_cmd, external_points,
                                              f_ext, law.borders);
  }
  if (!law.pivots.empty()) {
    const Matrix<Scalar> T = law_rows<Scalar>(model, points, q, law);
    const Vector<Scalar> wanted = T * (xdd_cmd - bias_acceleration<Scalar>(model, points, q, qd));
    const Scalar done = points.front().share * points.front().share;
    const Vector<Scalar> qdd =
        done * solve_by_pivots<Scalar>(T * jacobian<Scalar>(model, points, q), wanted, law) +
        (Scalar(1) - done) * qdd_0;
    return inverse_dynamics<Scalar>(model, q, qd, qdd, external_points, f_ext);
  }
  const Vector<Scalar> F = task_force<Scalar>(model, points, q, qd, qdd_0, xdd_cmd, law);
  const auto k = kinematics<Scalar>(model, q, qd);
  PerBody<Vector6<Scalar>> external(model.size(), Vector6<Scalar>::Zero());
  add_point_forces<Scalar>(model, external_points, k, f_ext, external);
  add_point_forces<Scalar>(model, points, k, -F, external);
  return detail::newton_euler<Scalar>(model, k, qdd_0, external) +
         joint_forces<Scalar>(model, q, qd);
}

/// Control torque without external forces.
template <class Scalar>
Vector<Scalar> control_torque(const Model<Scalar>& model, PointsArg<Scalar> points,
                              VectorArg<Scalar> q, VectorArg<Scalar> qd, VectorArg<Scalar> qdd_0,
                              VectorArg<Scalar> xdd_cmd) {
  return control_torque<Scalar>(model, points, q, qd, qdd_0, xdd_cmd, {}, Vector<Scalar>());
}

}  // namespace treeline::interpreter
