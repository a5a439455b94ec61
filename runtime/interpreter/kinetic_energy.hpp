#pragma once

#include "interpreter/kinematics.hpp"

namespace treeline::interpreter {

/// qd^T M qd / 2, J, body by body (König): of the mass at the velocity of its centre, and of the
/// turning about that centre.
template <class Scalar>
Scalar kinetic_energy(const Model<Scalar>& model, VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  const auto k = kinematics<Scalar>(model, q, qd);
  Scalar twice(0);
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const Vector3<Scalar> w = angular(k.v[i]);
    const Vector3<Scalar> v = linear(k.v[i]) + cross<Scalar>(w, body.com);
    const Matrix3<Scalar> c = cross_matrix(body.com);
    const Matrix3<Scalar> central = body.inertia + body.mass * Matrix3<Scalar>(c * c);
    twice += body.mass * v.dot(v) + w.dot(central * w);
    if (velocity_count(body.kind) == 0) continue;
    twice += body.armature * joint_velocity<Scalar>(body, qd).squaredNorm();
  }
  return twice / Scalar(2);
}

}  // namespace treeline::interpreter
