#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "recursion/factor_ldlt.hpp"
#include "recursion/pivot_rule.hpp"
#include "recursion/tree.hpp"

namespace treeline {

template <class Scalar>
bool has_priorities(const Tree<Scalar>& tree) {
  const auto& points = tree.operational_points;
  return std::any_of(points.begin(), points.end(), [&](const TreePoint<Scalar>& point) {
    return point.priority != points.front().priority;
  });
}

/// A task row's place in the stack: what comes first of all rows, and what share it yields below.
template <class Scalar>
struct PrioritizedRow {
  std::size_t row = 0;    ///< in the order of the scene
  Scalar inverse_border;  ///< 1 over the inverse inertia at which half of the row has yielded
};

/// Whether some joint turns the link, or moves it at all.
template <class Scalar>
bool may_move(const Tree<Scalar>& tree, int link, bool turning) {
  for (int i = link; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
    if (!turning || tree.links[static_cast<std::size_t>(i)].kind != JointKind::prismatic) {
      return true;
    }
  }
  return false;
}

/// The rows with the most important first. A row yields where what the rows above leave of its
/// inverse inertia is 2^-13 of what its point has of its kind, translation or rotation: sums over
/// rows of one kind, which no rotation of the axes changes if all three are controlled. Where the
/// point itself cannot move so, `floor.borders`, if any, keep the sums from zero, one for each row
/// in the order of the scene.
template <class Scalar>
std::vector<PrioritizedRow<Scalar>> rows_by_priority(const Tree<Scalar>& tree,
                                                     const DenseMatrix<Scalar>& Lambda_inv,
                                                     const PivotRule& floor) {
  constexpr double kYield = 8192;
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
      const bool moves = may_move(tree, point.link, first == 3);
      for (std::size_t row = at; row < at + count; ++row) {
        // The rows of what nothing moves yield altogether.
        rows.push_back({row, moves ? Scalar(kYield) / mobility : Scalar(0.0)});
        priorities.push_back(point.priority);
      }
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
    return priorities[a.row] < priorities[b.row];
  });
  return rows;
}

/// w / c with the share w = t^8 / (1 + t^8), t = c / border; zero, not infinite, at c = 0.
template <class Scalar>
Scalar yielding_inverse(const Scalar& c, const Scalar& inverse_border) {
  const Scalar t = c * inverse_border;
  const Scalar t2 = t * t;
  const Scalar t4 = t2 * t2;
  const Scalar t6 = t4 * t2;
  return inverse_border * (t6 * t) / (Scalar(1.0) + t4 * t4);
}

/// F of tasks in strict priority. Eliminating Lambda^-1 row by row, the most important first, makes
/// pivot c_k the inverse inertia of row k in the dynamically consistent null space of the rows
/// above: the recursion of prioritised tasks (Khatib, Sentis, Park & Warren 2004) is this
/// elimination, and J^T F its torque. While the rows are independent all are achieved. A row that
/// is not gets `yielding_inverse` for 1/c_k and yields alone: what is solved is
/// (Lambda^-1 + diag(c_k (1 - w_k) / w_k)) F = errors, in which the terms of rows above are zero.
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
    return yielding_inverse(c, rows[k].inverse_border);
  });
  const std::vector<Scalar> solved = solve(factor, ordered);
  std::vector<Scalar> F(n);
  for (std::size_t i = 0; i < n; ++i) {
    F[rows[i].row] = solved[i];
  }
  return F;
}

}  // namespace treeline
