#pragma once

#include "interpreter/joint_model.hpp"

namespace treeline::interpreter {

/// tanh(128 artanh(x / 128)), the smooth sign of Coulomb friction: with y = x / 128 or its
/// reciprocal, q / p where p + q j = (1 + y j)^128 and j^2 = 1.
template <class Scalar>
Scalar smooth_sign(const Scalar& x) {
  Scalar y = x / Scalar(128);
  if (y > Scalar(1) || y < Scalar(-1)) y = Scalar(1) / y;
  Scalar p(1);
  Scalar q = y;
  for (int i = 0; i < 7; ++i) {
    const Scalar squares = p * p + q * q;
    q = Scalar(2) * p * q;
    p = squares;
  }
  return q / p;
}

/// The force that overcomes friction of a joint of one degree of freedom that moves at `rate`.
template <class Scalar>
Scalar friction_force(const Body<Scalar>& body, const Scalar& rate) {
  const Scalar viscous = body.damping * rate;
  if (body.friction == Scalar(0)) return viscous;
  return viscous + body.friction * smooth_sign<Scalar>(rate / body.slip_speed);
}

/// Joint forces that overcome friction and hold springs.
template <class Scalar>
Vector<Scalar> joint_forces(const Model<Scalar>& model, VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  Vector<Scalar> tau = Vector<Scalar>::Zero(model.nv);
  for (const Body<Scalar>& body : model.bodies) {
    if (velocity_count(body.kind) != 1) continue;
    const Scalar rate = joint_velocity<Scalar>(body, qd)(0);
    const Scalar stretch = joint_position<Scalar>(body, q)(0) - body.rest;
    tau(body.v) +=
        body.multiplier * (friction_force<Scalar>(body, rate) + body.stiffness * stretch);
  }
  return tau;
}

template <class Scalar>
Scalar spring_energy(const Model<Scalar>& model, VectorArg<Scalar> q) {
  Scalar twice(0);
  for (const Body<Scalar>& body : model.bodies) {
    if (body.stiffness == Scalar(0) || velocity_count(body.kind) != 1) continue;
    const Scalar stretch = joint_position<Scalar>(body, q)(0) - body.rest;
    twice += body.stiffness * stretch * stretch;
  }
  return twice / Scalar(2);
}

/// The model without what depends on q alone: weight and springs.
template <class Scalar>
Model<Scalar> without_gravity(Model<Scalar> model) {
  model.gravity.setZero();
  for (Body<Scalar>& body : model.bodies) body.stiffness = Scalar(0);
  return model;
}

}  // namespace treeline::interpreter
