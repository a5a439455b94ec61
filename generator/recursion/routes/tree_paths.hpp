#pragma once

#include <functional>
#include <vector>

#include "program/ending.hpp"

namespace treeline {

/// Which freedoms carry which, as `TlTree` of `runtime/emitted/solve_columns.h` has it.
class TreePaths {
 public:
  /// Paths of so many freedoms. `relates(k, i)` with i < k says whether L of M = L^T D L has an
  /// entry there.
  TreePaths(int velocities, const std::function<bool(int k, int i)>& relates);

  /// The freedoms that carry one, from the first on. Its factors in L have this order.
  [[nodiscard]] std::vector<int> path_of(int freedom) const;

  /// Length of rows of L: the longest path, with the freedom itself, as a multiple of eight.
  [[nodiscard]] int row_length() const;

  /// Appends the lists of `TlTree`. `has_entry(i, j)` says where matrices have entries that are
  /// solved for.
  void append_to(std::vector<Table>& tables,
                 const std::function<bool(int i, int j)>& has_entry) const;

  /// Appends the lists of `TlPaths`, see `runtime/emitted/acceleration_derivatives.h`.
  void append_paths_to(std::vector<Table>& tables) const;

 private:
  [[nodiscard]] bool is_contiguous() const;
  [[nodiscard]] int beyond(int freedom) const;

  std::vector<int> parents_;
};

}  // namespace treeline
