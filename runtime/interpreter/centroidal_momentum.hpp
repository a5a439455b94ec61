#pragma once

#include "interpreter/center_of_mass.hpp"

namespace treeline::interpreter {

namespace detail {

/// A body's centre of mass from the robot's, and its rotational inertia about its own; world axes.
template <class Scalar>
struct CentralBody {
  Scalar mass;
  Vector3<Scalar> arm;
  Matrix3<Scalar> inertia;
};

template <class Scalar>
CentralBody<Scalar> central_body(const Model<Scalar>& model, int i, const Kinematics<Scalar>& k,
                                 const Vector3<Scalar>& center) {
  const Body<Scalar>& body = model.body(i);
  const Matrix3<Scalar> c = cross_matrix(body.com);
  const Matrix3<Scalar> own = body.inertia + body.mass * Matrix3<Scalar>(c * c);
  const Matrix3<Scalar>& R = k.R_world[i];
  return {body.mass, k.p_world[i] + R * body.com - center, R * own * R.transpose()};
}

}  // namespace detail

/// A_G, 6 x nv, the centroidal momentum matrix (Orin & Goswami 2008): A_G qd is the momentum over
/// the angular momentum about the centre of mass, world axes, without the rotors of motors. Body by
/// body, by the Jacobians of their centres of mass.
template <class Scalar>
Matrix<Scalar> centroidal_momentum_matrix(const Model<Scalar>& model, VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const Vector3<Scalar> center = center_of_mass<Scalar>(model, q);
  Matrix<Scalar> A = Matrix<Scalar>::Zero(6, model.nv);
  for (int i = 0; i < model.size(); ++i) {
    const auto body = detail::central_body(model, i, k, center);
    const Points<Scalar> own{{"", i, Matrix3<Scalar>::Identity(), model.body(i).com}};
    const Matrix<Scalar> J = detail::all_rows_jacobian<Scalar>(model, own, k);
    const Matrix<Scalar> P = body.mass * J.topRows(3);
    A.topRows(3) += P;
    A.bottomRows(3) += cross_matrix(body.arm) * P + body.inertia * J.bottomRows(3);
  }
  return A;
}

/// h_G = A_G qd, 6, from the velocities of all bodies.
template <class Scalar>
Vector6<Scalar> centroidal_momentum(const Model<Scalar>& model, VectorArg<Scalar> q,
                                    VectorArg<Scalar> qd) {
  const auto k = kinematics<Scalar>(model, q, qd);
  const Vector3<Scalar> center = center_of_mass<Scalar>(model, q);
  Vector6<Scalar> h = Vector6<Scalar>::Zero();
  for (int i = 0; i < model.size(); ++i) {
    const auto body = detail::central_body(model, i, k, center);
    const Vector3<Scalar> w = k.R_world[i] * angular(k.v[i]);
    const Vector3<Scalar> v =
        k.R_world[i] * linear(k.v[i]) + cross<Scalar>(w, k.R_world[i] * model.body(i).com);
    const Vector3<Scalar> P = body.mass * v;
    h += stack<Scalar>(P, cross(body.arm, P) + body.inertia * w);
  }
  return h;
}

/// dh_G/dt = A_G qdd + dA_G/dt qd, 6: what the momenta of all bodies change by (Newton, Euler).
template <class Scalar>
Vector6<Scalar> centroidal_momentum_rate(const Model<Scalar>& model, VectorArg<Scalar> q,
                                         VectorArg<Scalar> qd, VectorArg<Scalar> qdd) {
  const auto k = kinematics<Scalar>(model, q, qd);
  const auto a = accelerations<Scalar>(model, k, qdd, Vector3<Scalar>::Zero());
  const Vector3<Scalar> center = center_of_mass<Scalar>(model, q);
  Vector6<Scalar> rate = Vector6<Scalar>::Zero();
  for (int i = 0; i < model.size(); ++i) {
    const auto body = detail::central_body(model, i, k, center);
    const Matrix3<Scalar>& R = k.R_world[i];
    const Vector3<Scalar> c = R * model.body(i).com;
    const Vector3<Scalar> w = R * angular(k.v[i]);
    const Vector3<Scalar> alpha = R * angular(a[i]);
    const Vector3<Scalar> f =
        body.mass * Vector3<Scalar>(R * linear(a[i]) + cross(alpha, c) + cross(w, cross(w, c)));
    const Vector3<Scalar> L = body.inertia * w;
    rate += stack<Scalar>(f, cross(body.arm, f) + body.inertia * alpha + cross(w, L));
  }
  return rate;
}

/// dA_G/dt qd, 6: the rate of the momentum at qdd = 0.
template <class Scalar>
Vector6<Scalar> centroidal_bias(const Model<Scalar>& model, VectorArg<Scalar> q,
                                VectorArg<Scalar> qd) {
  return centroidal_momentum_rate<Scalar>(model, q, qd, Vector<Scalar>::Zero(model.nv));
}

/// dJ_com/dt qd, 3: the acceleration of the centre of mass at qdd = 0, m/s^2, world axes.
template <class Scalar>
Vector3<Scalar> center_of_mass_bias_acceleration(const Model<Scalar>& model, VectorArg<Scalar> q,
                                                 VectorArg<Scalar> qd) {
  return linear(centroidal_bias<Scalar>(model, q, qd)) / total_mass(model);
}

/// Mass, kg, and centre of mass in the world, m, of a body with all that it carries.
template <class Scalar>
struct Subtree {
  Scalar mass;
  Vector3<Scalar> center;  ///< of no mass: the body's origin
};

/// Mass and centre of the subtree of every body, from the bodies that have it as an ancestor.
template <class Scalar>
std::vector<Subtree<Scalar>> subtrees(const Model<Scalar>& model, VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  std::vector<Subtree<Scalar>> result;
  for (int root = 0; root < model.size(); ++root) {
    Scalar mass(0);
    Vector3<Scalar> moment = Vector3<Scalar>::Zero();
    for (int i = root; i < model.size(); ++i) {
      int ancestor = i;
      while (ancestor > root) ancestor = model.body(ancestor).parent;
      if (ancestor != root) continue;
      const Body<Scalar>& body = model.body(i);
      mass += body.mass;
      moment += body.mass * (k.p_world[i] + k.R_world[i] * body.com);
    }
    result.push_back({mass, mass == Scalar(0) ? k.p_world[root] : Vector3<Scalar>(moment / mass)});
  }
  return result;
}

}  // namespace treeline::interpreter
