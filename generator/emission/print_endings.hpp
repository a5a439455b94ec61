#pragma once

#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// The body of a function whose straight lines end with a routine, see `Ending`: tables and locals
/// before the lines, the call behind them. Bodies of other functions are their lines.
std::string add_ending(const EmissionContext& context, const Program& program,
                       const std::string& lines);

/// The line that includes the header of the routine; empty for other functions.
std::string print_ending_include(const EmissionContext& context, const Program& program);

/// The headers that the routines need, and whether a function has one.
std::vector<GeneratedFile> print_ending_headers(const Contents& contents);
bool wants_endings(const Contents& contents);

}  // namespace treeline
