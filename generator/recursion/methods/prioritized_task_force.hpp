#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "recursion/algebra/factor_ldlt.hpp"
#include "recursion/algebra/pivot_rule.hpp"
#include "recursion/tree/tree.hpp"

namespace treeline {

template <class Scalar>
bool has_priorities(const Tree<Scalar>& tree) {
  const auto& points = tree.operational_points;
  return std::any_of(points.begin(), points.end(), [&](const TreePoint<Scalar>& point) {
    return point.priority != points.front().priority;
  });
}

/// A task row in the order of priority, and the border below which it is relaxed.
template <class Scalar>
struct PrioritizedRow {
  std::size_t row = 0;    ///< index in the order of the scene
  Scalar inverse_border;  ///< 1 over the inverse inertia at which half of the command is followed
};

/// Whether some joint moves the link or, with `turning`, rotates it.
template <class Scalar>
bool may_move(const Tree<Scalar>& tree, int link, bool turning) {
  for (int i = link; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
    if (!turning || tree.links[static_cast<std::size_t>(i)].turns_axes()) return true;
  }
  return false;
}

/// Rows in order of priority, the most important first. A row is relaxed if the rows above leave it
/// less than 2^-13 of the inverse inertia that its point has for this kind of motion, translation
/// or rotation. That inverse inertia is a sum over the rows of the kind, which is independent of
/// the axes if all three are controlled. `floor.borders`, if any, has an entry for each row in the
/// order of the scene and keeps the sums from zero if the point itself cannot move.
template <class Scalar>
std::vector<PrioritizedRow<Scalar>> rows_by_priority(const Tree<Scalar>& tree,
                                                     const DenseMatrix<Scalar>& Lambda_inv,
                                                     const PivotRule& floor) {
  constexpr double kInverseBorder = 8192;
  std::vector<PrioritizedRow<Scalar>> rows;
  std::vector<int> priorities;
  for (const TreePoint<Scalar>& point : tree.operational_points) {
    for (const std::size_t first : {0U, 3U}) {
      const auto begin = point.rows.begin() + static_cast<std::ptrdiff_t>(first);
      const auto count = static_cast<std::size_t>(std::count(begin, begin + 3, true));
      const std::size_t at = rows.size();
      Scalar mobility(count > 0 && !floor.borders.empty() ? floor.borders[at] : 0.0);
      for (std::size_t row = at; row < at + count; ++row) {
        mobility = mobility + Lambda_inv(row, row);
      }
      const bool moves = point.center_of_mass || may_move(tree, point.link, first == 3);
      for (std::size_t row = at; row < at + count; ++row) {
        // Rows that nothing can move are relaxed completely.
        rows.push_back({row, moves ? Scalar(kInverseBorder) / mobility : Scalar(0.0)});
        priorities.push_back(point.priority);
      }
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
    return priorities[a.row] < priorities[b.row];
  });
  return rows;
}

/// w / c with the share w = t^8 / (1 + t^8), t = c / border. At c = 0 it is zero instead of
/// infinite.
template <class Scalar>
Scalar relaxed_inverse(const Scalar& c, const Scalar& inverse_border) {
  const Scalar t = c * inverse_border;
  const Scalar t2 = t * t;
  const Scalar t4 = t2 * t2;
  const Scalar t6 = t4 * t2;
  return inverse_border * (t6 * t) / (Scalar(1.0) + t4 * t4);
}

/// Task forces F for tasks of strict priority. If Lambda^-1 is eliminated row by row, the most
/// important first, pivot c_k is the inverse inertia of row k in the dynamically consistent null
/// space of the rows above. So the recursion of prioritised tasks (Khatib, Sentis, Park & Warren
/// 2004) is this elimination, and J^T F is its torque. As long as the rows are independent, all are
/// achieved. For a row that is not, `relaxed_inverse` replaces 1/c_k, and only this row is
/// relaxed. The system that is solved is (Lambda^-1 + diag(c_k (1 - w_k) / w_k)) F = errors, in
/// which the terms of the rows above are zero.
template <class Scalar>
std::vector<Scalar> prioritized_task_force(const Tree<Scalar>& tree,
                                           const DenseMatrix<Scalar>& Lambda_inv,
                                           const std::vector<Scalar>& errors,
                                           const PivotRule& floor = {}) {
  const auto rows = rows_by_priority(tree, Lambda_inv, floor);
  const std::size_t n = rows.size();
  DenseMatrix<Scalar> A(n, n);
  std::vector<Scalar> ordered;
  for (std::size_t i = 0; i < n; ++i) {
    ordered.push_back(errors[rows[i].row]);
    for (std::size_t j = 0; j < n; ++j) {
      A(i, j) = Lambda_inv(rows[i].row, rows[j].row);
    }
  }
  const auto factor = factor_ldlt(std::move(A), [&rows](std::size_t k, const Scalar& c) {
    return relaxed_inverse(c, rows[k].inverse_border);
  });
  const std::vector<Scalar> solved = solve(factor, ordered);
  std::vector<Scalar> F(n);
  for (std::size_t i = 0; i < n; ++i) {
    F[rows[i].row] = solved[i];
  }
  return F;
}

}  // namespace treeline
