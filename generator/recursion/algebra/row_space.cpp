#include "recursion/algebra/row_space.hpp"

#include <utility>

namespace treeline {
namespace {

/// A column may be a pivot if its remaining part is at least this share of the largest.
constexpr double kPivotShare = 0.1;

/// Largest entry of a column in the rows from `first` on: its row.
Eigen::Index largest_entry(const Digits50Rows& rows, Eigen::Index first, Eigen::Index column) {
  Eigen::Index largest = first;
  for (Eigen::Index i = first + 1; i < rows.rows(); ++i) {
    if (abs(rows(i, column)) > abs(rows(largest, column))) largest = i;
  }
  return largest;
}

/// The place of the next pivot; row -1 if nothing remains.
std::pair<Eigen::Index, int> find_pivot(const Digits50Rows& rows, Eigen::Index first,
                                        const std::vector<int>& preferred,
                                        const Digits50& tolerance) {
  std::vector<std::pair<Eigen::Index, Digits50>> largest;
  Digits50 most = 0;
  for (const int column : preferred) {
    const Eigen::Index row = largest_entry(rows, first, column);
    largest.emplace_back(row, abs(rows(row, column)));
    if (largest.back().second > most) most = largest.back().second;
  }
  if (most <= tolerance) return {-1, -1};
  std::size_t k = 0;
  while (largest[k].second < Digits50(kPivotShare) * most) ++k;
  return {largest[k].first, preferred[k]};
}

}  // namespace

bool RowSpace::add(const Digits50Row& row) {
  Digits50Row rest = row;
  for (int round = 0; round < 2; ++round) {  // the second removes what the first left of rounding
    for (const Digits50Row& each : basis_) rest -= each * rest.dot(each);
  }
  const Digits50 length = sqrt(Digits50(rest.squaredNorm()));
  if (length <= tolerance_) return false;
  basis_.push_back(rest / length);
  return true;
}

ReducedRows reduce(Digits50Rows rows, const std::vector<int>& preferred,
                   const Digits50& tolerance) {
  ReducedRows reduced;
  Eigen::Index rank = 0;
  while (rank < rows.rows()) {
    const auto [row, column] = find_pivot(rows, rank, preferred, tolerance);
    if (row < 0) break;
    rows.row(rank).swap(rows.row(row));
    const Digits50 pivot = rows(rank, column);
    rows.row(rank) /= pivot;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const Digits50 factor = rows(i, column);
      if (i != rank && factor != 0) rows.row(i) -= rows.row(rank) * factor;
    }
    reduced.pivots.push_back(column);
    ++rank;
  }
  reduced.rows = rows.topRows(rank);
  return reduced;
}

}  // namespace treeline
