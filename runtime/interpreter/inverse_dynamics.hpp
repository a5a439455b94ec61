#pragma once

#include "interpreter/joint_forces.hpp"
#include "interpreter/points.hpp"

namespace treeline::interpreter {

namespace detail {

template <class Scalar>
Matrix6<Scalar> body_inertia(const Body<Scalar>& body) {
  return spatial_inertia(body.mass, body.com, body.inertia);
}

/// [w x (w x m c); w x (J w)], the force that a body's motion at constant velocity requires.
template <class Scalar>
Vector6<Scalar> gyroscopic_force(const Body<Scalar>& body, const Vector3<Scalar>& w) {
  const Vector3<Scalar> first_moment = body.mass * body.com;
  return stack<Scalar>(cross<Scalar>(w, cross(w, first_moment)),
                       cross<Scalar>(w, body.inertia * w));
}

/// tau_i = S^T f_i and f_h += X f_i, from the leaves to the root.
template <class Scalar>
Vector<Scalar> project_forces_inward(const Model<Scalar>& model, const Kinematics<Scalar>& k,
                                     PerBody<Vector6<Scalar>>& f) {
  Vector<Scalar> tau = Vector<Scalar>::Zero(model.nv);
  for (int i = model.size() - 1; i >= 0; --i) {
    const Body<Scalar>& body = model.body(i);
    tau.segment(body.v, k.S[i].cols()) += body.multiplier * (k.S[i].transpose() * f[i]);
    f[body.parent] += k.X[i] * f[i];
  }
  return tau;
}

/// Joint forces by recursive Newton-Euler (Chang table 4.1) without friction and springs, with
/// `external` forces on the bodies in their frames. Gravity enters as an acceleration of the world.
template <class Scalar>
Vector<Scalar> newton_euler(const Model<Scalar>& model, const Kinematics<Scalar>& k,
                            VectorArg<Scalar> qdd, const PerBody<Vector6<Scalar>>& external) {
  const auto a = accelerations<Scalar>(model, k, qdd, -model.gravity);
  PerBody<Vector6<Scalar>> f(model.size(), Vector6<Scalar>::Zero());
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    f[i] = body_inertia(body) * a[i] + gyroscopic_force(body, angular(k.v[i])) - external[i];
  }
  Vector<Scalar> tau = project_forces_inward(model, k, f);
  for (const Body<Scalar>& body : model.bodies) {
    tau.segment(body.v, velocity_count(body.kind)) +=
        body.multiplier * body.armature * joint_velocity<Scalar>(body, qdd);
  }
  return tau;
}

}  // namespace detail

/// tau = M qdd + b + g - J_ext^T f_ext by recursive Newton-Euler (Chang table 4.1). Friction is
/// part of b, springs are part of g. `f_ext` has for
/// each external point [force; moment] on the robot at its origin, in its axes.
template <class Scalar>
Vector<Scalar> inverse_dynamics(const Model<Scalar>& model, VectorArg<Scalar> q,
                                VectorArg<Scalar> qd, VectorArg<Scalar> qdd,
                                PointsArg<Scalar> external_points, VectorArg<Scalar> f_ext) {
  const auto k = kinematics<Scalar>(model, q, qd);
  PerBody<Vector6<Scalar>> external(model.size(), Vector6<Scalar>::Zero());
  add_point_forces<Scalar>(model, external_points, k, f_ext, external);
  return detail::newton_euler<Scalar>(model, k, qdd, external) + joint_forces<Scalar>(model, q, qd);
}

/// tau = M qdd + b + g.
template <class Scalar>
Vector<Scalar> inverse_dynamics(const Model<Scalar>& model, VectorArg<Scalar> q,
                                VectorArg<Scalar> qd, VectorArg<Scalar> qdd) {
  return inverse_dynamics<Scalar>(model, q, qd, qdd, {}, Vector<Scalar>());
}

/// b + g: the joint forces at qdd = 0.
template <class Scalar>
Vector<Scalar> nonlinear_effects(const Model<Scalar>& model, VectorArg<Scalar> q,
                                 VectorArg<Scalar> qd) {
  return inverse_dynamics<Scalar>(model, q, qd, Vector<Scalar>::Zero(model.nv));
}

/// g: the joint forces that hold the robot at rest.
template <class Scalar>
Vector<Scalar> gravity(const Model<Scalar>& model, VectorArg<Scalar> q) {
  return nonlinear_effects<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
}

}  // namespace treeline::interpreter
