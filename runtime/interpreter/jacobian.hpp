#pragma once

#include "interpreter/points.hpp"

namespace treeline::interpreter {

namespace detail {

template <class Scalar>
Matrix<Scalar> all_rows_jacobian(const Model<Scalar>& model, const Points<Scalar>& points,
                                 const Kinematics<Scalar>& k) {
  Matrix<Scalar> J = Matrix<Scalar>::Zero(6 * static_cast<int>(points.size()), model.nv);
  int row = 0;
  for (const auto& e : points) {
    for (const auto& part : parts_of(model, e)) {
      Matrix6<Scalar> to_point =
          part.weights.asDiagonal() * point_transform(part.point, k).transpose();
      for (int i = part.point.body; i != kWorld; i = model.body(i).parent) {
        const Body<Scalar>& body = model.body(i);
        J.block(row, body.v, 6, k.S[i].cols()) += body.multiplier * (to_point * k.S[i]);
        to_point = (to_point * k.X[i].transpose()).eval();
      }
    }
    row += 6;
  }
  return J;
}

}  // namespace detail

/// J, rows x nv: the controlled rows of all points stacked, such that J qd is the velocity of each
/// origin over its angular velocity, in each point's axes. Columns are X_e^T X^T ... S, from the
/// point inward.
template <class Scalar>
Matrix<Scalar> jacobian(const Model<Scalar>& model, PointsArg<Scalar> points, VectorArg<Scalar> q) {
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  return detail::all_rows_jacobian<Scalar>(model, points, k)(controlled_rows<Scalar>(points),
                                                             Eigen::all);
}

}  // namespace treeline::interpreter
