#pragma once

#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// The body of a function whose straight lines end with a solve for all columns, see `ColumnSolve`:
/// tables of the tree and locals before the lines, the call behind them. Bodies of other functions
/// are their lines.
std::string add_column_solve(const EmissionContext& context, const Program& program,
                             const std::string& lines);

/// The line that includes the header of the solve; empty for other functions.
std::string print_column_include(const EmissionContext& context, const Program& program);

/// The headers that the solves need, and whether a function has one.
std::vector<GeneratedFile> print_column_headers(const Contents& contents);
bool wants_columns(const Contents& contents);

}  // namespace treeline
