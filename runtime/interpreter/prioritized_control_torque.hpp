#pragma once

#include <algorithm>
#include <vector>

#include "interpreter/articulated_inertia.hpp"
#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/jacobian.hpp"
#include "interpreter/mass_matrix.hpp"
#include "interpreter/point_accelerations.hpp"
#include "interpreter/task_shares.hpp"

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
/// gain what the row still lacks, in the dynamically consistent null space N of all rows before:
///     c = J_k N M^-1 J_k^T,  qdd += N M^-1 J_k^T (w/c) (xdd_k - Jd_k qd - J_k qdd),
///     N M^-1 J^T -= N M^-1 J_k^T (w/c) J_k N M^-1 J^T.
/// What tasks with shares lack and what they move is s-fold, and J N M^-1 J^T is `with_shares`.
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
  const TaskShares<Scalar> shares = task_shares<Scalar>(points);
  Matrix<Scalar> moved =
      inverse_of_positive_definite<Scalar>(mass_matrix<Scalar>(model, q)) * J.transpose();
  Matrix<Scalar> A = with_shares<Scalar>(J * moved, shares);
  const Vector<Scalar> borders = relaxation_borders<Scalar>(points, A.diagonal(), floors);
  moved = (moved * shares.s.asDiagonal()).eval();
  Vector<Scalar> lacks =
      shares.s.cwiseProduct(xdd_cmd - bias_acceleration<Scalar>(model, points, q, qd) - J * qdd_0);
  Vector<Scalar> qdd = qdd_0;
  for (const int row : rows_by_priority(points)) {
    const Scalar inverse = relaxed_inverse<Scalar>(A(row, row), borders(row));
    const Scalar f = inverse * lacks(row);
    const Vector<Scalar> couplings = A.col(row);
    qdd += moved.col(row) * f;
    lacks -= couplings * f;
    moved -= (moved.col(row) * (inverse * couplings.transpose())).eval();
    A -= couplings * (inverse * couplings.transpose());
  }
  return inverse_dynamics<Scalar>(model, q, qd, qdd, external_points, f_ext);
}

}  // namespace treeline::interpreter
