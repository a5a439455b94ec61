#pragma once

#include "interpreter/explicit_operational_space.hpp"
#include "interpreter/forward_dynamics.hpp"

namespace treeline::interpreter {

/// Posture acceleration that is equivalent to the null-space torque tau_0: qdd_0 = M^-1 (tau_0 - b
/// - g), the acceleration that tau_0 alone would cause. With it the optimised structure (Chang eq.
/// 6.1) gives the torque of eq. 2.2:
///
///     J^T Lambda (xdd - Jd qd - J qdd_0) + M qdd_0 + b + g
///   = J^T [Lambda (xdd - Jd qd) + Jbar^T (b + g)] + (1 - J^T Jbar^T) tau_0
///
/// because M qdd_0 + b + g = tau_0 and Lambda J M^-1 = Jbar^T. The inverse of this function is
/// `inverse_dynamics`.
template <class Scalar>
Vector<Scalar> posture_acceleration(const Model<Scalar>& model, VectorArg<Scalar> q,
                                    VectorArg<Scalar> qd, VectorArg<Scalar> tau_0) {
  return forward_dynamics<Scalar>(model, q, qd, tau_0);
}

/// F = Lambda xdd_cmd + mu + p (Chang eq. 2.5) with mu + p = Jbar^T (b + g) - Lambda Jd qd. `bias`
/// is Jd qd.
template <class Scalar>
Vector<Scalar> operational_force(const ExplicitOperationalSpace<Scalar>& o,
                                 VectorArg<Scalar> xdd_cmd, VectorArg<Scalar> bias,
                                 VectorArg<Scalar> nonlinear_effects) {
  return o.Lambda * (xdd_cmd - bias) + o.Jbar.transpose() * nonlinear_effects;
}

/// tau = J^T F + N^T tau_0 (Chang eq. 2.2, 2.10). `tau_0` accelerates no operational point. It must
/// contain b + g if these are to be compensated in the null space as well.
template <class Scalar>
Vector<Scalar> task_posture_torque(const ExplicitOperationalSpace<Scalar>& o, VectorArg<Scalar> F,
                                   VectorArg<Scalar> tau_0) {
  return o.J.transpose() * F + o.N.transpose() * tau_0;
}

}  // namespace treeline::interpreter
