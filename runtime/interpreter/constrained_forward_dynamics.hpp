#pragma once

#include <Eigen/QR>
#include <limits>

#include "interpreter/derivatives.hpp"
#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/jacobian.hpp"
#include "interpreter/loops.hpp"
#include "interpreter/mass_matrix.hpp"
#include "interpreter/point_accelerations.hpp"
#include "interpreter/task_law.hpp"

namespace treeline::interpreter {

/// State and drive of a robot whose constraints hold the rows of some points, and then those of
/// loops.
template <class Scalar>
struct ConstrainedState {
  Vector<Scalar> q, qd, tau;
  Vector<Scalar> drift;                 ///< by held row of the points; empty: none
  Scalar damping = Scalar(0);           ///< 1/s
  Scalar stiffness = Scalar(0);         ///< 1/s^2
  Points<Scalar> external_points = {};  ///< where external forces act
  Vector<Scalar> f_ext = {};
  Loops<Scalar> loops = {};
  Scalar step = Scalar(0);     ///< s, at whose end friction and springs are taken
  Vector<Scalar> shares = {};  ///< 0 to 1, to which rows are held; empty: 1
};

template <class Scalar>
struct ConstrainedMotion {
  Vector<Scalar> qdd;
  Vector<Scalar> f;  ///< by held row, on the robot
};

namespace detail {

/// The least-norm solution of a linear system that has solutions, however many.
template <class Scalar>
Vector<Scalar> solve_consistent(const Matrix<Scalar>& A, const Vector<Scalar>& b) {
  using std::sqrt;
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Eigen::CompleteOrthogonalDecomposition<Dense> decomposition(A.rows(), A.cols());
  decomposition.setThreshold(Scalar(sqrt(std::numeric_limits<Scalar>::epsilon())));
  decomposition.compute(Dense(A));
  return decomposition.solve(b);
}

template <class Scalar>
Vector<Scalar> joined(const Vector<Scalar>& head, const Vector<Scalar>& tail) {
  Vector<Scalar> both(head.size() + tail.size());
  both << head, tail;
  return both;
}

/// J of the rows of points, then of loops.
template <class Scalar>
Matrix<Scalar> held_jacobian(const Model<Scalar>& model, const Points<Scalar>& constraints,
                             const Loops<Scalar>& loops, const Vector<Scalar>& q) {
  const Matrix<Scalar> of_points = jacobian<Scalar>(model, constraints, q);
  if (loops.empty()) return of_points;
  Matrix<Scalar> J(of_points.rows() + row_count(loops), model.nv);
  J << of_points, loop_jacobian<Scalar>(model, loops, q);
  return J;
}

/// Jd qd of the same rows.
template <class Scalar>
Vector<Scalar> held_bias(const Model<Scalar>& model, const Points<Scalar>& constraints,
                         const Loops<Scalar>& loops, const Vector<Scalar>& q,
                         const Vector<Scalar>& qd) {
  const Vector<Scalar> of_points = bias_acceleration<Scalar>(model, constraints, q, qd);
  if (loops.empty()) return of_points;
  return joined<Scalar>(of_points, loop_bias<Scalar>(model, loops, q, qd));
}

/// Accelerations of the held rows that are asked for, less Jd qd.
template <class Scalar>
Vector<Scalar> held_accelerations(const Model<Scalar>& model, const Points<Scalar>& constraints,
                                  const Matrix<Scalar>& J, const ConstrainedState<Scalar>& at) {
  Vector<Scalar> asked = -held_bias<Scalar>(model, constraints, at.loops, at.q, at.qd);
  asked -= at.damping * (J * at.qd);
  if (at.drift.size() > 0) asked.head(at.drift.size()) -= at.stiffness * at.drift;
  if (!at.loops.empty()) {
    asked.tail(row_count(at.loops)) -= at.stiffness * loop_errors<Scalar>(model, at.loops, at.q);
  }
  return asked;
}

/// tau - b - g + J_ext^T f_ext, with springs at the end of the step.
template <class Scalar>
Vector<Scalar> net_forces(const Model<Scalar>& model, const ConstrainedState<Scalar>& at) {
  const Vector<Scalar> rest = Vector<Scalar>::Zero(model.nv);
  const Vector<Scalar> net =
      at.tau - inverse_dynamics<Scalar>(model, at.q, at.qd, rest, at.external_points, at.f_ext);
  if (at.step == Scalar(0)) return net;
  return net - implicit_drives<Scalar>(model, at.q, at.qd, at.step).force;
}

/// M, with friction and springs at the end of the step.
template <class Scalar>
Matrix<Scalar> stepped_mass_matrix(const Model<Scalar>& model, const ConstrainedState<Scalar>& at) {
  const Matrix<Scalar> M = mass_matrix<Scalar>(model, at.q);
  if (at.step == Scalar(0)) return M;
  return M + implicit_drives<Scalar>(model, at.q, at.qd, at.step).inertia;
}

}  // namespace detail

/// Motion with the rows of the constraints held, by the KKT system of Gauss' principle as a whole:
///     [M  -J^T] [qdd]   [tau - b - g + J_ext^T f_ext        ]
///     [J    0 ] [ f ] = [-Jd qd - damping J qd - stiffness drift].
/// With a step, M + step D + step^2 K stands in for M and step K qd is
/// added to g. If rows depend on each other, the acceleration is still unique, and of all forces
/// the least are taken. Rows that are held to a share w have the last equation times w, with
/// (1 - w) diag(J M^-1 J^T) f added on the left.
template <class Scalar>
ConstrainedMotion<Scalar> constrained_forward_dynamics(
    const Model<Scalar>& model, PointsArg<Scalar> constraints,
    const ConstrainedState<std::type_identity_t<Scalar>>& at) {
  const Matrix<Scalar> J = detail::held_jacobian<Scalar>(model, constraints, at.loops, at.q);
  const auto rows = J.rows();
  const auto nv = static_cast<Eigen::Index>(model.nv);
  Matrix<Scalar> A = Matrix<Scalar>::Zero(nv + rows, nv + rows);
  A.topLeftCorner(nv, nv) = detail::stepped_mass_matrix(model, at);
  A.topRightCorner(nv, rows) = -J.transpose();
  A.bottomLeftCorner(rows, nv) = J;
  Vector<Scalar> b(nv + rows);
  b.head(nv) = detail::net_forces(model, at);
  b.tail(rows) = detail::held_accelerations<Scalar>(model, constraints, J, at);
  if (at.shares.size() > 0) {
    const Vector<Scalar> free = Vector<Scalar>::Ones(rows) - at.shares;
    const Matrix<Scalar> M = A.topLeftCorner(nv, nv);
    const Matrix<Scalar> Lambda_inverse =
        J * inverse_of_positive_definite<Scalar>(M) * J.transpose();
    A.bottomLeftCorner(rows, nv) = at.shares.asDiagonal() * J;
    A.bottomRightCorner(rows, rows).diagonal() = free.cwiseProduct(Lambda_inverse.diagonal());
    b.tail(rows) = b.tail(rows).cwiseProduct(at.shares).eval();
  }
  const Vector<Scalar> x = detail::solve_consistent<Scalar>(A, b);
  return {x.head(nv), x.tail(rows)};
}

/// Motion with held rows, where `law` relaxes rows that no force of their own can hold.
template <class Scalar>
ConstrainedMotion<Scalar> constrained_forward_dynamics(
    const Model<Scalar>& model, PointsArg<Scalar> constraints,
    const ConstrainedState<std::type_identity_t<Scalar>>& at, const TaskLaw<Scalar>& law) {
  const Matrix<Scalar> J = detail::held_jacobian<Scalar>(model, constraints, at.loops, at.q);
  const Matrix<Scalar> M_inverse =
      inverse_of_positive_definite<Scalar>(detail::stepped_mass_matrix(model, at));
  const Vector<Scalar> free = M_inverse * detail::net_forces(model, at);
  const Vector<Scalar> missing =
      detail::held_accelerations<Scalar>(model, constraints, J, at) - J * free;
  const Matrix<Scalar> Lambda_inverse = J * M_inverse * J.transpose();
  const Vector<Scalar> f = bordered_inverse<Scalar>(Lambda_inverse, law, at.shares) * missing;
  return {free + M_inverse * (J.transpose() * f), f};
}

}  // namespace treeline::interpreter
