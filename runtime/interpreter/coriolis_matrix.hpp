#pragma once

#include "interpreter/derivatives.hpp"

namespace treeline::interpreter {

namespace detail {

/// [a, b] of two motions that keep their components in the moving axes of the joint: the twist
/// [w_a x v_b - w_b x v_a; w_a x w_b] of a floating joint, w_a x w_b of a spherical one. Zero for
/// all others, whose velocities are the derivatives of their coordinates.
template <class Scalar>
JointVector<Scalar> bracket(JointKind kind, const JointVector<Scalar>& a,
                            const JointVector<Scalar>& b) {
  JointVector<Scalar> result = JointVector<Scalar>::Zero(a.size());
  if (kind != JointKind::floating && kind != JointKind::spherical) return result;
  const Vector3<Scalar> w_a = a.template tail<3>();
  const Vector3<Scalar> w_b = b.template tail<3>();
  result.template tail<3>() = cross(w_a, w_b);
  if (kind == JointKind::floating) {
    const Vector3<Scalar> v_a = a.template head<3>();
    const Vector3<Scalar> v_b = b.template head<3>();
    result.template head<3>() = cross(w_a, v_b) - cross(w_b, v_a);
  }
  return result;
}

/// Entry (i, j): [a, e_j]_i, with a unit velocity e_j.
template <class Scalar>
Matrix<Scalar> brackets_with(const Model<Scalar>& model, const Vector<Scalar>& a) {
  Matrix<Scalar> result = Matrix<Scalar>::Zero(model.nv, model.nv);
  for (const auto& body : model.bodies) {
    if (body.mimics) continue;
    const int n = velocity_count(body.kind);
    const JointVector<Scalar> own = a.segment(body.v, n);
    for (int j = 0; j < n; ++j) {
      const JointVector<Scalar> unit = JointVector<Scalar>::Unit(n, j);
      result.col(body.v + j).segment(body.v, n) = bracket<Scalar>(body.kind, own, unit);
    }
  }
  return result;
}

/// Entry (i, j): p . [e_j, e_i].
template <class Scalar>
Matrix<Scalar> projected_brackets(const Model<Scalar>& model, const Vector<Scalar>& p) {
  Matrix<Scalar> result(model.nv, model.nv);
  for (Eigen::Index j = 0; j < model.nv; ++j) {
    const Vector<Scalar> unit = Vector<Scalar>::Unit(model.nv, j);
    result.col(j) = brackets_with<Scalar>(model, unit).transpose() * p;
  }
  return result;
}

}  // namespace detail

/// C, nv x nv: C qd = b, and dM/dt - 2 C is skew-symmetric. The Christoffel symbols of M, whose
/// derivatives come from dual numbers, times qd; with the brackets of those velocities that are not
/// derivatives of coordinates (Koszul's formula):
/// 2 C_ij = (dM/dt)_ij + d_j (M qd)_i - d_i (M qd)_j
///          + e_i . M [qd, e_j] - e_j . M [qd, e_i] - qd . M [e_j, e_i].
template <class Scalar>
Matrix<Scalar> coriolis_matrix(const Model<Scalar>& model, VectorArg<Scalar> q,
                               VectorArg<Scalar> qd) {
  using Number = Dual<Scalar>;
  const Model<Number> lifted = cast<Number>(model);
  Matrix<Scalar> rate = Matrix<Scalar>::Zero(model.nv, model.nv);
  Matrix<Scalar> momentum_slopes(model.nv, model.nv);  // column j: d_j (M qd), qd held
  for (Eigen::Index j = 0; j < model.nv; ++j) {
    const Matrix<Number> moving =
        mass_matrix<Number>(lifted, detail::displaced<Scalar>(model, q, j));
    const Matrix<Scalar> slope = moving.unaryExpr([](const Number& x) { return x.slope; });
    rate += slope * qd(j);
    momentum_slopes.col(j) = slope * qd;
  }
  const Matrix<Scalar> M = mass_matrix<Scalar>(model, q);
  const Matrix<Scalar> turned = M * detail::brackets_with<Scalar>(model, qd);
  const Vector<Scalar> momentum = M * qd;
  const Matrix<Scalar> twice = rate + momentum_slopes - momentum_slopes.transpose() + turned -
                               turned.transpose() -
                               detail::projected_brackets<Scalar>(model, momentum);
  return twice / Scalar(2);
}

}  // namespace treeline::interpreter
