#pragma once

#include "interpreter/articulated_inertia.hpp"
#include "interpreter/mass_matrix.hpp"

namespace treeline::interpreter {

namespace detail {

/// Bias forces of all bodies: gyroscopic minus external forces.
template <class Scalar>
PerBody<Vector6<Scalar>> bias_forces(const Model<Scalar>& model, const Kinematics<Scalar>& k,
                                     const PerBody<Vector6<Scalar>>& external) {
  PerBody<Vector6<Scalar>> p(model.size(), Vector6<Scalar>::Zero());
  for (int i = 0; i < model.size(); ++i) {
    p[i] = gyroscopic_force(model.body(i), angular(k.v[i])) - external[i];
  }
  return p;
}

/// qdd by the articulated-body algorithm, Chang table 4.2, without friction and springs.
template <class Scalar>
Vector<Scalar> articulated_body(const Model<Scalar>& model, const Kinematics<Scalar>& k,
                                VectorArg<Scalar> tau, const PerBody<Vector6<Scalar>>& external) {
  const auto inertia = articulated_inertia(model, k);
  const auto& [IA, U, D_inverse] = inertia;
  PerBody<Vector6<Scalar>> pA = bias_forces(model, k, external);
  for (int i = model.size() - 1; i >= 0; --i) {
    const Body<Scalar>& body = model.body(i);
    const auto d = k.S[i].cols();
    Vector6<Scalar> felt_by_parent = pA[i] + IA[i] * k.c[i];
    if (d > 0) {
      const Vector<Scalar> u = tau.segment(body.v, d) - k.S[i].transpose() * felt_by_parent;
      felt_by_parent += U[i] * (D_inverse[i] * u);
    }
    pA[body.parent] += k.X[i] * felt_by_parent;
  }
  Vector<Scalar> qdd(model.nv);
  PerBody<Vector6<Scalar>> a(model.size(), stack<Scalar>(-model.gravity, Vector3<Scalar>::Zero()));
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const auto d = k.S[i].cols();
    a[i] = k.X[i].transpose() * a[body.parent] + k.c[i];
    if (d == 0) continue;
    const Vector<Scalar> u = tau.segment(body.v, d) - k.S[i].transpose() * (IA[i] * a[i] + pA[i]);
    const Vector<Scalar> own = D_inverse[i] * u;
    qdd.segment(body.v, d) = own;
    a[i] += k.S[i] * own;
  }
  return qdd;
}

}  // namespace detail

/// qdd with M qdd + b + g = tau + J_ext^T f_ext, by LDL^T of M in O(n^3). Also valid with mimic
/// joints.
template <class Scalar>
Vector<Scalar> forward_dynamics_by_mass_matrix(const Model<Scalar>& model, VectorArg<Scalar> q,
                                               VectorArg<Scalar> qd, VectorArg<Scalar> tau,
                                               PointsArg<Scalar> external_points,
                                               VectorArg<Scalar> f_ext) {
  const Vector<Scalar> h = inverse_dynamics<Scalar>(model, q, qd, Vector<Scalar>::Zero(model.nv),
                                                    external_points, f_ext);
  return mass_matrix<Scalar>(model, q).ldlt().solve(Vector<Scalar>(tau - h));
}

/// qdd with M qdd + b + g = tau + J_ext^T f_ext, by articulated bodies (Chang table 4.2). A robot
/// with mimic joints is solved by its mass matrix, because the table requires that a joint's force
/// acts at that joint alone.
template <class Scalar>
Vector<Scalar> forward_dynamics(const Model<Scalar>& model, VectorArg<Scalar> q,
                                VectorArg<Scalar> qd, VectorArg<Scalar> tau,
                                PointsArg<Scalar> external_points, VectorArg<Scalar> f_ext) {
  if (model.has_mimics()) {
    return forward_dynamics_by_mass_matrix<Scalar>(model, q, qd, tau, external_points, f_ext);
  }
  const auto k = kinematics<Scalar>(model, q, qd);
  PerBody<Vector6<Scalar>> external(model.size(), Vector6<Scalar>::Zero());
  add_point_forces<Scalar>(model, external_points, k, f_ext, external);
  const Vector<Scalar> net = tau - joint_forces<Scalar>(model, q, qd);
  return detail::articulated_body<Scalar>(model, k, net, external);
}

/// qdd with M qdd + b + g = tau.
template <class Scalar>
Vector<Scalar> forward_dynamics(const Model<Scalar>& model, VectorArg<Scalar> q,
                                VectorArg<Scalar> qd, VectorArg<Scalar> tau) {
  return forward_dynamics<Scalar>(model, q, qd, tau, {}, Vector<Scalar>());
}

}  // namespace treeline::interpreter
