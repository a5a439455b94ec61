#pragma once

#include <string>

#include "bench/bench_report.hpp"

namespace treeline {

/// Draws time to the right and largest norm-wise error upward, both logarithmic, with a panel for
/// each function and its front. Returns a stand-alone SVG file.
std::string draw_svg(const BenchReport& report);

}  // namespace treeline
