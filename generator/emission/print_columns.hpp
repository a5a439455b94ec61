#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

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

/// The headers that a solve of these functions needs.
std::vector<GeneratedFile> print_column_headers(const EmissionContext& context,
                                                std::span<const Program> programs);

}  // namespace treeline
