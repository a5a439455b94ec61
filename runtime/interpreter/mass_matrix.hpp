#pragma once

#include "interpreter/inverse_dynamics.hpp"

namespace treeline::interpreter {

/// M, nv x nv, by composite rigid bodies (RBDA table 6.2): the inertia of everything beyond a
/// joint, times S, is the force of a unit acceleration there, and its projections on the inward
/// joints are entries of M. A mimic joint counts as `multiplier` times its leader: M = G^T M_all G.
template <class Scalar>
Matrix<Scalar> mass_matrix(const Model<Scalar>& model, VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  PerBody<Matrix6<Scalar>> I(model.size(), Matrix6<Scalar>::Zero());
  Matrix<Scalar> M = Matrix<Scalar>::Zero(model.nv, model.nv);
  for (int i = 0; i < model.size(); ++i) I[i] = detail::body_inertia(model.body(i));
  for (int i = model.size() - 1; i >= 0; --i) {
    const Body<Scalar>& outer = model.body(i);
    I[outer.parent] += k.X[i] * I[i] * k.X[i].transpose();
    const auto d = k.S[i].cols();
    if (d == 0) continue;
    JointMatrix<Scalar> F = outer.multiplier * (I[i] * k.S[i]);
    M.block(outer.v, outer.v, d, d) += outer.multiplier * (k.S[i].transpose() * F);
    M.diagonal().segment(outer.v, d).array() +=
        outer.multiplier * outer.multiplier * outer.armature;
    for (int j = i; model.body(j).parent != kWorld;) {
      F = (k.X[j] * F).eval();
      j = model.body(j).parent;
      const Body<Scalar>& inner = model.body(j);
      const Matrix<Scalar> entries = inner.multiplier * (k.S[j].transpose() * F);
      M.block(inner.v, outer.v, k.S[j].cols(), d) += entries;
      M.block(outer.v, inner.v, d, k.S[j].cols()) += entries.transpose();
    }
  }
  return M;
}

}  // namespace treeline::interpreter
