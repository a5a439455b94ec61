#pragma once

#include "interpreter/articulated_inertia.hpp"
#include "interpreter/lambda_inverse.hpp"
#include "interpreter/mass_matrix.hpp"
#include "interpreter/point_accelerations.hpp"

namespace treeline::interpreter {

/// Returns the points with all six rows, in world axes.
template <class Scalar>
Points<Scalar> with_all_rows(Points<Scalar> points) {
  for (auto& point : points) {
    point.rows.fill(true);
    point.axes = PointAxes::world;
  }
  return points;
}

/// [v; w] of every point, world axes: all six rows of J qd.
template <class Scalar>
Vector<Scalar> point_velocity(const Model<Scalar>& model, PointsArg<Scalar> points,
                              VectorArg<Scalar> q, VectorArg<Scalar> qd) {
  return jacobian<Scalar>(model, with_all_rows<Scalar>(points), q) * qd;
}

/// [dv/dt; dw/dt] of every point, world axes, without gravity: all six rows of J qdd + Jd qd.
template <class Scalar>
Vector<Scalar> point_acceleration(const Model<Scalar>& model, PointsArg<Scalar> points,
                                  VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                  VectorArg<Scalar> qdd) {
  return point_accelerations<Scalar>(model, with_all_rows<Scalar>(points), q, qd, qdd);
}

/// Lambda with rows relaxed by `law`; with the default law the plain inverse of J M^-1 J^T.
template <class Scalar>
Matrix<Scalar> lambda_as_ruled(const Model<Scalar>& model, PointsArg<Scalar> points,
                               VectorArg<Scalar> q, const TaskLaw<Scalar>& law) {
  return law.borders.empty() ? lambda<Scalar>(model, points, q)
                             : lambda<Scalar>(model, points, q, law);
}

/// Jbar = M^-1 J^T Lambda, nv x rows, by its definition (Khatib 1987; Chang sect. 2.2): the inverse
/// of J that is dynamically consistent.
template <class Scalar>
Matrix<Scalar> dynamically_consistent_inverse(const Model<Scalar>& model, PointsArg<Scalar> points,
                                              VectorArg<Scalar> q,
                                              const TaskLaw<Scalar>& law = {}) {
  const Matrix<Scalar> J = jacobian<Scalar>(model, points, q);
  const Matrix<Scalar> M = mass_matrix<Scalar>(model, q);
  const Matrix<Scalar> columns = M.ldlt().solve(Matrix<Scalar>(J.transpose()));
  return columns * lambda_as_ruled<Scalar>(model, points, q, law);
}

/// N = 1 - Jbar J, nv x nv. The torques N^T tau_0 of a posture do not accelerate the task.
template <class Scalar>
Matrix<Scalar> null_space_projector(const Model<Scalar>& model, PointsArg<Scalar> points,
                                    VectorArg<Scalar> q, const TaskLaw<Scalar>& law = {}) {
  return Matrix<Scalar>::Identity(model.nv, model.nv) -
         dynamically_consistent_inverse<Scalar>(model, points, q, law) *
             jacobian<Scalar>(model, points, q);
}

/// mu = Jbar^T b - Lambda Jd qd, without gravity, by its definition (Khatib 1987).
template <class Scalar>
Vector<Scalar> operational_bias_force(const Model<Scalar>& model, PointsArg<Scalar> points,
                                      VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                      const TaskLaw<Scalar>& law = {}) {
  const Vector<Scalar> b = nonlinear_effects<Scalar>(without_gravity<Scalar>(model), q, qd);
  return dynamically_consistent_inverse<Scalar>(model, points, q, law).transpose() * b -
         lambda_as_ruled<Scalar>(model, points, q, law) *
             bias_acceleration<Scalar>(model, points, q, qd);
}

/// p = Jbar^T g.
template <class Scalar>
Vector<Scalar> operational_gravity(const Model<Scalar>& model, PointsArg<Scalar> points,
                                   VectorArg<Scalar> q, const TaskLaw<Scalar>& law = {}) {
  return dynamically_consistent_inverse<Scalar>(model, points, q, law).transpose() *
         gravity<Scalar>(model, q);
}

}  // namespace treeline::interpreter
