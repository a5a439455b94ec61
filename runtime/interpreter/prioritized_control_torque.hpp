#pragma once

#include <algorithm>
#include <vector>

#include "interpreter/articulated_inertia.hpp"
#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/jacobian.hpp"
#include "interpreter/mass_matrix.hpp"
#include "interpreter/point_accelerations.hpp"

namespace treeline::interpreter {

/// Whether the points differ in priority.
template <class Scalar>
bool has_priorities(const Points<Scalar>& points) {
  return std::any_of(points.begin(), points.end(),
                     [&](const auto& point) { return point.priority != points.front().priority; });
}

/// Rows of the tasks in order of priority: by their points' priority, and for equal priority in the
/// order of the points.
template <class Scalar>
std::vector<int> rows_by_priority(const Points<Scalar>& points) {
  std::vector<int> priorities;
  for (const auto& point : points) {
    for (const bool row : point.rows) {
      if (row) priorities.push_back(point.priority);
    }
  }
  std::vector<int> rows(priorities.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<int>(i);
  std::stable_sort(rows.begin(), rows.end(), [&](int a, int b) {
    return priorities[static_cast<std::size_t>(a)] < priorities[static_cast<std::size_t>(b)];
  });
  return rows;
}

/// Borders of inverse inertia below which rows are relaxed: 2^-13 of the inverse inertia that the
/// point has for this kind of motion, which is the sum of `mobilities` (the diagonal of Lambda^-1)
/// over its rows of translation or of rotation. This sum does not depend on the axes if all three
/// are controlled. `floors`, if any, has one entry per row; it is added to the sum, so that the
/// border does not vanish together with it.
template <class Scalar>
Vector<Scalar> relaxation_borders(const Points<Scalar>& points, VectorArg<Scalar> mobilities,
                                  const std::vector<Scalar>& floors = {}) {
  Vector<Scalar> borders(mobilities.size());
  int at = 0;
  for (const auto& point : points) {
    for (const auto& [first, last] : {std::pair{0U, 3U}, std::pair{3U, 6U}}) {
      const auto count =
          static_cast<int>(std::count(point.rows.begin() + first, point.rows.begin() + last, true));
      if (count == 0) continue;
      Scalar sum = mobilities.segment(at, count).sum();
      if (!floors.empty()) sum += floors[static_cast<std::size_t>(at)];
      borders.segment(at, count).setConstant(sum / Scalar(8192));
      at += count;
    }
  }
  return borders;
}

/// w / c with the share w = t^8 / (1 + t^8), t = c / border, for a row whose inverse inertia in the
/// null space of the rows above it is c.
template <class Scalar>
Scalar relaxed_inverse(const Scalar& c, const Scalar& border) {
  if (border == 0) return Scalar(0);  // nothing can move this row
  const Scalar t = c / border;
  const Scalar t7 = t * t * t * t * t * t * t;
  return t7 / (border * (Scalar(1) + t7 * t));
}

/// Control torque of tasks in strict priority: by the points' `priority`, 1 first, and within a
/// level in the order of rows. The joint accelerations qdd start as the posture's. Row by row they
/// gain what the row still lacks, in the dynamically consistent null space of all rows before:
///     c = J_k N M^-1 J_k^T,  qdd += N M^-1 J_k^T (w/c) (xdd_k - Jd_k qd - J_k qdd),
///     N M^-1 -= N M^-1 J_k^T (w/c) J_k N M^-1.
/// Then tau = M qdd + b + g - J_ext^T f_ext (Khatib, Sentis, Park & Warren 2004, for rows as
/// tasks). By the Sherman-Morrison formula this equals J^T F with (Lambda^-1 + diag(c (1 - w)/w)) F
/// = what all rows lack. If all rows are independent it is Chang's table 6.1 in any order. If a row
/// depends on rows above it, c falls below its border (`relaxation_borders`), its share w goes from
/// 1 to 0, and only this row is relaxed; rows above are not affected.
template <class Scalar>
Vector<Scalar> prioritized_control_torque(const Model<Scalar>& model, PointsArg<Scalar> points,
                                          VectorArg<Scalar> q, VectorArg<Scalar> qd,
                                          VectorArg<Scalar> qdd_0, VectorArg<Scalar> xdd_cmd,
                                          PointsArg<Scalar> external_points,
                                          VectorArg<Scalar> f_ext,
                                          const std::vector<Scalar>& floors = {}) {
  const Matrix<Scalar> J = jacobian<Scalar>(model, points, q);
  Matrix<Scalar> NM_inverse = inverse_of_positive_definite<Scalar>(mass_matrix<Scalar>(model, q));
  const Vector<Scalar> mobilities = (J * NM_inverse * J.transpose()).diagonal();
  const Vector<Scalar> borders = relaxation_borders<Scalar>(points, mobilities, floors);
  const Vector<Scalar> wanted = xdd_cmd - bias_acceleration<Scalar>(model, points, q, qd);
  Vector<Scalar> qdd = qdd_0;
  for (const int row : rows_by_priority(points)) {
    const Vector<Scalar> moved = NM_inverse * J.row(row).transpose();
    const Scalar c = J.row(row).dot(moved);
    const Scalar lacks = wanted(row) - J.row(row).dot(qdd);
    const Scalar inverse = relaxed_inverse<Scalar>(c, borders(row));
    qdd += moved * Scalar(inverse * lacks);
    NM_inverse -= moved * (inverse * moved.transpose());
  }
  return inverse_dynamics<Scalar>(model, q, qd, qdd, external_points, f_ext);
}

}  // namespace treeline::interpreter
