#pragma once

#include "interpreter/contacts.hpp"

namespace treeline::interpreter {

/// Sudden changes of velocities due to impulses.
template <class Scalar>
struct ImpulseResponse {
  Vector<Scalar> dqd;           ///< of the joints' velocities
  PerBody<Vector6<Scalar>> dv;  ///< of each body's origin and angular velocity, in its axes
};

namespace detail {

/// Impulse propagation, Chang table 8.2, for impulses on bodies, each in its body's frame.
template <class Scalar>
ImpulseResponse<Scalar> propagate_impulses(const Model<Scalar>& model, const Kinematics<Scalar>& k,
                                           PerBody<Vector6<Scalar>> y) {
  const auto inertia = articulated_inertia(model, k);
  const auto& [IA, U, D_inverse] = inertia;
  for (int i = model.size() - 1; i >= 0; --i) {
    if (y[i].isZero(Scalar(0))) continue;  // not on the path of a struck body
    Vector6<Scalar> passed_on = y[i];
    if (k.S[i].cols() > 0) passed_on -= U[i] * (D_inverse[i] * (k.S[i].transpose() * y[i]));
    y[model.body(i).parent] += k.X[i] * passed_on;
  }
  ImpulseResponse<Scalar> response{Vector<Scalar>::Zero(model.nv),
                                   PerBody<Vector6<Scalar>>(model.size(), Vector6<Scalar>::Zero())};
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    response.dv[i] = k.X[i].transpose() * response.dv[body.parent];
    const auto d = k.S[i].cols();
    if (d == 0) continue;
    const Vector<Scalar> own =
        D_inverse[i] * (k.S[i].transpose() * (y[i] - IA[i] * response.dv[i]));
    response.dqd.segment(body.v, d) = own;
    response.dv[i] += k.S[i] * own;
  }
  return response;
}

/// M dqd = J^T y, then the bodies' velocities outward. Also valid with mimic joints.
template <class Scalar>
ImpulseResponse<Scalar> impulses_by_mass_matrix(const Model<Scalar>& model,
                                                const Kinematics<Scalar>& k,
                                                PerBody<Vector6<Scalar>> y, VectorArg<Scalar> q) {
  Vector<Scalar> joint_impulse = Vector<Scalar>::Zero(model.nv);
  for (int i = model.size() - 1; i >= 0; --i) {
    const Body<Scalar>& body = model.body(i);
    joint_impulse.segment(body.v, k.S[i].cols()) +=
        body.multiplier * Vector<Scalar>(k.S[i].transpose() * y[i]);
    y[body.parent] += k.X[i] * y[i];
  }
  ImpulseResponse<Scalar> response{mass_matrix<Scalar>(model, q).ldlt().solve(joint_impulse),
                                   PerBody<Vector6<Scalar>>(model.size(), Vector6<Scalar>::Zero())};
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    response.dv[i] = k.X[i].transpose() * response.dv[body.parent] +
                     k.S[i] * joint_velocity<Scalar>(body, response.dqd);
  }
  return response;
}

}  // namespace detail

/// Changes of all velocities due to impulses at contacts (three entries each, N s, world axes), by
/// impulse propagation (Chang table 8.2): y_h = L y_i inward from the struck bodies, then outward
/// dqd = D^-1 S^T (y_i - IA X^T dv_h) and dv_i = X^T dv_h + S dqd for all bodies. O(n). With mimic
/// joints by the mass matrix.
template <class Scalar>
ImpulseResponse<Scalar> impulse_response(const Model<Scalar>& model, PointsArg<Scalar> contacts,
                                         VectorArg<Scalar> q, VectorArg<Scalar> impulses) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  PerBody<Vector6<Scalar>> y(model.size(), Vector6<Scalar>::Zero());
  add_point_forces<Scalar>(model, contacts, k, impulses, y);
  if (model.has_mimics()) return detail::impulses_by_mass_matrix<Scalar>(model, k, y, q);
  return detail::propagate_impulses<Scalar>(model, k, std::move(y));
}

}  // namespace treeline::interpreter
