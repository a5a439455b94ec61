#pragma once

#include <Eigen/Core>
#include <vector>

#include "mechanism/digits50_matrices.hpp"

namespace treeline {

using Digits50Row = Eigen::Matrix<Digits50, 1, Eigen::Dynamic>;
using Digits50Rows = Eigen::Matrix<Digits50, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A space of rows, by an orthonormal basis that grows.
class RowSpace {
 public:
  /// Rows count as members that are nearer to the space than `tolerance`.
  explicit RowSpace(const Digits50& tolerance) : tolerance_(tolerance) {}

  /// Adds a row to the basis, and returns whether it was no member.
  bool add(const Digits50Row& row);
  [[nodiscard]] const std::vector<Digits50Row>& basis() const { return basis_; }

 private:
  Digits50 tolerance_;
  std::vector<Digits50Row> basis_;
};

/// Rows reduced so that each has a column in which all other rows are zero, and it is one.
struct ReducedRows {
  std::vector<int> pivots;  ///< that column of each row
  Digits50Rows rows;
};

/// Gauss-Jordan elimination. Of the columns whose remaining part is not much smaller than the
/// largest, the next pivot is the first in the order `preferred`. What remains at the end is at
/// most `tolerance`.
ReducedRows reduce(Digits50Rows rows, const std::vector<int>& preferred, const Digits50& tolerance);

}  // namespace treeline
