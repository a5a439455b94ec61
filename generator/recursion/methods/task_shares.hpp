#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/tree/tree.hpp"

namespace treeline {

/// The rows of a system whose tasks are done in part, each point's to a share s of 0 to 1. Its
/// forces act s-fold, it sees s-fold what it lacks, and a compliance (1 - s^2) / s^2 of its own
/// inverse inertia makes up for that. Multiplied out, A = Lambda^-1 keeps the blocks of its points,
/// and what couples points i and j becomes s_i s_j-fold:
///     F = S A'^-1 S errors,  A'_ii = A_ii,  A'_ij = s_i s_j A_ij.
/// So no pivot vanishes and nothing is divided by a share. With s = 1 the values are those without
/// shares, to the bit. With s = 0 the forces are 0, and all others are as if there were no such
/// task. This holds in the axes and at the reference point of any basis.
template <class Scalar>
class TaskShares {
 public:
  TaskShares() = default;
  /// The rows of the tree's points, whose first `anchored` are followed by `loops` rows of loops.
  explicit TaskShares(const Tree<Scalar>& tree, std::size_t anchored = 0, std::size_t loops = 0) {
    const auto& points = tree.operational_points;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto count = std::count(points[k].rows.begin(), points[k].rows.end(), true);
      rows_.insert(rows_.end(), static_cast<std::size_t>(count), {points[k].share, k});
    }
    rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(anchored), loops,
                 {Scalar(1.0), points.size()});
  }

  /// A' of the symmetric A.
  [[nodiscard]] DenseMatrix<Scalar> weakened(DenseMatrix<Scalar> A) const {
    for (std::size_t i = 0; i < A.rows(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (rows_[i].point == rows_[j].point) continue;
        const Scalar both = rows_[i].share * rows_[j].share;
        A(i, j) = A(i, j) * both;
        A(j, i) = A(j, i) * both;
      }
    }
    return A;
  }

  /// S x.
  [[nodiscard]] std::vector<Scalar> times(std::vector<Scalar> x) const {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = rows_[i].share * x[i];
    return x;
  }

 private:
  struct Row {
    Scalar share;
    std::size_t point;
  };
  std::vector<Row> rows_;
};

}  // namespace treeline
