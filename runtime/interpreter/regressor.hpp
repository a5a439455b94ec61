#pragma once

#include <vector>

#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/joint_forces.hpp"

namespace treeline::interpreter {

/// One number on which joint forces depend linearly.
struct UnitParameter {
  enum class Kind {
    inertial,  ///< one of m, m c_x y z, Ixx Ixy Iyy Ixz Iyz Izz about the origin of a body's frame
    rotor,     ///< armature of a body's joint
    viscous,   ///< viscous friction of a body's joint
    coulomb    ///< Coulomb friction of a body's joint
  };
  Kind kind = Kind::inertial;
  int body = 0;
  int entry = 0;          ///< which of the ten
  double slip_speed = 0;  ///< of Coulomb friction: the width of its smooth sign
};

namespace detail {

/// An inertia of which one parameter is one and all others are zero, which no body has.
template <class Scalar>
struct UnitInertia {
  explicit UnitInertia(int entry) {
    if (entry == 0) mass = Scalar(1);
    if (entry > 0 && entry < 4) h(entry - 1) = Scalar(1);
    for (int j = 0, at = 4; j < 3; ++j) {
      for (int i = 0; i <= j; ++i, ++at) {
        if (at == entry) J(i, j) = J(j, i) = Scalar(1);
      }
    }
    I = spatial_inertia<Scalar>(mass, Vector3<Scalar>::Zero(), J);
    I.template topRightCorner<3, 3>() = -cross_matrix(h);
    I.template bottomLeftCorner<3, 3>() = cross_matrix(h);
  }

  Scalar mass = Scalar(0);
  Vector3<Scalar> h = Vector3<Scalar>::Zero();
  Matrix3<Scalar> J = Matrix3<Scalar>::Zero();
  Matrix6<Scalar> I;
};

/// Adds S^T f of all joints between a force on a body and the world.
template <class Scalar, class Column>
void project_force_inward(const Model<Scalar>& model, const Kinematics<Scalar>& k, int body,
                          Vector6<Scalar> f, Column tau) {
  for (int i = body; i != kWorld; i = model.body(i).parent) {
    tau.segment(model.body(i).v, k.S[i].cols()) +=
        model.body(i).multiplier * (k.S[i].transpose() * f);
    f = (k.X[i] * f).eval();
  }
}

}  // namespace detail

/// Y of M qdd + b + g = Y p, nv x parameters: of each column the joint forces that move a body with
/// this unit parameter, carried along by the others, which have none.
template <class Scalar>
Matrix<Scalar> inverse_dynamics_regressor(const Model<Scalar>& model,
                                          const std::vector<UnitParameter>& parameters,
                                          VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                          VectorArg<Scalar> qdd) {
  const auto k = kinematics<Scalar>(model, q, qd);
  const auto a = accelerations<Scalar>(model, k, qdd, -model.gravity);
  Matrix<Scalar> Y = Matrix<Scalar>::Zero(model.nv, static_cast<Eigen::Index>(parameters.size()));
  for (Eigen::Index c = 0; c < Y.cols(); ++c) {
    const UnitParameter& unit = parameters[static_cast<std::size_t>(c)];
    const Body<Scalar>& owner = model.body(unit.body);
    if (unit.kind != UnitParameter::Kind::inertial) {
      const bool is_rotor = unit.kind == UnitParameter::Kind::rotor;
      auto own = Y.col(c).segment(owner.v, velocity_count(owner.kind));
      own = joint_velocity<Scalar>(owner, is_rotor ? qdd : qd);
      if (unit.kind == UnitParameter::Kind::coulomb) {
        own(0) = interpreter::smooth_sign<Scalar>(own(0) / Scalar(unit.slip_speed));
      }
      own *= owner.multiplier;
      continue;
    }
    const detail::UnitInertia<Scalar> inertia(unit.entry);
    const Vector3<Scalar> w = angular(k.v[unit.body]);
    const Vector6<Scalar> f =
        inertia.I * a[unit.body] +
        stack<Scalar>(cross<Scalar>(w, cross(w, inertia.h)), cross<Scalar>(w, inertia.J * w));
    detail::project_force_inward<Scalar>(model, k, unit.body, f, Y.col(c));
  }
  return Y;
}

/// E of [T; U] = E p, 2 x parameters: kinetic energy V^T I V / 2 over potential energy, which is
/// zero with all mass at the world's origin. Nothing for friction.
template <class Scalar>
Matrix<Scalar> energy_regressor(const Model<Scalar>& model,
                                const std::vector<UnitParameter>& parameters, VectorArg<Scalar> q,
                                VectorArg<Scalar> qd) {
  const auto k = kinematics<Scalar>(model, q, qd);
  Matrix<Scalar> E = Matrix<Scalar>::Zero(2, static_cast<Eigen::Index>(parameters.size()));
  for (Eigen::Index c = 0; c < E.cols(); ++c) {
    const UnitParameter& unit = parameters[static_cast<std::size_t>(c)];
    if (unit.kind == UnitParameter::Kind::viscous || unit.kind == UnitParameter::Kind::coulomb) {
      continue;
    }
    if (unit.kind == UnitParameter::Kind::rotor) {
      const Body<Scalar>& owner = model.body(unit.body);
      E(0, c) = joint_velocity<Scalar>(owner, qd).squaredNorm() / Scalar(2);
      continue;
    }
    const Vector6<Scalar>& V = k.v[unit.body];
    const detail::UnitInertia<Scalar> inertia(unit.entry);
    const Vector3<Scalar> moment =
        inertia.mass * k.p_world[unit.body] + k.R_world[unit.body] * inertia.h;
    E(0, c) = V.dot(inertia.I * V) / Scalar(2);
    E(1, c) = -model.gravity.dot(moment);
  }
  return E;
}

}  // namespace treeline::interpreter
