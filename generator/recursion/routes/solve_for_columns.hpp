#pragma once

#include "program/column_solve.hpp"

namespace treeline {

/// The function whose straight lines end with this solve: its graph is that of the lines and the
/// operations of the solve as they are written, which emitted code executes.
Program solve_for_columns(ColumnSolve columns);

/// `change` of the straight lines of a program, which are all of it if no solve follows.
template <class Change>
Program change_lines(Program program, const Change& change) {
  if (!program.columns) return change(std::move(program));
  ColumnSolve columns = *program.columns;
  columns.lines = change(std::move(columns.lines));
  return solve_for_columns(std::move(columns));
}

}  // namespace treeline
