#pragma once

#include <string>
#include <vector>

#include "machine.hpp"
#include "rows.hpp"

namespace treeline::bench {

/// Prints the table with the measurements of all implementations, for each robot and function.
/// Times are medians or, with `least` for machines that are not quiet, the least of all
/// repetitions.
std::string print_table(const std::vector<Row>& rows, const Machine& machine, bool least);

/// Prints one JSON object per line for each row.
std::string print_json_lines(const std::vector<Row>& rows, const Machine& machine);

/// Draws an SVG: nanoseconds per state, warm, on a logarithmic axis. Each function of each robot
/// has a line with a dot for the fastest implementation of each family.
std::string draw_plot(const std::vector<Row>& rows, const Machine& machine, bool least);

}  // namespace treeline::bench
