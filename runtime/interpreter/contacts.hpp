#pragma once

#include "interpreter/link_inverse_inertias.hpp"
#include "interpreter/task_law.hpp"

namespace treeline::interpreter {

/// A point of a body at which it may touch something. Forces and impulses there have three
/// components in world axes. `p` is in the body's frame. The world (kWorld) may have such points,
/// too.
template <class Scalar>
OperationalPoint<Scalar> contact_point(int body, const Vector3<Scalar>& p,
                                       const std::string& name = "contact") {
  OperationalPoint<Scalar> point;
  point.name = name;
  point.body = body;
  point.p = p;
  point.rows = {true, true, true, false, false, false};
  return point;
}

/// Positions and velocities of contacts, three entries for each, world axes.
template <class Scalar>
struct ContactMotion {
  Vector<Scalar> position;
  Vector<Scalar> velocity;
};

template <class Scalar>
ContactMotion<Scalar> contact_motion(const Model<Scalar>& model, PointsArg<Scalar> contacts,
                                     VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  const auto k = kinematics<Scalar>(model, q, qd);
  const auto count = 3 * static_cast<Eigen::Index>(contacts.size());
  ContactMotion<Scalar> motion{Vector<Scalar>(count), Vector<Scalar>(count)};
  Eigen::Index row = 0;
  for (const auto& contact : contacts) {
    const int i = contact.body;
    const Vector3<Scalar> arm = k.R_world[i] * contact.p;
    const Vector3<Scalar> w = k.R_world[i] * angular(k.v[i]);
    motion.position.template segment<3>(row) = k.p_world[i] + arm;
    motion.velocity.template segment<3>(row) = k.R_world[i] * linear(k.v[i]) + cross(w, arm);
    row += 3;
  }
  return motion;
}

/// Contact-space inverse inertia, 3k x 3k: the change of each contact's velocity per impulse at
/// each contact, world axes (Lambda_c^-1 of Chang 8.2, with the blocks between contacts from table
/// 5.3).
template <class Scalar>
Matrix<Scalar> contact_inverse_inertia(const Model<Scalar>& model, PointsArg<Scalar> contacts,
                                       VectorArg<Scalar> q) {
  return lambda_inverse<Scalar>(model, contacts, q);
}

/// Mobility n^T Lambda_c^-1 n of each contact along n, 1/kg if n is a unit vector (Chang eq. 8.2).
/// `normals` has three entries for each contact, world axes. Lambda_c^-1 comes from the inverse
/// inertias of all links.
template <class Scalar>
Vector<Scalar> mobilities_along(const Model<Scalar>& model, PointsArg<Scalar> contacts,
                                VectorArg<Scalar> q, VectorArg<Scalar> normals) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const auto Omega = link_inverse_inertias<Scalar>(model, q);
  Vector<Scalar> mobilities(static_cast<Eigen::Index>(contacts.size()));
  for (Eigen::Index i = 0; i < mobilities.size(); ++i) {
    const auto& contact = contacts[static_cast<std::size_t>(i)];
    const Vector6<Scalar> n =
        stack<Scalar>(normals.template segment<3>(3 * i), Vector3<Scalar>::Zero());
    const Vector6<Scalar> on_body = point_transform(contact, k) * n;
    mobilities(i) = on_body.dot(Vector6<Scalar>(Omega[contact.body] * on_body));
  }
  return mobilities;
}

/// Effective mass 1 / (n^T Lambda_c^-1 n) of each contact, kg if n is a unit vector (Chang eq.
/// 8.1): the mass that a blow along n meets. Infinite on a body that cannot move.
template <class Scalar>
Vector<Scalar> effective_masses(const Model<Scalar>& model, PointsArg<Scalar> contacts,
                                VectorArg<Scalar> q, VectorArg<Scalar> normals) {
  return mobilities_along<Scalar>(model, contacts, q, normals).cwiseInverse();
}

/// Effective mass of each contact along n, with the borders of `law`, one per contact: where c is
/// its mobility, 1 / (c + border / (1 + (c / border)^3)), so that the mass grows to 1 / border in
/// directions that cannot move.
template <class Scalar>
Vector<Scalar> effective_masses(const Model<Scalar>& model, PointsArg<Scalar> contacts,
                                VectorArg<Scalar> q, VectorArg<Scalar> normals,
                                const TaskLaw<Scalar>& law) {
  Vector<Scalar> masses = mobilities_along<Scalar>(model, contacts, q, normals);
  for (Eigen::Index i = 0; i < masses.size(); ++i) {
    const Scalar& border = law.borders[static_cast<std::size_t>(i)];
    const Scalar t = masses(i) / border;
    masses(i) = Scalar(1) / (masses(i) + border / (Scalar(1) + t * t * t));
  }
  return masses;
}

/// Impulse along the unit normal `n` that turns the approach n.v < 0 of two bodies into a
/// separation at `restitution` times its speed: y = -(1 + e) (n.v) / (n^T Lambda_c^-1 n) n (Chang
/// eq. 8.3 to 8.7). `mass` is the effective mass along n.
template <class Scalar>
Vector3<Scalar> restitution_impulse(const Vector3<Scalar>& n, const Vector3<Scalar>& velocity,
                                    const std::type_identity_t<Scalar>& mass,
                                    const std::type_identity_t<Scalar>& restitution) {
  return Scalar(-(Scalar(1) + restitution) * n.dot(velocity) * mass) * n;
}

}  // namespace treeline::interpreter
