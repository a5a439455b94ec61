#pragma once

#include <Eigen/QR>
#include <optional>
#include <vector>

#include "interpreter/joint_parts.hpp"
#include "interpreter/loops.hpp"

namespace treeline::interpreter {

/// Moves coordinates by a velocity over a time. Quaternions keep unit length.
template <class Scalar>
Vector<Scalar> move_coordinates(const Model<Scalar>& model, const Vector<Scalar>& q,
                                const Vector<Scalar>& qd, const Scalar& t) {
  Vector<Scalar> next = q + t * position_derivative<Scalar>(model, q, qd);
  for (const auto& body : model.bodies) {
    const int first = quaternion_of(body);
    if (first >= 0) next.template segment<4>(first).normalize();
  }
  return next;
}

/// The shortest motion of all that come nearest to `asked` in rows of J; Eigen decomposes no matrix
/// without columns, that is of a robot of which nothing may move.
template <class Scalar>
Vector<Scalar> least_motion(const Matrix<Scalar>& J, const Vector<Scalar>& asked) {
  if (J.size() == 0) return Vector<Scalar>::Zero(J.cols());
  return J.completeOrthogonalDecomposition().solve(asked);
}

/// Coordinates near q at which the loops are closed to `tolerance` (m, and the sine of an angle),
/// by Newton's method with the shortest step. Only the velocities that `free` lists move. Steps are
/// bounded, so that a guess from afar does not wind joints up. Nothing where 60 steps do not do.
template <class Scalar>
std::optional<Vector<Scalar>> close_loops(const Model<Scalar>& model, const Loops<Scalar>& loops,
                                          Vector<Scalar> q, const std::vector<int>& free,
                                          const Scalar& tolerance) {
  const Scalar longest(0.5);  // m or rad
  for (int step = 0; step < 60; ++step) {
    const Vector<Scalar> errors = loop_errors<Scalar>(model, loops, q);
    if (errors.size() == 0 || errors.cwiseAbs().maxCoeff() <= tolerance) return q;
    const Matrix<Scalar> J = loop_jacobian<Scalar>(model, loops, q)(Eigen::all, free);
    const Vector<Scalar> change = least_motion<Scalar>(J, errors);
    const Scalar size = change.norm();
    Vector<Scalar> qd = Vector<Scalar>::Zero(model.nv);
    qd(free) = -change * (size > longest ? Scalar(longest / size) : Scalar(1));
    q = move_coordinates<Scalar>(model, q, qd, Scalar(1));
  }
  return std::nullopt;
}

}  // namespace treeline::interpreter
