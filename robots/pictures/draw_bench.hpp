#pragma once

#include <string>
#include <vector>

#include "read_bench.hpp"

namespace treeline::pictures {

/// Draws time against error for some functions of a report as a stand-alone SVG 1.1 file, with one
/// panel per function: the generated code, the interpreter and the other libraries, all in double
/// precision. Both axes are logarithmic; the lower left is best. Empty, with the reason in `error`,
/// if a function is not in the report.
std::string draw_bench(const BenchReport& report, const std::vector<std::string>& functions,
                       std::string& error);

}  // namespace treeline::pictures
