#pragma once

#include "interpreter/dual.hpp"
#include "interpreter/forward_dynamics.hpp"
#include "interpreter/mass_matrix.hpp"

namespace treeline::interpreter {

/// Derivatives as nv x nv matrices: column j is the change per unit of displacement j, velocity j,
/// and acceleration j (for forward dynamics: joint force j). A displacement of a floating joint is
/// a twist of the child in its own axes, linear over angular; that of a spherical joint is the
/// angular part; others are changes of q.
template <class Scalar>
struct DynamicsDerivatives {
  Matrix<Scalar> by_displacement, by_velocity, by_drive;
};

namespace detail {

template <class Scalar>
Vector<Dual<Scalar>> constant(const Vector<Scalar>& x) {
  return x.unaryExpr([](const Scalar& entry) { return Dual<Scalar>(entry); });
}

/// q as a dual number that moves along displacement j.
template <class Scalar>
Vector<Dual<Scalar>> displaced(const Model<Scalar>& model, const Vector<Scalar>& q,
                               Eigen::Index j) {
  Vector<Scalar> rate = Vector<Scalar>::Zero(model.nv);
  rate(j) = Scalar(1);
  const Vector<Scalar> slope = position_derivative<Scalar>(model, q, rate);
  Vector<Dual<Scalar>> moving = constant<Scalar>(q);
  for (Eigen::Index i = 0; i < q.size(); ++i) moving(i).slope = slope(i);
  return moving;
}

template <class Scalar>
void copy_slopes(const Vector<Dual<Scalar>>& from, Eigen::Index column, Matrix<Scalar>& to) {
  for (Eigen::Index i = 0; i < from.size(); ++i) to(i, column) = from(i).slope;
}

/// Derivatives of f(q, qd), in dual numbers, column by column.
template <class Scalar, class Function>
DynamicsDerivatives<Scalar> differentiate(const Model<Scalar>& model, const Vector<Scalar>& q,
                                          const Vector<Scalar>& qd, const Function& f) {
  using Number = Dual<Scalar>;
  const Vector<Number> q_held = constant<Scalar>(q);
  Vector<Number> qd_moving = constant<Scalar>(qd);
  const Eigen::Index rows = f(q_held, qd_moving).size();
  const Matrix<Scalar> none = Matrix<Scalar>::Zero(rows, model.nv);
  DynamicsDerivatives<Scalar> result{none, none, {}};
  for (Eigen::Index j = 0; j < model.nv; ++j) {
    const Vector<Number> q_moving = displaced<Scalar>(model, q, j);
    copy_slopes<Scalar>(f(q_moving, qd_moving), j, result.by_displacement);
    qd_moving(j).slope = Scalar(1);
    copy_slopes<Scalar>(f(q_held, qd_moving), j, result.by_velocity);
    qd_moving(j).slope = Scalar(0);
  }
  return result;
}

}  // namespace detail

/// Derivatives of tau = M qdd + b + g - J_ext^T f_ext with constant f_ext: inverse dynamics in dual
/// numbers.
template <class Scalar>
DynamicsDerivatives<Scalar> inverse_dynamics_derivatives(const Model<Scalar>& model,
                                                         VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                                         VectorArg<Scalar> qdd,
                                                         PointsArg<Scalar> external_points,
                                                         VectorArg<Scalar> f_ext) {
  using Number = Dual<Scalar>;
  const Model<Number> lifted = cast<Number>(model);
  const Points<Number> points = cast<Number>(external_points);
  const auto tau = [&](const Vector<Number>& q_moving, const Vector<Number>& qd_moving) {
    return inverse_dynamics<Number>(lifted, q_moving, qd_moving, detail::constant<Scalar>(qdd),
                                    points, detail::constant<Scalar>(f_ext));
  };
  auto result = detail::differentiate<Scalar>(model, q, qd, tau);
  result.by_drive = mass_matrix<Scalar>(model, q);
  return result;
}

/// Derivative of friction with respect to qd, nv x nv and diagonal, in dual numbers.
template <class Scalar>
Matrix<Scalar> friction_slopes(const Model<Scalar>& model, VectorArg<Scalar> q,
                               VectorArg<Scalar> qd) {
  using Number = Dual<Scalar>;
  Vector<Number> moving = detail::constant<Scalar>(qd);
  for (Number& rate : moving) rate.slope = Scalar(1);
  const Vector<Number> forces =
      joint_forces<Number>(cast<Number>(model), detail::constant<Scalar>(q), moving);
  Matrix<Scalar> slopes = Matrix<Scalar>::Zero(model.nv, model.nv);
  for (Eigen::Index i = 0; i < model.nv; ++i) slopes(i, i) = forces(i).slope;
  return slopes;
}

/// Derivatives of qdd = M^-1 (tau - b - g + J_ext^T f_ext) with constant f_ext. by_drive is M^-1;
/// the others are -M^-1 times the derivatives of inverse dynamics at that qdd.
template <class Scalar>
DynamicsDerivatives<Scalar> forward_dynamics_derivatives(const Model<Scalar>& model,
                                                         VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                                         VectorArg<Scalar> tau,
                                                         PointsArg<Scalar> external_points,
                                                         VectorArg<Scalar> f_ext) {
  const Vector<Scalar> qdd = forward_dynamics<Scalar>(model, q, qd, tau, external_points, f_ext);
  const auto forces =
      inverse_dynamics_derivatives<Scalar>(model, q, qd, qdd, external_points, f_ext);
  const auto factor = forces.by_drive.ldlt();
  return {-factor.solve(forces.by_displacement), -factor.solve(forces.by_velocity),
          factor.solve(Matrix<Scalar>::Identity(model.nv, model.nv))};
}

/// Terms that take friction and springs at the end of a step of velocities, to first order.
template <class Scalar>
struct ImplicitDrives {
  Matrix<Scalar> inertia;  ///< step D + step^2 K, which adds to M
  Vector<Scalar> force;    ///< step K qd, which adds to g
};

/// D is the derivative of friction with respect to qd, K that of springs with respect to q; both
/// are diagonal.
template <class Scalar>
ImplicitDrives<Scalar> implicit_drives(const Model<Scalar>& model, VectorArg<Scalar> q,
                                       VectorArg<Scalar> qd, const Scalar& step) {
  Vector<Scalar> K = Vector<Scalar>::Zero(model.nv);
  for (const Body<Scalar>& body : model.bodies) {
    if (velocity_count(body.kind) != 1) continue;
    K(body.v) += body.multiplier * body.multiplier * body.stiffness;
  }
  const Matrix<Scalar> inertia =
      step * friction_slopes<Scalar>(model, q, qd) + Matrix<Scalar>((step * step * K).asDiagonal());
  return {inertia, step * K.cwiseProduct(qd)};
}

/// qdd with (M + step D + step^2 K) qdd + b + g + step K qd = tau + J_ext^T f_ext: friction and
/// springs at the end of a step.
template <class Scalar>
Vector<Scalar> forward_dynamics_with_implicit_drives(const Model<Scalar>& model,
                                                     VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                                     VectorArg<Scalar> tau,
                                                     PointsArg<Scalar> external_points,
                                                     VectorArg<Scalar> f_ext, const Scalar& step) {
  const Vector<Scalar> h = inverse_dynamics<Scalar>(model, q, qd, Vector<Scalar>::Zero(model.nv),
                                                    external_points, f_ext);
  const auto drives = implicit_drives<Scalar>(model, q, qd, step);
  const Matrix<Scalar> M = mass_matrix<Scalar>(model, q) + drives.inertia;
  return M.ldlt().solve(Vector<Scalar>(tau - h - drives.force));
}

}  // namespace treeline::interpreter
