#pragma once

#include "interpreter/joint_forces.hpp"
#include "interpreter/kinematics.hpp"

namespace treeline::interpreter {

/// -sum of m_i g . c_i and the energy of springs, J: zero with every mass at the world's origin and
/// slack springs.
template <class Scalar>
Scalar potential_energy(const Model<Scalar>& model, VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  Scalar energy(0);
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const Vector3<Scalar> center = k.p_world[i] + k.R_world[i] * body.com;
    energy -= body.mass * model.gravity.dot(center);
  }
  return energy + spring_energy<Scalar>(model, q);
}

}  // namespace treeline::interpreter
