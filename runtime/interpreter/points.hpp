#pragma once

#include <algorithm>

#include "interpreter/kinematics.hpp"

namespace treeline::interpreter {

template <class Scalar>
Scalar total_mass(const Model<Scalar>& model) {
  Scalar mass(0);
  for (const auto& body : model.bodies) mass += body.mass;
  return mass;
}

template <class Scalar>
bool has_center_of_mass(const Points<Scalar>& points) {
  return std::any_of(points.begin(), points.end(),
                     [](const auto& point) { return point.center_of_mass; });
}

/// A point of one body, and what its motion adds to that of the point of which it is a part.
template <class Scalar>
struct PointPart {
  OperationalPoint<Scalar> point;
  Vector6<Scalar> weights;  ///< by row
};

/// The point itself; of the centre of mass those of all bodies, by their shares of the mass.
template <class Scalar>
std::vector<PointPart<Scalar>> parts_of(const Model<Scalar>& model,
                                        const OperationalPoint<Scalar>& point) {
  std::vector<PointPart<Scalar>> parts;
  if (!point.center_of_mass) {
    parts.push_back({point, Vector6<Scalar>::Ones()});
    return parts;
  }
  for (int i = 0; i < model.size(); ++i) {
    const Body<Scalar>& body = model.body(i);
    const Vector3<Scalar> share = Vector3<Scalar>::Constant(body.mass / total_mass(model));
    parts.push_back({{point.name, i, Matrix3<Scalar>::Identity(), body.com},
                     stack<Scalar>(share, Vector3<Scalar>::Zero())});
  }
  return parts;
}

/// Number of controlled rows of all points together.
template <class Scalar>
int row_count(const Points<Scalar>& points) {
  int count = 0;
  for (const auto& e : points) {
    for (const bool row : e.rows) count += row ? 1 : 0;
  }
  return count;
}

/// Indices of the controlled rows, if each point has six rows.
template <class Scalar>
std::vector<int> controlled_rows(const Points<Scalar>& points) {
  std::vector<int> rows;
  int at = 0;
  for (const auto& e : points) {
    for (const bool row : e.rows) {
      if (row) rows.push_back(at);
      ++at;
    }
  }
  return rows;
}

/// Rotation from the point's axes, its own or the world's, to its body's frame.
template <class Scalar>
Matrix3<Scalar> axes_in_body(const OperationalPoint<Scalar>& point, const Kinematics<Scalar>& k) {
  return point.axes == PointAxes::local ? point.R
                                        : Matrix3<Scalar>(k.R_world[point.body].transpose());
}

/// X_e: maps a force at the point, in its axes, to its body's frame. X_e^T maps motions of the body
/// to motions of the point.
template <class Scalar>
Matrix6<Scalar> point_transform(const OperationalPoint<Scalar>& point,
                                const Kinematics<Scalar>& k) {
  return force_transform(axes_in_body(point, k), point.p);
}

/// Rate of a point's velocity over angular velocity as its axes count it, from the acceleration `a`
/// of its body. In world axes the linear part is the conventional acceleration of the origin; in
/// its own axes, which turn with the body, that less w x v.
template <class Scalar>
Vector6<Scalar> point_acceleration(const OperationalPoint<Scalar>& point,
                                   const Kinematics<Scalar>& k, const Vector6<Scalar>& a) {
  const Matrix3<Scalar> axes = axes_in_body(point, k);
  const Vector3<Scalar> w = angular(k.v[point.body]);
  Vector3<Scalar> origin = linear(a) + cross(angular(a), point.p) + cross(w, cross(w, point.p));
  if (point.axes == PointAxes::local) {
    const Vector3<Scalar> v = linear(k.v[point.body]) + cross(w, point.p);
    origin -= cross(w, v);
  }
  return stack<Scalar>(axes.transpose() * origin, axes.transpose() * angular(a));
}

/// Adds forces at points to the forces on their bodies, in the bodies' frames. `forces` has the
/// controlled rows of each point in turn; all other rows are zero.
template <class Scalar>
void add_point_forces(const Model<Scalar>& model, const Points<Scalar>& points,
                      const Kinematics<Scalar>& k, VectorArg<Scalar> forces,
                      PerBody<Vector6<Scalar>>& on_bodies) {
  assert(forces.size() == row_count(points));
  int at = 0;
  for (const auto& e : points) {
    Vector6<Scalar> f = Vector6<Scalar>::Zero();
    for (int row = 0; row < 6; ++row) {
      if (e.rows[static_cast<std::size_t>(row)]) f(row) = forces(at++);
    }
    for (const auto& part : parts_of(model, e)) {
      on_bodies[part.point.body] +=
          point_transform(part.point, k) * Vector6<Scalar>(part.weights.cwiseProduct(f));
    }
  }
}

}  // namespace treeline::interpreter
