#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Rows that are subtracted from each row: see `TlRowSums` of `runtime/emitted/solve_columns.h`.
struct RowSums {
  std::vector<std::int16_t> ends, entries;
};

/// How a function is emitted that ends with a solve for all columns of its results: straight lines,
/// then a call of what `runtime/emitted/solve_columns.h` has. The program's graph has the
/// operations of both.
struct ColumnSolve {
  /// The straight lines. Their results are the matrices to solve for, and the arrays `L` and
  /// `inverse_D`, which only the solve reads.
  Program lines;
  std::vector<Argument> results;  ///< of the function
  RowSums above, below;
  int velocities = 0;
  int adds = 0, muls = 0;  ///< that the solve executes, those with zeros too

  /// Numbers of its work space.
  [[nodiscard]] std::size_t count_work() const;
};

/// Names of the arrays that only the solve reads.
inline constexpr const char* kColumnFactors = "L";
inline constexpr const char* kColumnPivots = "inverse_D";

/// Whether a result of the lines is one of these arrays.
bool is_for_columns(const Result& result);

/// What is printed as straight lines of a program: itself, or what stands before its solve.
const Program& printed_lines(const Program& program);

}  // namespace treeline
