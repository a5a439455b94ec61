#pragma once

#include <utility>
#include <vector>

#include "interpreter/jacobian.hpp"
#include "interpreter/points.hpp"

namespace treeline::interpreter {

/// Axes of one point's rows in a law, all in the world: linear rows are along the rows of `linear`
/// at the point moved by `shift`, angular rows along those of `angular`.
template <class Scalar>
struct LawFrame {
  Matrix3<Scalar> linear = Matrix3<Scalar>::Identity();
  Matrix3<Scalar> angular = Matrix3<Scalar>::Identity();
  Vector3<Scalar> shift = Vector3<Scalar>::Zero();
};

/// Law for task forces near singularities. Row by row, in the coordinates of `frames`, the row's
/// inverse inertia while the rows before it are held is inverted by `bounded_inverse`. Where it
/// vanishes the row is relaxed, and only this row. Without borders every inverse is the plain one.
template <class Scalar>
struct TaskLaw {
  int power = 2;
  std::vector<Scalar> borders;           ///< one per row; 0: plain inverse
  std::vector<LawFrame<Scalar>> frames;  ///< one per point; empty: the rows of the points
  /// Row and column of each pivot of a square Jacobian. If there are any, J is eliminated.
  std::vector<std::pair<int, int>> pivots;
};

template <class To, class From>
TaskLaw<To> cast(const TaskLaw<From>& law) {
  const auto to = [](const From& x) { return static_cast<To>(x); };
  TaskLaw<To> result{law.power, {}, {}, law.pivots};
  for (const From& border : law.borders) result.borders.push_back(to(border));
  for (const auto& frame : law.frames) {
    result.frames.push_back(
        {frame.linear.unaryExpr(to), frame.angular.unaryExpr(to), frame.shift.unaryExpr(to)});
  }
  return result;
}

/// w / c with the share w = t^power / (1 + t^power), t = c / border: 1/c far above the border,
/// almost zero far below.
template <class Scalar>
Scalar bounded_inverse(const Scalar& c, const Scalar& border, int power) {
  if (border == Scalar(0)) return Scalar(1) / c;
  const Scalar t = c / border;
  Scalar below(1);
  for (int i = 1; i < power; ++i) below *= t;
  return below / (border * (Scalar(1) + below * t));
}

/// Lambda of a symmetric A = Lambda^-1 by bordering. With Lambda of the first k rows and the next
/// row [a^T d], c = d - a^T Lambda a is this row's inverse inertia while the first k are held. If c
/// is replaced (its inverse is g), the result is the inverse of A + diag(1 / g - c). The first rows
/// are held to shares w of 0 to 1, if there are any: each has the compliance (1 - w) / w d.
template <class Scalar>
Matrix<Scalar> bordered_inverse(const Matrix<Scalar>& A, const TaskLaw<Scalar>& law,
                                const Vector<Scalar>& shares = {}) {
  const Eigen::Index n = A.rows();
  Matrix<Scalar> Lambda = Matrix<Scalar>::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Vector<Scalar> a = A.col(k).head(k);
    const Vector<Scalar> u = Lambda.topLeftCorner(k, k) * a;
    const Scalar c = A(k, k) - a.dot(u);
    const Scalar border =
        law.borders.empty() ? Scalar(0) : law.borders[static_cast<std::size_t>(k)];
    const Scalar w = k < shares.size() ? shares(k) : Scalar(1);
    const Scalar g =
        w * bounded_inverse<Scalar>(w * c + (Scalar(1) - w) * A(k, k), border, law.power);
    Lambda.topLeftCorner(k, k) += g * (u * u.transpose());
    Lambda.col(k).head(k) = -g * u;
    Lambda.row(k).head(k) = -g * u.transpose();
    Lambda(k, k) = g;
  }
  return Lambda;
}

/// T: maps the points' rows to the law's rows. Points with other axes than their own must control
/// whole triples of rows.
template <class Scalar>
Matrix<Scalar> law_rows(const Model<Scalar>& model, PointsArg<Scalar> points, VectorArg<Scalar> q,
                        const TaskLaw<Scalar>& law) {
  const int rows = row_count<Scalar>(points);
  Matrix<Scalar> T = Matrix<Scalar>::Identity(rows, rows);
  if (law.frames.empty()) return T;
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  int at = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& point = points[i];
    const LawFrame<Scalar>& frame = law.frames[i];
    const Matrix3<Scalar> asked = point.axes == PointAxes::world
                                      ? Matrix3<Scalar>::Identity()
                                      : Matrix3<Scalar>(k.R_world[point.body] * point.R);
    const int angular = at + (point.rows[0] ? 3 : 0);
    if (point.rows[0]) T.template block<3, 3>(at, at) = frame.linear * asked;
    if (point.rows[3]) T.template block<3, 3>(angular, angular) = frame.angular * asked;
    if (point.rows[0] && point.rows[3]) {
      // u . (v + w x s) = u . v + (s x u) . w
      const Matrix3<Scalar> turned = cross_matrix(frame.shift) * frame.linear.transpose();
      T.template block<3, 3>(at, angular) = turned.transpose() * asked;
    }
    at = angular + (point.rows[3] ? 3 : 0);
  }
  return T;
}

/// Solves J x = v with a square J by elimination in the order of the law's pivots.
template <class Scalar>
Vector<Scalar> solve_by_pivots(Matrix<Scalar> J, Vector<Scalar> v, const TaskLaw<Scalar>& law) {
  const std::size_t n = law.pivots.size();
  std::vector<Scalar> inverse(n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto [r, c] = law.pivots[k];
    const Scalar border = law.borders.empty() ? Scalar(0) : law.borders[k];
    inverse[k] = bounded_inverse<Scalar>(J(r, c), border, law.power);
    for (std::size_t l = k + 1; l < n; ++l) {
      const int i = law.pivots[l].first;
      const Scalar factor = J(i, c) * inverse[k];
      J.row(i) -= factor * J.row(r);
      v(i) -= factor * v(r);
    }
  }
  Vector<Scalar> x = Vector<Scalar>::Zero(v.size());
  for (std::size_t k = n; k-- > 0;) {
    const auto [r, c] = law.pivots[k];
    Scalar rest = v(r);
    for (std::size_t l = k + 1; l < n; ++l) {
      rest -= J(r, law.pivots[l].second) * x(law.pivots[l].second);
    }
    x(c) = inverse[k] * rest;
  }
  return x;
}

}  // namespace treeline::interpreter
