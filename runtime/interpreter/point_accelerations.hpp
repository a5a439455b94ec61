#pragma once

#include "interpreter/points.hpp"

namespace treeline::interpreter {

/// xdd = J qdd + Jd qd by one outward recursion (Chang eq. 6.11, 6.12), without gravity: the rates
/// of the velocities in the controlled rows of all points, stacked, linear over angular.
template <class Scalar>
Vector<Scalar> point_accelerations(const Model<Scalar>& model, PointsArg<Scalar> points,
                                   VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                   VectorArg<Scalar> qdd) {
  const auto k = kinematics<Scalar>(model, q, qd);
  const auto a = accelerations<Scalar>(model, k, qdd, Vector3<Scalar>::Zero());
  Vector<Scalar> xdd = Vector<Scalar>::Zero(6 * static_cast<int>(points.size()));
  int row = 0;
  for (const auto& e : points) {
    for (const auto& [part, weights] : parts_of(model, e)) {
      xdd.template segment<6>(row) +=
          weights.cwiseProduct(point_acceleration(part, k, a[part.body]));
    }
    row += 6;
  }
  return xdd(controlled_rows<Scalar>(points));
}

/// Jd qd: the accelerations of the points' controlled rows at qdd = 0, without gravity.
template <class Scalar>
Vector<Scalar> bias_acceleration(const Model<Scalar>& model, PointsArg<Scalar> points,
                                 VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  return point_accelerations<Scalar>(model, points, q, qd, Vector<Scalar>::Zero(model.nv));
}

}  // namespace treeline::interpreter
