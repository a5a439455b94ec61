#include "program/column_solve.hpp"

#include "core/emitted_columns.hpp"

namespace treeline {

std::size_t ColumnSolve::count_work() const {
  return static_cast<std::size_t>(velocities) *
         static_cast<std::size_t>(core::column_stride(velocities));
}

bool is_for_columns(const Result& result) {
  return result.argument.name == kColumnFactors || result.argument.name == kColumnPivots;
}

const Program& printed_lines(const Program& program) {
  return program.columns ? program.columns->lines : program;
}

}  // namespace treeline
