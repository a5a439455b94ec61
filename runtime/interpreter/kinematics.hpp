#pragma once

#include <cassert>

#include "interpreter/joint_model.hpp"

namespace treeline::interpreter {

/// Results of one outward pass over the tree for each body, in the body's own frame unless the name
/// says otherwise. The world's entries are those of a body at rest at the origin.
template <class Scalar>
struct Kinematics {
  explicit Kinematics(int bodies)
      : X(bodies, Matrix6<Scalar>::Identity()),
        S(bodies, JointMatrix<Scalar>(6, 0)),
        c(bodies, Vector6<Scalar>::Zero()),
        v(bodies, Vector6<Scalar>::Zero()),
        R_world(bodies, Matrix3<Scalar>::Identity()),
        p_world(bodies, Vector3<Scalar>::Zero()) {}

  PerBody<Matrix6<Scalar>> X;  ///< maps forces to the parent; X^T maps motions from the parent
  PerBody<JointMatrix<Scalar>> S;
  PerBody<Vector6<Scalar>> c;        ///< acceleration at this joint due to velocities alone
  PerBody<Vector6<Scalar>> v;        ///< velocity of the origin over angular velocity
  PerBody<Matrix3<Scalar>> R_world;  ///< from body's axes to world axes
  PerBody<Vector3<Scalar>> p_world;  ///< origin in the world
};

/// c_i of Chang table 4.1 for joints with any number of degrees of freedom: [R^T (w_h x (w_h x p))
/// + 2 (R^T w_h) x (S_v qd) + (S_w qd) x (S_v qd); (R^T w_h) x (S_w qd)] + Sdot qd. The third term
/// is for joints that rotate and translate at once.
template <class Scalar>
Vector6<Scalar> velocity_product(const JointState<Scalar>& joint, const Vector3<Scalar>& w_parent,
                                 const Vector6<Scalar>& relative_velocity) {
  const Vector3<Scalar> w = joint.R.transpose() * w_parent;
  const Vector3<Scalar> slide = linear(relative_velocity);
  const Vector3<Scalar> turn = angular(relative_velocity);
  const Vector3<Scalar> centripetal =
      joint.R.transpose() * cross(w_parent, cross(w_parent, joint.p));
  return stack<Scalar>(centripetal + Scalar(2) * cross(w, slide) + cross(turn, slide),
                       cross(w, turn)) +
         joint.Sdot_qd;
}

/// Outward recursion for poses, S, velocities and velocity products.
template <class Scalar>
Kinematics<Scalar> kinematics(const Model<Scalar>& model, VectorArg<Scalar> q,
                              VectorArg<Scalar> qd) {
  assert(q.size() == model.nq && qd.size() == model.nv);
  Kinematics<Scalar> k(model.size());
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const int h = body.parent;
    const JointVector<Scalar> own_qd = joint_velocity<Scalar>(body, qd);
    const JointState<Scalar> joint = joint_model(body, joint_position<Scalar>(body, q), own_qd);
    const Vector6<Scalar> relative = joint.S * own_qd;
    k.X[i] = force_transform(joint.R, joint.p);
    k.S[i] = joint.S;
    k.v[i] = k.X[i].transpose() * k.v[h] + relative;
    k.c[i] = velocity_product(joint, angular(k.v[h]), relative);
    k.R_world[i] = k.R_world[h] * joint.R;
    k.p_world[i] = k.p_world[h] + k.R_world[h] * joint.p;
  }
  return k;
}

/// Outward recursion a_i = X^T a_h + S qdd + c_i (Chang table 4.1): conventional acceleration of
/// each origin over angular acceleration, in each body's axes. `base` is an acceleration of the
/// world, in its axes.
template <class Scalar>
PerBody<Vector6<Scalar>> accelerations(const Model<Scalar>& model, const Kinematics<Scalar>& k,
                                       VectorArg<Scalar> qdd, const Vector3<Scalar>& base) {
  assert(qdd.size() == model.nv);
  PerBody<Vector6<Scalar>> a(model.size(), stack<Scalar>(base, Vector3<Scalar>::Zero()));
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    a[i] =
        k.X[i].transpose() * a[body.parent] + k.S[i] * joint_velocity<Scalar>(body, qdd) + k.c[i];
  }
  return a;
}

}  // namespace treeline::interpreter
