#pragma once

#include <Eigen/Core>
#include <vector>

#include "mechanism/exact.hpp"

namespace treeline {

using ExactRow = Eigen::Matrix<Exact, 1, Eigen::Dynamic>;
using ExactRows = Eigen::Matrix<Exact, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A space of rows, by an orthonormal basis that grows.
class RowSpace {
 public:
  /// Rows count as members that are nearer to the space than `tolerance`.
  explicit RowSpace(const Exact& tolerance) : tolerance_(tolerance) {}

  /// Adds a row to the basis, and returns whether it was no member.
  bool add(const ExactRow& row);
  [[nodiscard]] const std::vector<ExactRow>& basis() const { return basis_; }

 private:
  Exact tolerance_;
  std::vector<ExactRow> basis_;
};

/// Rows reduced so that each has a column in which all other rows are zero, and it is one.
struct ReducedRows {
  std::vector<int> pivots;  ///< that column of each row
  ExactRows rows;
};

/// Gauss-Jordan elimination. Of the columns whose remaining part is not much smaller than the
/// largest, the next pivot is the first in the order `preferred`. What remains at the end is at
/// most `tolerance`.
ReducedRows reduce(ExactRows rows, const std::vector<int>& preferred, const Exact& tolerance);

}  // namespace treeline
