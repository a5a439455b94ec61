#pragma once

#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// A function whose straight lines end with a solve for all columns, see `ColumnSolve`: what stands
/// before and behind the lines in its body. Both are empty for other functions.
struct ColumnText {
  std::string arrays;  ///< tables of the tree, and locals that the lines write
  std::string call;
};
ColumnText print_columns(const EmissionContext& context, const Program& program);

/// The lines of a body between what the solve asks for.
std::string join(const ColumnText& columns, const std::string& lines);

/// The line that includes the header of the solve; empty for other functions.
std::string print_column_include(const EmissionContext& context, const Program& program);

/// The headers that the solves need, and whether a function has one.
std::vector<GeneratedFile> print_column_headers(const Contents& contents);
bool wants_columns(const Contents& contents);

}  // namespace treeline
