#pragma once

#include <string>
#include <vector>

#include "machine.hpp"
#include "rows.hpp"

namespace treeline::bench {

/// The table: for each robot and function what was measured of all implementations. The times are
/// medians, or, for a machine that is not quiet, the least of all repetitions.
std::string print_table(const std::vector<Row>& rows, const Machine& machine, bool least);

/// One JSON object a line for each row.
std::string print_json_lines(const std::vector<Row>& rows, const Machine& machine);

/// An SVG: nanoseconds a state, warm, on a logarithmic axis, a line for each function of each robot
/// with a dot for each family of implementations: the fastest of it.
std::string draw_plot(const std::vector<Row>& rows, const Machine& machine, bool least);

}  // namespace treeline::bench
