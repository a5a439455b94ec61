#pragma once

#include "interpreter/centroidal_momentum.hpp"
#include "interpreter/derivatives.hpp"
#include "interpreter/kinetic_energy.hpp"
#include "interpreter/operational_quantities.hpp"

// Derivatives of the motion of points, of momentum and of energy, in dual numbers. Columns are as
// in `DynamicsDerivatives`; `by_drive` is that by qdd, and empty where qdd does not matter.

namespace treeline::interpreter {

/// Derivatives of [v; w] of every point, world axes.
template <class Scalar>
DynamicsDerivatives<Scalar> point_velocity_derivatives(const Model<Scalar>& model,
                                                       PointsArg<Scalar> points,
                                                       VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  using Number = Dual<Scalar>;
  const Model<Number> lifted = cast<Number>(model);
  const Points<Number> moving = cast<Number>(points);
  return detail::differentiate<Scalar>(
      model, q, qd, [&](const Vector<Number>& q_moving, const Vector<Number>& qd_moving) {
        return point_velocity<Number>(lifted, moving, q_moving, qd_moving);
      });
}

/// Derivatives of [dv/dt; dw/dt] of every point, world axes, without gravity.
template <class Scalar>
DynamicsDerivatives<Scalar> point_acceleration_derivatives(const Model<Scalar>& model,
                                                           PointsArg<Scalar> points,
                                                           VectorArg<Scalar> q,
                                                           VectorArg<Scalar> qd,
                                                           VectorArg<Scalar> qdd) {
  using Number = Dual<Scalar>;
  const Model<Number> lifted = cast<Number>(model);
  const Points<Number> moving = cast<Number>(points);
  auto result = detail::differentiate<Scalar>(
      model, q, qd, [&](const Vector<Number>& q_moving, const Vector<Number>& qd_moving) {
        return point_acceleration<Number>(lifted, moving, q_moving, qd_moving,
                                          detail::constant<Scalar>(qdd));
      });
  result.by_drive = jacobian<Scalar>(model, with_all_rows<Scalar>(points), q);
  return result;
}

/// Derivatives of h_G, 6 x nv.
template <class Scalar>
DynamicsDerivatives<Scalar> centroidal_momentum_derivatives(const Model<Scalar>& model,
                                                            VectorArg<Scalar> q,
                                                            VectorArg<Scalar> qd) {
  using Number = Dual<Scalar>;
  const Model<Number> lifted = cast<Number>(model);
  return detail::differentiate<Scalar>(
      model, q, qd, [&](const Vector<Number>& q_moving, const Vector<Number>& qd_moving) {
        return Vector<Number>(centroidal_momentum<Number>(lifted, q_moving, qd_moving));
      });
}

/// Derivatives of dh_G/dt, 6 x nv.
template <class Scalar>
DynamicsDerivatives<Scalar> centroidal_momentum_rate_derivatives(const Model<Scalar>& model,
                                                                 VectorArg<Scalar> q,
                                                                 VectorArg<Scalar> qd,
                                                                 VectorArg<Scalar> qdd) {
  using Number = Dual<Scalar>;
  const Model<Number> lifted = cast<Number>(model);
  auto result = detail::differentiate<Scalar>(
      model, q, qd, [&](const Vector<Number>& q_moving, const Vector<Number>& qd_moving) {
        return Vector<Number>(centroidal_momentum_rate<Number>(lifted, q_moving, qd_moving,
                                                               detail::constant<Scalar>(qdd)));
      });
  result.by_drive = centroidal_momentum_matrix<Scalar>(model, q);
  return result;
}

/// Derivatives of the kinetic energy, 1 x nv.
template <class Scalar>
DynamicsDerivatives<Scalar> kinetic_energy_derivatives(const Model<Scalar>& model,
                                                       VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  using Number = Dual<Scalar>;
  const Model<Number> lifted = cast<Number>(model);
  return detail::differentiate<Scalar>(
      model, q, qd, [&](const Vector<Number>& q_moving, const Vector<Number>& qd_moving) {
        return Vector<Number>::Constant(1, kinetic_energy<Number>(lifted, q_moving, qd_moving))
            .eval();
      });
}

}  // namespace treeline::interpreter
